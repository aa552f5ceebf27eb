#include "compiler/emit/table_emitter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <taskc/plugin.h>

#include <algorithm>
#include <string>

#include "compiler/emit/cpp_literal.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

constexpr size_t kEventCount = std::tuple_size_v<decltype(CheckedTask::events)>;
static_assert(kEventCount == TASKC_EVENT_COUNT);

// The constant of the ABI for a word of the language: "TASKC_END_OF_TIME_STEP", "TASKC_PER_ACTION".
std::string ConstantFor(std::string_view prefix, std::string_view word) {
  std::string constant(prefix);
  for (char c : word) constant += c == '_' ? c : static_cast<char>(c - 'a' + 'A');
  return constant;
}

std::string EventConstant(size_t event) { return ConstantFor("TASKC_", kEventNames[event].text); }

std::string_view ScalarConstant(Scalar scalar) {
  switch (scalar) {
    case Scalar::kBool:
      return "TASKC_BOOL";
    case Scalar::kInt:
      return "TASKC_INT";
    case Scalar::kReal:
      break;
  }
  return "TASKC_REAL";
}

std::string_view EndConstant(EndKind kind) {
  switch (kind) {
    case EndKind::kSuccess:
      return "TASKC_SUCCESS";
    case EndKind::kFailure:
      return "TASKC_FAILURE";
    case EndKind::kTruncated:
      break;
  }
  return "TASKC_TRUNCATED";
}

// "1u << TASKC_END_OF_TIME_STEP | 1u << TASKC_MEASURE"
std::string EventBits(uint32_t bits) {
  std::vector<std::string> events;
  for (size_t event = 0; event < kEventCount; ++event) {
    if ((bits >> event & 1) != 0) events.push_back(fmt::format("1u << {}", EventConstant(event)));
  }
  if ((bits >> TASKC_MEASURE & 1) != 0) events.emplace_back("1u << TASKC_MEASURE");
  if ((bits >> TASKC_OBSERVE & 1) != 0) events.emplace_back("1u << TASKC_OBSERVE");
  return events.empty() ? "0" : fmt::format("{}", fmt::join(events, " | "));
}

std::string ReductionConstant(Reduction reduction) {
  return ConstantFor("TASKC_", NameOf(reduction, kReductionNames));
}

// A `taskc_place`.
std::string PlaceText(Span span, const Sources& sources) {
  return fmt::format("{{{}, {}}}", sources.IndexOf(span), sources.LineOf(span));
}

std::string TypeFields(const Type& type) {
  return fmt::format("{}, {}, {}", ScalarConstant(type.scalar), type.rows, type.columns);
}

std::string Row(const CheckedSensor& sensor) {
  return fmt::format("{}, {}, {}, {}, {}, {}, {}, {}", StringLiteral(sensor.name),
                     StringLiteral(sensor.doc), StringLiteral(ToString(sensor.type)),
                     StringLiteral(ToString(sensor.unit)), TypeFields(sensor.type),
                     EventBits(sensor.read_by), RealLiteral(std::ranges::min(sensor.minimum)),
                     RealLiteral(std::ranges::max(sensor.maximum)));
}

std::string Row(const CheckedParam& param) {
  return fmt::format("{}, {}, {}, {}, {}, {}, {}", StringLiteral(param.name),
                     StringLiteral(param.doc), StringLiteral(ToString(param.unit)),
                     ScalarConstant(param.type.scalar), RealLiteral(param.initial),
                     RealLiteral(param.minimum), RealLiteral(param.maximum));
}

std::string Row(const CheckedObservation& observation) {
  const CheckedExpression& value = observation.value;
  return fmt::format("{}, {}, {}, {}, {}, {}, {}, {}", StringLiteral(observation.name),
                     StringLiteral(observation.doc), StringLiteral(ToString(value.type)),
                     StringLiteral(ToString(value.unit)), TypeFields(value.type),
                     observation.offset, RealLiteral(observation.minimum),
                     RealLiteral(observation.maximum));
}

