#include "runtime/live/control/change.h"

#include <fmt/format.h>

#include "runtime/core/task/plugin_watch.h"
#include "runtime/live/control/parameter_json.h"
#include "runtime/training/run/record_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

// "forget" and the like, behind the rest.
std::string Flags(const Change& change) {
  return change.flag("forget") ? ", what was learned is forgotten" : "";
}

}  // namespace

std::string Change::Description(const RunRecord& run) const {
  const std::string command = kind();
  if (command == "swap" || command == "load" || command == "rollback") {
    return fmt::format("{} {}: {}{}", command, text("name"), VersionText(TaskWithId(run, task())),
                       Flags(*this));
  }
  if (command == "promote") return fmt::format("promote {}{}", text("name"), Flags(*this));
  if (command == "set" && data_.contains("value")) {
    return fmt::format("{} = {}", text("name"), data_.at("value").dump());
  }
  if (command == "set") {
    return fmt::format("{}: {} to {} over {} episodes", text("name"), data_.at("from").dump(),
                       data_.at("to").dump(), data_.at("episodes").dump());
  }
  if (command == "connect" || command == "disconnect") {
    return fmt::format("{} {} {}", command, text("first"), text("second"));
  }
  if (command == "module_add") {
    return fmt::format("add module {} {}", text("type"), text("name"));
  }
  if (command == "module_remove") return fmt::format("remove module {}", text("name"));
  return fmt::format("{} {}", command, text("name"));
}

ChangeMaker::ChangeMaker(LiveGraph& graph, Schedules& schedules, const RunRecord& run,
                         std::filesystem::path folder)
    : graph_(graph), schedules_(schedules), run_(run), folder_(std::move(folder)) {}

void ChangeMaker::Do(const Change& change, int64_t episode) {
  const std::string kind = change.kind();
  if (kind == "swap") return Swap(change);
  if (kind == "rollback") return Rollback(change);
  if (kind == "promote") return Promote(change);
  if (kind == "set") return Set(change, episode);
  if (kind == "module_add") return AddModule(change);
  if (kind == "load") {
    graph_.Load(change.text("name"), MakeInstance(change.task()));
  } else if (kind == "unload") {
    graph_.Unload(change.text("name"));
  } else if (kind == "connect") {
    graph_.Connect(change.text("first"), change.text("second"));
  } else if (kind == "disconnect") {
    graph_.Disconnect(change.text("first"), change.text("second"));
  } else if (kind == "module_remove") {
    graph_.RemoveModule(change.text("name"));
  } else {
    throw UserError(fmt::format("this version of the trainer knows no change `{}`", kind));
  }
}

std::unique_ptr<TaskInstance> ChangeMaker::MakeInstance(int64_t task) const {
  const TaskRecord& record = TaskWithId(run_, task);
  return std::make_unique<TaskInstance>(LoadKept(record), task);
}

// It could be loaded when it was kept.
std::shared_ptr<const Plugin> ChangeMaker::LoadKept(const TaskRecord& task) const {
  const std::filesystem::path file = FindKeptPlugin(folder_, task.plugin);
  const InsideOfTask watched(task.id);  // its code runs already while it is loaded
  try {
    return std::make_shared<const Plugin>(file, task.task_file);
  } catch (const UserError& error) {
    throw RecordError(error.what());
  }
}

// The task that is there already stays, with its previous one: only what was learned from it may be
// forgotten.
void ChangeMaker::Swap(const Change& change) {
  const UniversalTask& task = graph_.FindTask(change.text("name"));
  const bool is_there = task.instance().id() == change.task();
  if (is_there && !change.flag("forget")) return;
  if (!is_there) graph_.Swap(task.name(), MakeInstance(change.task()));
  SettleLearner(change, task);
}

// Back to the very task that was the previous one then: where a swap is left out, there may be
// nothing to do.
void ChangeMaker::Rollback(const Change& change) {
  const UniversalTask& task = graph_.FindTask(change.text("name"));
  if (task.instance().id() == change.task()) return;
  if (task.previous() == nullptr || task.previous()->id() != change.task()) return Swap(change);
  graph_.Rollback(task.name());
  SettleLearner(change, task);
}

void ChangeMaker::Promote(const Change& change) {
  graph_.Promote(change.text("name"));
  SettleLearner(change, graph_.FindTask(change.text("name")));
}

void ChangeMaker::SettleLearner(const Change& change, const UniversalTask& task) {
  if (&task != &graph_.active_task()) return;
  graph_.learner().ForgetCredit();
  if (change.flag("forget")) graph_.learner().Forget();
}

void ChangeMaker::Set(const Change& change, int64_t episode) {
  const std::string name = change.text("name");
  const Parameter& parameter = graph_.FindParameter(name);
  if (change.data().contains("value")) {
    graph_.Set(name, ValueFromJson(change.data().at("value"), parameter, name));
    schedules_.Remove(name);
    return;
  }
  schedules_.Set(name, {change.data().at("from"), change.data().at("to"), episode,
                        change.data().at("episodes")});
}

void ChangeMaker::AddModule(const Change& change) {
  std::vector<std::pair<std::string, ParameterValue>> parameters;
  const nlohmann::json& data = change.data();
  if (data.contains("parameters")) {
    // Its parameters are known only when it is made: texts stay texts.
    const Parameter any{.name = "", .doc = "", .target = static_cast<std::string*>(nullptr)};
    for (const auto& [name, value] : data.at("parameters").items()) {
      parameters.emplace_back(name, ValueFromJson(value, any, name));
    }
  }
  graph_.AddModule(change.text("type"), change.text("name"), parameters);
}

}  // namespace runtime
