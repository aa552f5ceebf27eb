#include "compiler/emit/function_emitter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/check/after_end.h"
#include "compiler/check/memory_reset.h"
#include "compiler/check/type.h"
#include "compiler/emit/lookup_tables.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

std::string ParamValue(const CheckedParam& param, uint32_t index) {
  switch (param.type.scalar) {
    case Scalar::kBool:
      return fmt::format("frame->params[{}] != 0", index);
    case Scalar::kInt:
      return fmt::format("(long long)frame->params[{}]", index);
    case Scalar::kReal:
      break;
  }
  return fmt::format("frame->params[{}]", index);
}

// The number of elements up to which operations on arrays are written out; loops beyond.
constexpr uint32_t kWrittenOut = 32;
constexpr uint32_t kWrittenOutInLongFunctions = 4;

// Scalars are passed by value, all else where it lies.
std::string ParameterText(const std::string& name, const Type& type) {
  return IsScalar(type) ? fmt::format("{} {}", CppType(type.scalar), name)
                        : fmt::format("const {}* {}", CppType(type.scalar), name);
}

}  // namespace

PluginNames::PluginNames(const CheckedTask& task) {
  for (int helper = 0; helper < kHelperCount; ++helper) {
    taken.Reserve(HelperName(static_cast<Helper>(helper)));
  }
  for (const CheckedTerm& term : task.terms) terms.push_back(taken.Add("term_" + term.name));
  for (const CheckedLogValue& log : task.logs) logs.push_back(taken.Add("log_" + log.name));
  for (const CheckedFunction& function : task.functions) {
    functions.push_back(taken.Add("fn_" + function.name));
  }
  for (const CheckedGoal& goal : task.goals) draws.push_back(taken.Add("draw_" + goal.name));
  for (const CheckedConst& constant : task.consts) {
    consts.push_back(taken.Add("const_" + constant.name));
  }
  tables = NameLookupTables(task, taken);
  UniqueNames members;
  for (const CheckedMemory& variable : task.memory) memory.push_back(members.Add(variable.name));
}

bool HasFunction(const CheckedTask& task, EventKind event) {
  if (!task.events[static_cast<size_t>(event)].body.empty()) return true;
  for (const CheckedMemory& variable : task.memory) {
    if (IsResetAt(event, variable.scope)) return true;
  }
  return false;
}

FunctionEmitter::FunctionEmitter(const CheckedTask& task, const Sources& sources,
                                 const PluginNames& names, TextWriter& writer, HelperSet& helpers)
    : task_(task), sources_(sources), names_(names), writer_(writer), helpers_(helpers) {}

void FunctionEmitter::EmitFunction(uint32_t index) {
  const CheckedFunction& function = task_.functions[index];
  const Type& type = function.value.type;
  UsedValues used;
  for (const CheckedLet& let : function.lets) used.AddStatement(let.value);
  used.Add(function.value);
  function_ = Function(names_, std::move(used));
  std::vector<std::string> parameters;
  for (uint32_t i = 0; i < function.arguments.size(); ++i) {
    const Local& argument = function.arguments[i];
    std::string name = function_.names.Add(argument.name);
    const bool is_read = function_.used.arguments.contains(i);
    parameters.push_back(MaybeUnused(is_read) + ParameterText(name, argument.type));
    function_.values.arguments.push_back(name);
  }
  // A result that is an array is written where the caller wants it.
  std::string result;
  if (!IsScalar(type)) {
    result = function_.names.Add("result");
    parameters.push_back(fmt::format("{}* {}", CppType(type.scalar), result));
  }
  BeginFunction(fmt::format("{} {}({})", result.empty() ? CppType(type.scalar) : "void",
                            names_.functions[index], fmt::join(parameters, ", ")),
                LineOf(function.span));
  SetLocals(function.locals);
  for (const CheckedLet& let : function.lets) Emit(let, LineOf(let.value.span));
  EmitResult(function.value, result);
  End();
}

void FunctionEmitter::EmitResult(const CheckedExpression& value, const std::string& array) {
  SourceLine line = LineOf(value.span);
  std::vector<std::string> lines;
  if (array.empty()) {
    lines = {fmt::format("return {};", expressions_->EmitScalar(value).text)};
  } else {
    uint32_t count = value.type.size();
    std::vector<CppText> values = expressions_->EmitElements(value, count);
    lines = ArrayAssignment(array, "=", values, AllIndices(count), function_.names);
  }
  WriteLines(expressions_->TakeParts(), line);
  WriteLines(lines, line);
}