std::string Row(const CheckedTerm& term, const Sources& sources) {
  return fmt::format("{}, {}, {}", StringLiteral(term.name), StringLiteral(term.doc),
                     PlaceText(term.span, sources));
}

std::string Row(const CheckedPhase& phase, const Sources& sources) {
  return fmt::format("{}, {}, {}", StringLiteral(phase.name), StringLiteral(phase.doc),
                     PlaceText(phase.span, sources));
}

std::string Row(const CheckedMetric& metric) {
  return fmt::format("{}, {}, {}, {}", StringLiteral(metric.name), StringLiteral(metric.doc),
                     StringLiteral(ToString(metric.value.unit)),
                     ReductionConstant(metric.reduction));
}

std::string Row(const CheckedLogValue& log, const Sources& sources) {
  return fmt::format("{}, {}, {}, {}, {}", StringLiteral(log.name), StringLiteral(log.doc),
                     StringLiteral(ToString(log.unit)), ReductionConstant(log.reduction),
                     PlaceText(log.span, sources));
}

std::string Row(const CheckedEndReason& end, const Sources& sources) {
  return fmt::format("{}, {}, {}", StringLiteral(end.reason), EndConstant(end.kind),
                     PlaceText(end.span, sources));
}

std::string Row(const CheckedRequirement& requirement, const Sources& sources) {
  return fmt::format("{}, {}", StringLiteral(requirement.reason),
                     PlaceText(requirement.span, sources));
}

// `row` gives the fields of an element. C++ has no empty arrays: no elements, no table.
template <class Element, class RowFunction>
void EmitTable(std::string_view type, std::string_view name, const std::vector<Element>& elements,
               RowFunction row, TextWriter& writer) {
  if (elements.empty()) return;
  writer.BlankLine();
  writer.Line(fmt::format("constexpr {} {}[] = {{", type, name));
  for (const Element& element : elements) {
    writer.Line(fmt::format("    {{{}}},", row(element)));
  }
  writer.Line("};");
}

constexpr auto kRow = [](const auto& element) { return Row(element); };

void EmitSources(const Sources& sources, TextWriter& writer) {
  writer.BlankLine();
  writer.Line("constexpr taskc_source sources_table[] = {");
  for (const SourceFile& source : sources.files()) {
    writer.Line(fmt::format("    {{{},", StringLiteral(source.path())));
    writer.Line(SplitStringLiteral(source.text(), "     ") + "},");
  }
  writer.Line("};");
}

void EmitMemoryStruct(const CheckedTask& task, const PluginNames& names, TextWriter& writer) {
  if (task.memory.empty()) return;
  writer.BlankLine();
  writer.Line("struct Memory {");
  for (size_t i = 0; i < task.memory.size(); ++i) {
    writer.Line(fmt::format("  {};", Declarator(names.memory[i], task.memory[i].type)));
  }
  writer.Line("};");
}

// Names for the indices of a table.
void EmitNumbers(const std::vector<std::string>& names, TextWriter& writer) {
  if (names.empty()) return;
  writer.BlankLine();
  writer.Line(fmt::format("enum {{ {} }};", fmt::join(names, ", ")));
}

// The fields of `taskc_plugin` for one table.
void EmitTableFields(std::string_view field, size_t count, std::vector<std::string>& pointers,
                     std::vector<std::string>& counts) {
  std::string_view singular = field.ends_with("s") ? field.substr(0, field.size() - 1) : field;
  pointers.push_back(
      fmt::format(".{} = {}", field, count == 0 ? "nullptr" : fmt::format("{}_table", field)));
  counts.push_back(fmt::format(".{}_count = {}", singular, count));
}

