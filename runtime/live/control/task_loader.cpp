#include "runtime/live/control/task_loader.h"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "base/variant/overloaded.h"
#include "runtime/base/build_task.h"
#include "runtime/base/program_starter.h"
#include "runtime/core/task/plugin_watch.h"
#include "runtime/training/run/recorded_sources.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

constexpr const char* kTrainerHasEnded = "the trainer has ended";

// The code of a shared object runs already while it is loaded.
std::shared_ptr<const Plugin> LoadWatched(const std::filesystem::path& file,
                                          const std::filesystem::path& name) {
  struct Watched {
    Watched() { ThePluginWatch().loading_thread = gettid(); }
    ~Watched() {
      ThePluginWatch().loading_thread = 0;
      ++ThePluginWatch().loads;
    }
  } const watched;
  return std::make_shared<const Plugin>(file, name);
}

std::string WithoutEnd(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

TaskLoader::TaskLoader(std::filesystem::path run_folder, const RunRecord& run)
    : run_folder_(std::move(run_folder)) {
  WriteRobot(run, scratch_.path());
  thread_ = std::thread([this] { Run(); });
}

TaskLoader::~TaskLoader() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
    changed_.notify_one();
  }
  stop_.request_stop();
  thread_.join();
  for (const Job& job : jobs_) Refuse(job, kTrainerHasEnded);
}

void TaskLoader::Load(std::filesystem::path file, Handler handler,
                      std::optional<std::string> text) {
  Add({std::move(file), std::move(text), std::move(handler)});
}

void TaskLoader::BuildOnly(std::filesystem::path file, BuiltHandler handler,
                           std::optional<std::string> text) {
  Add({std::move(file), std::move(text), std::move(handler)});
}

void TaskLoader::Add(Job job) {
  const std::lock_guard lock(mutex_);
  jobs_.push_back(std::move(job));
  changed_.notify_one();
}

void TaskLoader::Run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_ending_ || !jobs_.empty(); });
    if (is_ending_) return;
    const Job job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    Do(job);
    lock.lock();
  }
}

void TaskLoader::Do(const Job& job) {
  BuiltPlugin built;
  try {
    built = Build(job);
  } catch (const std::exception& error) {
    return Refuse(job, error.what());
  }
  if (built.plugin.empty()) return Refuse(job, built.messages);
  std::visit(variant::Overloaded{
                 [&](const BuiltHandler& handler) { handler(built); },
                 [&](const Handler& handler) { handler(Load(job, built)); },
             },
             job.handler);
}

void TaskLoader::Refuse(const Job& job, const std::string& why) {
  std::visit(variant::Overloaded{
                 [&](const BuiltHandler& handler) {
                   handler({"", why});
                 },
                 [&](const Handler& handler) {
                   handler({nullptr, "", why});
                 },
             },
             job.handler);
}

BuiltPlugin TaskLoader::Build(const Job& job) {
  const bool is_source = job.file.extension() == ".task";
  if (job.text && !is_source) {
    throw UserError(fmt::format("{}: a text is that of a .task file", job.file.string()));
  }
  if (!job.text && !std::filesystem::exists(job.file)) {
    throw UserError(fmt::format("{}: there is no such file", job.file.string()));
  }
  if (!is_source) return {BroughtIn(job.file), ""};
  const std::filesystem::path plugin = scratch_.path() / "task.so";
  TaskBuild build{.task = job.file, .plugin = plugin, .robots = scratch_.path()};
  if (job.text) {
    build.text = scratch_.path() / "task.text";
    WriteFile(build.text, *job.text);
  }
  std::string messages;
  if (BuildTask(build, &messages, stop_.get_token())) return {plugin, WithoutEnd(messages)};
  return {"", stop_.stop_requested() ? kTrainerHasEnded : WithoutEnd(messages)};
}

LoadedTask TaskLoader::Load(const Job& job, BuiltPlugin built) {
  try {
    LoadedTask task = Keep(built.plugin, job.file);
    task.messages = std::move(built.messages);
    return task;
  } catch (const std::exception& error) {
    return {nullptr, "", error.what()};
  }
}

// In the sandbox, what lies outside is copied to where it can be read.
std::filesystem::path TaskLoader::BroughtIn(const std::filesystem::path& plugin) const {
  const bool is_outside = AreProgramsStartedOutside() && std::filesystem::is_regular_file(plugin);
  if (!is_outside) return plugin;  // whoever loads it says what is wrong with it
  std::filesystem::path copy = scratch_.path() / "outside.so";
  CopyPluginFromOutside(plugin, copy);
  return copy;
}

// Loaded before it is kept, so that nothing is kept that cannot be loaded; and kept as it was
// loaded, even where the file has changed meanwhile: what runs is what the record has.
LoadedTask TaskLoader::Keep(const std::filesystem::path& plugin,
                            const std::filesystem::path& name) {
  LoadedTask task;
  task.plugin = LoadWatched(plugin, name);
  task.kept = KeepPlugin(task.plugin->copy(), run_folder_);
  return task;
}

}  // namespace runtime