void FunctionEmitter::EmitInitialize() {
  UsedValues used;
  for (const CheckedMemory& variable : task_.memory) used.AddReset(variable);
  Begin("initialize", FirstLineOfMemory(), std::move(used));
  for (uint32_t i = 0; i < task_.memory.size(); ++i) EmitReset(task_.memory[i], i);
  for (uint32_t i = 0; i < task_.goals.size(); ++i) {
    Emit(CheckedRedraw{i}, LineOf(task_.goals[i].span));
  }
  End();
}

void FunctionEmitter::EmitDraw(uint32_t index) {
  const CheckedGoal& goal = task_.goals[index];
  const SourceLine line = LineOf(goal.span);
  UsedValues used;
  used.Add(goal.value);
  if (goal.interval) used.Add(goal.interval->length);
  used.memory = used.frame = true;
  const bool is_random = used.draws;  // or else it follows from other goals
  Begin(names_.draws[index], line, std::move(used));
  writer_.Line(fmt::format("if ({}) return;", function_.values.memory[goal.held]), line);
  const std::string& draws = function_.values.memory[goal.draws];
  if (is_random) {
    writer_.Line(fmt::format("{} draw{{frame->seed, {}u, (taskc_uint32){}}};",
                             helpers_.Use(Helper::kDrawPlace), goal.stream, draws),
                 line);
  }
  const uint32_t size = goal.type.size();
  const std::vector<CppText> elements = expressions_->EmitElements(goal.value, size);
  WriteLines(expressions_->TakeParts(), line);
  EmitStore(goal.memory, "=", elements, AllIndices(size), line);
  if (goal.interval) {
    const CppText length = expressions_->EmitScalar(goal.interval->length);
    WriteLines(expressions_->TakeParts(), line);
    writer_.Line(fmt::format("{} = {};", function_.values.memory[goal.interval->left], length.text),
                 line);
  }
  writer_.Line(fmt::format("++{};", draws), line);
  End();
}

void FunctionEmitter::EmitDrawPlace(uint32_t stream, std::string_view count, SourceLine line) {
  writer_.Line(fmt::format("{} draw{{frame->seed, {}u, {}}};", helpers_.Use(Helper::kDrawPlace),
                           stream, count),
               line);
}

void FunctionEmitter::EmitDrawPose() {
  const SourceLine line = LineOf(task_.start.span);
  UsedValues used;
  used.frame = true;
  Begin("draw_pose", line, std::move(used));
  helpers_.Use(Helper::kRandomUnit);
  EmitDrawPlace(task_.start.stream, "0u", line);
  writer_.Line(fmt::format("frame->pose = {}(draw, 0, 0, {});", helpers_.Use(Helper::kChoose),
                           task_.start.poses.size()),
               line);
  End();
}

// With memory and goals as they are when the episode starts: what is the same then is drawn again.
void FunctionEmitter::EmitDrawStart() {
  const CheckedEvent& block = task_.start.block;
  const SourceLine line = LineOf(task_.start.span);
  UsedValues used;
  used.Add(block.body);
  for (const CheckedMemory& variable : task_.memory) {
    if (IsResetAt(EventKind::kStartOfEpisode, variable.scope)) used.AddReset(variable);
  }
  used.memory = used.frame = true;
  const bool is_random = used.draws;
  Begin("draw_start", line, std::move(used));
  function_.names.Reserve("draw");
  SetLocals(block.locals);
  for (uint32_t i = 0; i < task_.memory.size(); ++i) {
    if (IsResetAt(EventKind::kStartOfEpisode, task_.memory[i].scope)) EmitReset(task_.memory[i], i);
  }
  for (uint32_t i = 0; i < task_.goals.size(); ++i) {
    Emit(CheckedRedraw{i}, LineOf(task_.goals[i].span));
  }
  if (is_random) EmitDrawPlace(task_.start.stream, "frame->attempt", line);
  EmitBlock(block.body);
  End();
}

void FunctionEmitter::EmitEvent(EventKind kind) {
  const CheckedEvent& event = task_.events[static_cast<size_t>(kind)];
  const bool stops_after_end = StopsAfterEnd(task_, kind);
  const bool notes_end = task_.ended && CanEnd(event.body);
  UsedValues used;
  used.Add(event.body);
  used.memory |= stops_after_end || notes_end;
  for (const CheckedMemory& variable : task_.memory) {
    if (IsResetAt(kind, variable.scope)) used.AddReset(variable);
  }
  Begin(NameOf(kind, kEventNames), event.is_declared ? LineOf(event.span) : FirstLineOfMemory(),
        std::move(used));
  SetLocals(event.locals);
  if (stops_after_end) {
    writer_.Line(fmt::format("if ({}) return;", function_.values.memory[*task_.ended]),
                 LineOf(task_.memory[*task_.ended].span));
  }
  for (uint32_t i = 0; i < task_.memory.size(); ++i) {
    if (IsResetAt(kind, task_.memory[i].scope)) EmitReset(task_.memory[i], i);
  }
  EmitBlock(event.body);
  if (function_.used.reward) {
    writer_.Line("frame->reward = reward;", LineOf(event.span));
  }
  if (notes_end) {
    writer_.Line(fmt::format("if (frame->end >= 0 || frame->violation >= 0) {} = true;",
                             function_.values.memory[*task_.ended]),
                 LineOf(event.span));
  }
  End();
}

