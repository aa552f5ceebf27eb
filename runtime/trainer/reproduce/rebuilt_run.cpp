#include "runtime/trainer/reproduce/rebuilt_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "plugins/host/elf_file.h"
#include "runtime/base/build_task.h"
#include "runtime/base/user_error.h"
#include "runtime/core/agent/agent.h"
#include "runtime/trainer/setup/plugin_facts.h"
#include "runtime/training/run/recorded_sources.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

constexpr const char* kLibraryPath = "TASKC_LIBRARY_PATH";

// While it lives, the compiler looks for libraries in these folders first.
class LibraryFolders {
 public:
  explicit LibraryFolders(const std::vector<std::filesystem::path>& folders) {
    if (const char* path = std::getenv(kLibraryPath)) before_ = path;
    std::string path;
    for (const std::filesystem::path& folder : folders) path += folder.string() + ":";
    setenv(kLibraryPath, (path + before_.value_or("")).c_str(), 1);
  }
  LibraryFolders(const LibraryFolders&) = delete;
  LibraryFolders& operator=(const LibraryFolders&) = delete;
  ~LibraryFolders() {
    if (before_) {
      setenv(kLibraryPath, before_->c_str(), 1);
    } else {
      unsetenv(kLibraryPath);
    }
  }

 private:
  std::optional<std::string> before_;
};

std::string CompilerText(const TaskRecord& task, const std::filesystem::path& plugin) {
  std::error_code ignored;
  if (!std::filesystem::exists(plugin, ignored)) return task.compiler;
  const std::string bytes = ReadText(plugin);
  const std::string compiler = host::ElfCompiler(std::as_bytes(std::span(bytes)));
  return compiler.empty() ? task.compiler : fmt::format("{}, {}", task.compiler, compiler);
}

std::set<int64_t> TasksOf(const std::vector<ChangeRecord>& changes) {
  std::set<int64_t> tasks = {1};  // the one that the run began with
  const std::vector<ChangeRecord> taken_back = TakenBack(changes);
  for (const ChangeRecord& change : changes) {
    const auto brought = TaskBroughtBy(change.change);
    const bool is_done =
        std::ranges::find(taken_back, change.id, &ChangeRecord::id) == taken_back.end();
    if (brought && is_done) tasks.insert(brought->task);
  }
  return tasks;
}

[[noreturn]] void FailToBuild(const TaskRecord& task, std::string_view why) {
  throw UserError(
      fmt::format("the task {} cannot be built from its text in the record: {}; "
                  "`--kept-plugins` takes the plugins that the run's folder has kept",
                  VersionText(task), why));
}

// With ids of their own, which count from 1 without a gap.
void AddChanges(const std::vector<ChangeRecord>& changes, RunDatabase& database) {
  std::map<int64_t, int64_t> ids;  // from the old to the new ones
  for (ChangeRecord change : changes) {
    auto* quarantine = std::get_if<PutInQuarantine>(&change.change);
    if (quarantine != nullptr && quarantine->change) {
      const auto found = ids.find(*quarantine->change);
      if (found != ids.end()) quarantine->change = found->second;
    }
    ids[change.id] = database.AddChange(change);
  }
}

// A plugin, and what it says of itself.
struct RestoredPlugin {
  std::filesystem::path file;
  PluginFacts facts;
};

// The text in the record, built again.
RestoredPlugin Build(const TaskRecord& task, const std::filesystem::path& robots,
                     const std::filesystem::path& folder) {
  const RecordedSources sources = WriteSources(task.sources, folder / "sources");
  const LibraryFolders libraries(sources.folders);
  const std::filesystem::path plugin = folder / "task.so";
  std::string messages;
  if (!BuildTask({.task = sources.task, .plugin = plugin, .robots = robots}, &messages))
    FailToBuild(task, messages);
  const PluginFacts facts = ReadPluginFacts(plugin);
  if (facts.source_hash != task.task_hash) {
    FailToBuild(task, fmt::format("it is of another version, {:.8}", facts.source_hash));
  }
  return {plugin, facts};
}

RestoredPlugin KeptOne(const TaskRecord& task, const std::filesystem::path& folder) {
  const std::filesystem::path plugin = FindKeptPlugin(folder, task.plugin);
  return {plugin, ReadPluginFacts(plugin)};
}

}  // namespace

std::vector<ChangeRecord> TakenBack(const std::vector<ChangeRecord>& changes) {
  std::set<int64_t> tasks;
  std::set<int64_t> ids;
  for (const ChangeRecord& change : changes) {
    const auto* quarantine = std::get_if<PutInQuarantine>(&change.change);
    if (quarantine == nullptr) continue;
    if (quarantine->task) tasks.insert(*quarantine->task);
    if (quarantine->change) ids.insert(*quarantine->change);
  }
  std::vector<ChangeRecord> taken_back;
  std::ranges::copy_if(changes, std::back_inserter(taken_back), [&](const ChangeRecord& change) {
    const auto brought = TaskBroughtBy(change.change);
    return ids.contains(change.id) || (brought && tasks.contains(brought->task));
  });
  return taken_back;
}

RebuiltRun Rebuild(const std::filesystem::path& old_folder, const RunRecord& run,
                   const std::vector<ChangeRecord>& changes, Plugins plugins,
                   const std::filesystem::path& folder) {
  RebuiltRun rebuilt{run, {}};
  const std::filesystem::path robots = WriteRobot(run, folder / "robots");
  for (const int64_t id : TasksOf(changes)) {
    const TaskRecord& old = TaskWithId(run, id);
    TaskRecord& task = rebuilt.run.tasks[static_cast<size_t>(id - 1)];
    const RestoredPlugin plugin = plugins == Plugins::kKept
                                      ? KeptOne(old, old_folder)
                                      : Build(old, robots, folder / fmt::format("task{}", id));
    task.plugin = KeepPlugin(plugin.file, folder);
    task.compiler = plugin.facts.compiler;
    rebuilt.compilers.push_back(
        {id, CompilerText(old, old_folder / old.plugin), CompilerText(task, folder / task.plugin)});
  }
  for (const LibrarySetting& library : ParseAgent(run.agent, "agent").libraries) {
    KeepPlugin(FindKeptPlugin(old_folder, library.file), folder);
  }
  RunDatabase database = RunDatabase::Create(folder, rebuilt.run);
  AddChanges(changes, database);
  return rebuilt;
}

}  // namespace runtime