std::vector<std::string> TableFields(const CheckedTask& task, const Sources& sources) {
  std::vector<std::string> pointers;
  std::vector<std::string> counts;
  EmitTableFields("links", task.links.size(), pointers, counts);
  EmitTableFields("joints", task.joints.size(), pointers, counts);
  EmitTableFields("sites", task.sites.size(), pointers, counts);
  EmitTableFields("sources", sources.files().size(), pointers, counts);
  EmitTableFields("poses", task.start.poses.size(), pointers, counts);
  EmitTableFields("start_values", task.start.values.size(), pointers, counts);
  EmitTableFields("sensors", task.sensors.size(), pointers, counts);
  EmitTableFields("params", task.params.size(), pointers, counts);
  EmitTableFields("memory", task.memory.size(), pointers, counts);
  EmitTableFields("goals", task.goals.size(), pointers, counts);
  EmitTableFields("observations", task.observations.size(), pointers, counts);
  EmitTableFields("phases", task.phases.size(), pointers, counts);
  EmitTableFields("terms", task.terms.size(), pointers, counts);
  EmitTableFields("metrics", task.metrics.size(), pointers, counts);
  EmitTableFields("logs", task.logs.size(), pointers, counts);
  EmitTableFields("ends", task.ends.size(), pointers, counts);
  EmitTableFields("requirements", task.requirements.size(), pointers, counts);
  pointers.insert(pointers.end(), counts.begin(), counts.end());
  return pointers;
}

std::vector<std::string> IdentityFields(const CheckedTask& task, const Sources& sources) {
  return {".abi_version = TASKC_ABI_VERSION",
          ".struct_size = sizeof(taskc_plugin)",
          ".compiler = " + StringLiteral("taskc " TASKC_VERSION),
          ".name = " + StringLiteral(task.name),
          ".doc = " + StringLiteral(task.doc),
          ".robot = " + StringLiteral(task.robot),
          ".source_hash = " + StringLiteral(sources.Hash())};
}

// Where the phases lie.
std::vector<std::string> PhaseFields(const CheckedTask& task, const PluginNames& names) {
  const auto offset = [&](uint32_t memory) {
    return task.phases.empty()
               ? "0"
               : fmt::format("__builtin_offsetof(Memory, {})", names.memory[memory]);
  };
  return {".phase_offset = " + offset(task.phase_memory.present),
          ".phase_time_offset = " + offset(task.phase_memory.time)};
}

// The consts with a shape that the plugin's functions read.
void EmitConsts(const CheckedTask& task, const PluginNames& names, TextWriter& writer) {
  const UsedValues used = UsedBy(task);
  if (!used.consts.empty()) writer.BlankLine();
  for (const uint32_t index : used.consts) {
    const CheckedConst& constant = task.consts[index];
    std::vector<std::string> elements;
    for (const double element : constant.elements)
      elements.push_back(NumberLiteralText(element, constant.type.scalar));
    writer.Line(fmt::format("constexpr {} = {{{}}};",
                            Declarator(names.consts[index], constant.type),
                            fmt::join(elements, ", ")));
  }
}

}  // namespace