SourceLine FunctionEmitter::FirstLineOfMemory() const {
  return LineOf(task_.memory.empty() ? Span{} : task_.memory.front().span);
}

void FunctionEmitter::EmitMeasure() {
  UsedValues used;
  used.frame = true;
  for (const CheckedMetric& metric : task_.metrics) used.AddStatement(metric.value);
  Begin("measure", LineOf(task_.metrics.front().value.span), std::move(used));
  for (uint32_t i = 0; i < task_.metrics.size(); ++i) {
    SourceLine line = LineOf(task_.metrics[i].value.span);
    CppText value = expressions_->EmitScalar(task_.metrics[i].value);
    WriteLines(expressions_->TakeParts(), line);
    writer_.Line(fmt::format("frame->metrics[{}] = {};", i, value.text), line);
  }
  End();
}

void FunctionEmitter::EmitObserve() {
  UsedValues used;
  used.frame = true;
  for (const CheckedObservation& each : task_.observations) used.AddStatement(each.value);
  Begin("observe", LineOf(task_.observations.front().value.span), std::move(used));
  for (const CheckedObservation& each : task_.observations) {
    const SourceLine line = LineOf(each.value.span);
    std::vector<uint32_t> places = AllIndices(each.value.type.size());
    for (uint32_t& place : places) place += each.offset;
    const std::vector<CppText> values =
        expressions_->EmitElements(each.value, each.value.type.size());
    WriteLines(expressions_->TakeParts(), line);
    WriteLines(ArrayAssignment("frame->observations", "=", values, places, function_.names), line);
  }
  End();
}

void FunctionEmitter::Begin(std::string_view name, SourceLine line, UsedValues used) {
  function_ = Function(names_, std::move(used));
  BeginFunction(fmt::format("void {}(taskc_frame*{})", name, function_.used.frame ? " frame" : ""),
                line);
  EmitPrologue(line);
}

void FunctionEmitter::BeginFunction(const std::string& head, SourceLine line) {
  writer_.LeaveSource();
  writer_.BlankLine();
  const bool is_long = function_.used.size.IsLong();
  if (is_long) writer_.Line("__attribute__((optimize(\"O0\")))  // too long to optimize");
  writer_.Line(head + " {", line);
  writer_.Indent();
  expressions_.emplace(function_.values, function_.names, helpers_,
                       is_long ? kWrittenOutInLongFunctions : kWrittenOut);
}

void FunctionEmitter::SetLocals(const std::vector<Local>& locals) {
  function_.locals = &locals;
  function_.values.locals.resize(locals.size());
}

void FunctionEmitter::EmitPrologue(SourceLine line) {
  ValueNames& values = function_.values;
  const UsedValues& used = function_.used;
  for (uint32_t i = 0; i < task_.sensors.size(); ++i) {
    values.sensors.emplace_back();
    if (!used.sensors.contains(i)) continue;
    const CheckedSensor& sensor = task_.sensors[i];
    std::string name = values.sensors.back() = function_.names.Add(sensor.name);
    std::string_view type = CppType(sensor.type.scalar);
    std::string_view format = IsScalar(sensor.type)
                                  ? "const {0} {1} = *static_cast<const {0}*>(frame->sensors[{2}]);"
                                  : "auto {1} = static_cast<const {0}*>(frame->sensors[{2}]);";
    writer_.Line(fmt::format(fmt::runtime(format), type, name, i), line);
  }
  for (uint32_t i = 0; i < task_.params.size(); ++i) {
    values.params.emplace_back();
    if (!used.params.contains(i)) continue;
    const CheckedParam& param = task_.params[i];
    std::string name = values.params.back() = function_.names.Add(param.name);
    writer_.Line(
        fmt::format("const {} {} = {};", CppType(param.type.scalar), name, ParamValue(param, i)),
        line);
  }
  for (const std::string& member : names_.memory) values.memory.push_back("memory." + member);
  if (used.memory) writer_.Line("Memory& memory = *static_cast<Memory*>(frame->memory);", line);
  if (used.reward) writer_.Line("double reward = 0;", line);
}

void FunctionEmitter::End() {
  writer_.Outdent();
  writer_.Line("}");
}

}  // namespace compiler
