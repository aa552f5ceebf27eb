// taskc fault FILE.task SITUATION.json
#include <fmt/format.h>

#include <limits>
#include <memory>

#include "base/file/read.h"
#include "compiler/driver/verb.h"
#include "compiler/task_tests/find_fault.h"

namespace compiler {
namespace {

struct FaultOptions {
  std::string task;
  std::filesystem::path situation;
};

double NumberOf(const Json& json) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return kInfinity;
  return json == "-inf" ? -kInfinity : json.get<double>();
}

std::vector<double> NumbersOf(const Json& json) {
  std::vector<double> numbers;
  for (const Json& each : json) numbers.push_back(NumberOf(each));
  return numbers;
}

std::vector<std::vector<double>> ListsOf(const Json& json) {
  std::vector<std::vector<double>> lists;
  for (const Json& each : json) lists.push_back(NumbersOf(each));
  return lists;
}

// One of the numbers from 0 on that `Kind` has, up to `last`.
template <class Kind>
Kind KindOf(const Json& json, Kind last) {
  const auto number = json.get<int>();
  if (number >= 0 && number <= static_cast<int>(last)) return static_cast<Kind>(number);
  throw CallError("the situation names an event, or an end, that there is not");
}

FaultySituation ReadSituation(const std::filesystem::path& file) {
  const file::Reading reading = file::Read(file);
  if (!reading.problem.empty()) {
    throw CallError(fmt::format("cannot read `{}`: {}", file.string(), reading.problem));
  }
  try {
    const Json json = Json::parse(reading.bytes);
    return {KindOf(json.at("event"), EventKind::kEndOfPhysicsStep),
            json.at("term").get<uint32_t>(),
            NumberOf(json.at("time_step")),
            json.at("seed").get<uint64_t>(),
            NumberOf(json.at("discount")),
            KindOf(json.at("outcome"), EndKind::kTruncated),
            NumbersOf(json.at("params")),
            ListsOf(json.at("sensors")),
            ListsOf(json.at("memory"))};
  } catch (const Json::exception& error) {
    throw CallError(fmt::format("`{}` holds no situation: {}", file.string(), error.what()));
  }
}

Json ToJson(const ValueOfPart& part, const Sources& sources) {
  const Position position = sources.PositionOf(part.span);
  return {{"text", sources.FileOf(part.span).TextOf(part.span)},
          {"source", sources.IndexOf(part.span)},
          {"line", position.line},
          {"column", position.column},
          {"value", part.value}};
}

std::string FaultText(const FoundFault& fault, const Sources& sources) {
  const auto written = [&](const ValueOfPart& part) {
    return fmt::format("`{}` is {}", sources.FileOf(part.span).TextOf(part.span), part.value);
  };
  const Position position = sources.PositionOf(fault.part.span);
  std::string text = fmt::format("{}:{}:{}: {}\n", sources.FileOf(fault.part.span).path(),
                                 position.line, position.column, written(fault.part));
  for (const ValueOfPart& operand : fault.operands) text += "  " + written(operand) + "\n";
  return text;
}

ExitStatus Show(const FaultOptions& options, Session& session) {
  const FaultySituation situation = ReadSituation(options.situation);
  const Analysis analysis = session.Analyze(options.task);
  if (!analysis.task) return ExitStatus::kWrongTask;
  const std::optional<FoundFault> fault = FindFault(*analysis.task, situation);
  if (!fault) {
    session.Say("in this situation the term is paid\n");
    return ExitStatus::kWrongTask;
  }
  session.Say(FaultText(*fault, analysis.sources));
  Json json = ToJson(fault->part, analysis.sources);
  json["operands"] = Json::array();
  for (const ValueOfPart& operand : fault->operands) {
    json["operands"].push_back(ToJson(operand, analysis.sources));
  }
  session.Result()["fault"] = std::move(json);
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareFault(Command& command, Session& session) {
  auto options = std::make_shared<FaultOptions>();
  AddTask(command, options->task);
  command
      .AddOption("SITUATION.json", options->situation,
                 "what the task read and remembered, as the trainer writes it")
      .Required()
      .ValueName("");
  AddRobots(command, session);
  AddReport(command, session);
  return [options](Session& call) { return Show(*options, call); };
}

}  // namespace compiler
