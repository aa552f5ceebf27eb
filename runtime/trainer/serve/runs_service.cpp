#include "runtime/trainer/serve/runs_service.h"

#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/text/print.h"
#include "runtime/base/user_error.h"
#include "runtime/trainer/serve/new_runs.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

using enum ArgumentType;

constexpr ArgumentSpec kRun = {"run", kText, true, "name of the run: `crawling/seed1`"};
constexpr ArgumentSpec kOfCurve[] = {
    kRun, {"after", kText, false, "only of the episodes after this one"}};
constexpr ArgumentSpec kOfStart[] = {
    {"task", kText, true, "a .task file, or a .so built by taskc"},
    {"robot", kText, false, "the robot, for a task that names none"},
    {"agent", kText, false, "one of the robot's agents, or an agent file; by default the robot's"},
    {"profile", kText, false, "how to simulate; by default as `trainer train` does"},
    {"episodes", kWhole, false, "how many episodes to train; by default 1000"},
    {"seed", kWhole, false, "random seed of the first run; by default 0"},
    {"runs", kWhole, false, "how many runs, each with its own seed; by default 1"},
    {"name", kText, false, "folder of the runs in this one; by default TASK-PROFILE"}};

std::string RunOf(const nlohmann::json& arguments) { return arguments.at("run"); }

// Of a GET all arguments are texts.
int64_t Whole(const std::string& text) {
  try {
    return std::stoll(text);
  } catch (const std::exception&) {
    throw UserError(
        fmt::format("`after` must be the number of an episode, and `{}` is none", text));
  }
}

Descriptor NewWake() {
  Descriptor wake(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (wake.is_open()) return wake;
  throw UserError(fmt::format("cannot wait for requests: {}", std::strerror(errno)));
}

}  // namespace

std::span<const CommandSpec> RunsCommands() {
  static constexpr CommandSpec kCommands[] = {
      {"runs", "all runs in the folder, and how far they are", {}, false},
      {"curve", "the returns of a run's episodes", kOfCurve, false},
      {"start", "starts runs", kOfStart, true},
      {"pause", "pauses a run after the current time step", {&kRun, 1}, true},
      {"resume", "continues a run: after a pause, or from its last checkpoint", {&kRun, 1}, true},
      {"stop", "ends a run's trainer after the current episode", {&kRun, 1}, true},
  };
  return kCommands;
}

RunsService::RunsService(const std::filesystem::path& folder, int jobs,
                         std::filesystem::path robots)
    : robots_(std::move(robots)),
      list_(folder, courier_),
      supervisor_(
          {}, [this](const RunProgress& run) { return WordsFor(run); }, jobs, *this),
      wake_(NewWake()) {}

RunsService::~RunsService() {
  std::vector<Asked> asked;
  {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    asked.swap(asked_);
  }
  for (const auto& [request, reply] : asked) reply({false, {}, "the server has ended"});
}

// On any thread.
void RunsService::Handle(Request request, ReplyHandler reply) {
  {
    const std::lock_guard lock(mutex_);
    if (!has_ended_) {
      asked_.emplace_back(std::move(request), std::move(reply));
      eventfd_write(wake_.get(), 1);
      return;
    }
  }
  reply({false, {}, "the server has ended"});
}

void RunsService::Run(const StopRequest& stop) {
  while (stop.signal() == 0 || supervisor_.has_workers()) {
    supervisor_.Turn(stop, wake_.get());
    eventfd_t ignored = 0;
    eventfd_read(wake_.get(), &ignored);
    Serve();
  }
}

void RunsService::Serve() {
  std::vector<Asked> asked;
  {
    const std::lock_guard lock(mutex_);
    asked.swap(asked_);
  }
  for (auto& [request, reply] : asked) {
    try {
      if (request.command == "pause") {  // its trainer replies
        const std::filesystem::path run = list_.Find(RunOf(request.arguments)).folder();
        courier_.Send(run, {request.command, Json::object()}, std::move(reply));
      } else {
        reply({true, Answer(request), ""});
      }
    } catch (const std::exception& error) {
      reply({false, {}, error.what()});
    }
  }
}