void EmitTables(const CheckedTask& task, const Sources& sources, const PluginNames& names,
                TextWriter& writer) {
  const auto row = [&](const auto& element) { return Row(element, sources); };
  EmitSources(sources, writer);
  EmitMemoryStruct(task, names, writer);
  EmitNumbers(names.terms, writer);
  EmitNumbers(names.logs, writer);
  EmitConsts(task, names, writer);
  const auto name_row = [](const std::string& name) { return StringLiteral(name); };
  EmitTable("taskc_part", "links_table", task.links, name_row, writer);
  EmitTable("taskc_part", "joints_table", task.joints, name_row, writer);
  EmitTable("taskc_part", "sites_table", task.sites, name_row, writer);
  EmitTable("taskc_pose", "poses_table", task.start.poses, name_row, writer);
  const auto value_row = [&](const CheckedStartValue& value) {
    return fmt::format("{}, {}, __builtin_offsetof(Memory, {})", StringLiteral(value.name),
                       value.minimum.size(), names.memory[value.memory]);
  };
  EmitTable("taskc_start_value", "start_values_table", task.start.values, value_row, writer);
  EmitTable("taskc_sensor", "sensors_table", task.sensors, kRow, writer);
  EmitTable("taskc_param", "params_table", task.params, kRow, writer);
  auto memory_row = [&](const CheckedMemory& memory) {
    const auto index = static_cast<size_t>(&memory - task.memory.data());
    return fmt::format("{}, {}, {}, {}, {}, __builtin_offsetof(Memory, {})",
                       StringLiteral(memory.name), StringLiteral(ToString(memory.type)),
                       StringLiteral(ToString(memory.unit)), TypeFields(memory.type),
                       ConstantFor("TASKC_PER_", NameOf(memory.scope, kScopeNames)),
                       names.memory[index]);
  };
  EmitTable("taskc_memory", "memory_table", task.memory, memory_row, writer);
  auto goal_row = [&](const CheckedGoal& goal) {
    const auto offset = [&](uint32_t memory) {
      return fmt::format("__builtin_offsetof(Memory, {})", names.memory[memory]);
    };
    return fmt::format("{}, {}, {}, {}, {}, {}, {}, {}", StringLiteral(goal.name),
                       StringLiteral(goal.doc), StringLiteral(ToString(goal.type)),
                       StringLiteral(ToString(goal.unit)), TypeFields(goal.type),
                       offset(goal.memory), offset(goal.held), offset(goal.draws));
  };
  EmitTable("taskc_goal", "goals_table", task.goals, goal_row, writer);
  EmitTable("taskc_observation", "observations_table", task.observations, kRow, writer);
  EmitTable("taskc_phase", "phases_table", task.phases, row, writer);
  EmitTable("taskc_reward_term", "terms_table", task.terms, row, writer);
  EmitTable("taskc_metric", "metrics_table", task.metrics, kRow, writer);
  EmitTable("taskc_log", "logs_table", task.logs, row, writer);
  EmitTable("taskc_end", "ends_table", task.ends, row, writer);
  EmitTable("taskc_requirement", "requirements_table", task.requirements, row, writer);
}

void EmitEntry(const CheckedTask& task, const Sources& sources, const PluginNames& names,
               TextWriter& writer) {
  std::vector<std::string> fields = IdentityFields(task, sources);
  for (std::string& field : TableFields(task, sources)) fields.push_back(std::move(field));
  fields.push_back(task.memory.empty() ? ".memory_size = 0" : ".memory_size = sizeof(Memory)");
  fields.push_back(fmt::format(".observation_size = {}", task.observation_size));
  for (std::string& field : PhaseFields(task, names)) fields.push_back(std::move(field));
  fields.emplace_back(".initialize = initialize");
  fields.emplace_back(DrawsPose(task) ? ".draw_pose = draw_pose" : ".draw_pose = nullptr");
  fields.emplace_back(DrawsStart(task) ? ".draw_start = draw_start" : ".draw_start = nullptr");
  std::vector<std::string_view> functions;
  for (size_t event = 0; event < kEventCount; ++event) {
    auto kind = static_cast<EventKind>(event);
    functions.push_back(HasFunction(task, kind) ? kEventNames[event].text : "nullptr");
  }
  fields.push_back(fmt::format(".events = {{{}}}", fmt::join(functions, ", ")));
  fields.push_back(task.metrics.empty() ? ".measure = nullptr" : ".measure = measure");
  fields.push_back(task.observations.empty() ? ".observe = nullptr" : ".observe = observe");

  writer.BlankLine();
  writer.Line("constexpr taskc_plugin plugin = {");
  for (const std::string& field : fields) writer.Line("    " + field + ",");
  writer.Line("};");
}

}  // namespace compiler
