// taskc diff FIRST.task SECOND.task
#include <fmt/format.h>

#include <memory>

#include "base/text/print.h"
#include "compiler/difference/difference.h"
#include "compiler/driver/verb.h"

namespace compiler {
namespace {

struct DiffOptions {
  std::string first;
  std::string second;
  bool is_json = false;
};

const char* NameOf(TaskChange::Kind kind) {
  switch (kind) {
    case TaskChange::kAdded:
      return "added";
    case TaskChange::kRemoved:
      return "removed";
    case TaskChange::kRenamed:
      return "renamed";
    case TaskChange::kChanged:
      return "changed";
  }
  return "";
}

Json ToJson(const DiffOptions& options, const std::vector<TaskChange>& changes) {
  Json json = {{"format", 1},
               {"taskc", TASKC_VERSION},
               {"first", options.first},
               {"second", options.second},
               {"same", changes.empty()},
               {"changes", Json::array()}};
  for (const TaskChange& change : changes) {
    json["changes"].push_back({{"kind", NameOf(change.kind)},
                               {"part", change.part},
                               {"name", change.name},
                               {"what", change.what},
                               {"before", change.before},
                               {"after", change.after}});
  }
  return json;
}

ExitStatus Diff(const DiffOptions& options, Session& session) {
  const Analysis first = session.Analyze(options.first);
  const Analysis second = session.Analyze(options.second);
  // As `diff` does: 1 says that they differ.
  if (!first.task || !second.task) return ExitStatus::kWrongCall;
  const std::vector<TaskChange> changes = Compare(OutlineOf(first), OutlineOf(second));
  text::Print("{}", options.is_json ? ToText(ToJson(options, changes)) : ToText(changes));
  return changes.empty() ? ExitStatus::kOk : ExitStatus::kWrongTask;
}

}  // namespace

Action DeclareDiff(Command& command, Session& session) {
  auto options = std::make_shared<DiffOptions>();
  command.AddOption("FIRST.task", options->first, "a task").Required().ValueName("");
  command.AddOption("SECOND.task", options->second, "the one to compare with it")
      .Required()
      .ValueName("");
  command.AddFlag("--json", options->is_json, "print JSON");
  AddRobots(command, session);
  command.ExitStatus(
      "0 they mean the same, 1 they differ, 2 one of them has errors or the command line is wrong, "
      "3 internal error.");
  return [options](Session& call) { return Diff(*options, call); };
}

}  // namespace compiler
