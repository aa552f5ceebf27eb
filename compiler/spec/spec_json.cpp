#include <cmath>

#include "compiler/spec/spec.h"

namespace compiler {
namespace {

Json Numbers(const std::vector<double>& values) {
  Json numbers = Json::array();
  for (const double value : values) numbers.push_back(std::isfinite(value) ? Json(value) : Json());
  return numbers;
}

Json ToJson(const CheckedSensor& sensor) {
  Json json = {{"name", sensor.name},
               {"type", ToString(sensor.type)},
               {"unit", ToString(sensor.unit)},
               {"doc", sensor.doc},
               {"constant", !sensor.constant.empty()}};
  if (!sensor.constant.empty()) {
    json["values"] = Numbers(sensor.constant);
    return json;
  }
  json["onboard"] = sensor.is_onboard;
  json["least"] = Numbers(sensor.minimum);
  json["greatest"] = Numbers(sensor.maximum);
  return json;
}

Json ToJson(const Enumeration& parts) {
  Json json = {{"type", parts.name}, {"all", parts.all}, {"members", parts.members}};
  Json& sets = json["sets"] = Json::object();
  for (const robot::Group& group : parts.groups) {
    sets[group.name] = Json::array();
    for (const int member : group.members)
      sets[group.name].push_back(parts.members[static_cast<size_t>(member)]);
  }
  return json;
}

Json ToJson(const robot::RobotDescription& robot) {
  Json json = {{"name", robot.name},
               {"doc", robot.doc},
               {"time_step", robot.controller.time_step},
               {"poses", Json::array()}};
  for (const robot::Pose& pose : robot.poses) json["poses"].push_back(pose.name);
  return json;
}

Json ToJson(const SpecWords& words) {
  Json list = Json::array();
  for (const SpecWord& word : words.words) list.push_back({{"word", word.word}, {"doc", word.doc}});
  return list;
}

}  // namespace

Json ToJson(const Spec& spec) {
  Json json = {{"format", 1},
               {"taskc", TASKC_VERSION},
               {"robot", spec.robot ? ToJson(*spec.robot) : Json()}};
  for (const char* list : {"parts", "sensors", "functions", "units"}) json[list] = Json::array();
  for (const Enumeration& parts : spec.enumerations) json["parts"].push_back(ToJson(parts));
  for (const CheckedSensor& sensor : spec.sensors) json["sensors"].push_back(ToJson(sensor));
  for (const SpecFunction& function : spec.functions) {
    json["functions"].push_back({{"name", function.name},
                                 {"kind", function.kind},
                                 {"usages", function.usages},
                                 {"doc", function.doc}});
  }
  for (const SpecUnit& unit : spec.units)
    json["units"].push_back({{"name", unit.name}, {"factor", unit.factor}, {"si", unit.si}});
  for (const SpecWords& words : spec.words) json["words"][words.what] = ToJson(words);
  for (const char* list : {"libraries", "grammar", "examples"}) json[list] = Json::array();
  for (const SpecLibrary& library : spec.libraries)
    json["libraries"].push_back({{"name", library.name}, {"doc", library.doc}});
  for (const GrammarRule& rule : spec.grammar) {
    json["grammar"].push_back({{"rule", rule.name},
                               {"definition", rule.definition},
                               {"token", rule.is_token},
                               {"comment", rule.comment}});
  }
  for (const SpecExample& example : spec.examples) {
    json["examples"].push_back({{"name", example.name},
                                {"robot", example.robot.empty() ? Json() : Json(example.robot)},
                                {"text", example.text}});
  }
  return json;
}

}  // namespace compiler