nlohmann::json RunsService::Answer(const Request& request) {
  const Json& arguments = request.arguments;
  if (request.command == "runs") return List();
  if (request.command == "curve") {
    return list_.Find(RunOf(arguments)).CurveJson(Whole(arguments.value("after", "0")));
  }
  if (request.command == "start") return Start(arguments);
  if (request.command == "resume") return Continue(arguments);
  return Stop(arguments);
}

nlohmann::json RunsService::List() {
  Json list = list_.ToJson(supervisor_.runs());
  for (Json& run : list["runs"]) {
    const auto said = messages_.find(run["name"].get<std::string>());
    if (run["state"] == "failed" && said != messages_.end()) run["failure"] = said->second;
  }
  return list;
}

nlohmann::json RunsService::Start(const Json& arguments) {
  std::vector<NewRun> runs = NewRuns(arguments, list_.folder(), robots_);
  for (const NewRun& run : runs) CheckIsNotStarted(run.progress.name);
  Json names = Json::array();
  for (NewRun& run : runs) {
    names.push_back(run.progress.name);
    first_words_[run.progress.name] = std::move(run.words);
    messages_.erase(run.progress.name);
    supervisor_.Add(std::move(run.progress));
  }
  return {{"runs", std::move(names)}};
}

// What is started is no run yet.
void RunsService::CheckIsNotStarted(const std::string& name) const {
  for (const RunProgress& run : supervisor_.runs()) {
    const bool is_started =
        run.state == RunProgressState::kWaiting || run.state == RunProgressState::kRunning;
    if (run.name == name && is_started) {
      throw UserError(fmt::format("`{}` is being started already", name));
    }
  }
}

// One that stands still in its trainer is told to go on; for any other one a worker is started.
nlohmann::json RunsService::Continue(const Json& arguments) {
  const std::string name = RunOf(arguments);
  const ListedRun& run = list_.Find(name);
  if (run.is_trained()) {
    courier_.Send(run.folder(), {"resume", Json::object()}, [](const Reply&) {});
    return {{"run", name}};
  }
  RunProgress progress = ReadProgress(run.folder(), name);
  if (progress.is_over()) {
    throw UserError(fmt::format(
        "all {} episodes of `{}` are done: `trainer resume {} --episodes N` trains more",
        progress.episodes_planned, name, run.folder().string()));
  }
  progress.state = RunProgressState::kWaiting;
  messages_.erase(name);
  supervisor_.Add(std::move(progress));
  return {{"run", name}};
}

nlohmann::json RunsService::Stop(const Json& arguments) {
  const std::string name = RunOf(arguments);
  if (supervisor_.End(name)) return {{"run", name}};
  const ListedRun& run = list_.Find(name);
  if (!run.is_trained()) throw UserError(fmt::format("nobody trains `{}`", name));
  courier_.Send(run.folder(), {"stop", Json::object()}, [](const Reply&) {});
  return {{"run", name}};
}

std::vector<std::string> RunsService::WordsFor(const RunProgress& run) const {
  if (RunDatabase::Exists(run.folder))
    return {"resume", run.folder.string(), "--json", "--jobs", "1"};
  return first_words_.at(run.name);
}

// Of a run that could not even be made all that was said is of use: the compiler's messages.
void RunsService::OnMessage(const RunProgress& run, std::string_view text) {
  text::Print(stderr, "{}: {}\n", run.name, text);
  std::fflush(stderr);
  constexpr size_t kMost = 4096;
  std::string& messages = messages_[run.name];
  if (messages.size() < kMost) messages += fmt::format("{}{}", messages.empty() ? "" : "\n", text);
}

void RunsService::OnStopping(bool at_once) {
  text::Print(stderr, "{}\n",
              at_once ? "stopping at once" : "stopping after the current episodes (saving) ...");
  std::fflush(stderr);
}

}  // namespace runtime
