// The statements of a function.
#include <fmt/format.h>

#include "compiler/check/type.h"
#include "compiler/emit/function_emitter.h"
#include "compiler/emit/time_function_lines.h"
#include "compiler/syntax/words.h"

namespace compiler {

void FunctionEmitter::EmitBlock(const CheckedBlock& block) {
  const ExpressionEmitter::Places outer = expressions_->known_places();
  for (const CheckedStatement& statement : block) {
    SourceLine line = LineOf(statement.span);
    std::visit([&](const auto& node) { Emit(node, line); }, statement.node);
  }
  expressions_->set_known_places(outer);
}

void FunctionEmitter::Emit(const CheckedLet& let, SourceLine line) {
  const std::string name = function_.values.locals[let.local] =
      function_.names.Add((*function_.locals)[let.local].name);
  const Type& type = let.value.type;
  std::vector<std::string> definition;
  if (IsScalar(type)) {
    CppText value = expressions_->EmitScalar(let.value);
    definition = {fmt::format("const {} {} = {};", CppType(type.scalar), name, value.text)};
  } else {
    definition = ArrayDefinition(name, type, expressions_->EmitElements(let.value, type.size()));
  }
  definition.front().insert(0, MaybeUnused(function_.used.locals.contains(let.local)));
  WriteLines(expressions_->TakeParts(), line);
  WriteLines(definition, line);
}

void FunctionEmitter::Emit(const CheckedAssign& assign, SourceLine line) {
  const Type& type = task_.memory[assign.memory].type;
  std::vector<uint32_t> indices =
      assign.elements.empty() ? AllIndices(type.size()) : assign.elements;
  auto count = static_cast<uint32_t>(indices.size());
  // `v = v.yx`: all elements of the new value are computed from the old one.
  bool is_entangled = count > 1 && Reads(assign.value, assign.memory);
  std::vector<CppText> values = is_entangled ? expressions_->EmitElementsFirst(assign.value, count)
                                             : expressions_->EmitElements(assign.value, count);
  WriteLines(expressions_->TakeParts(), line);
  EmitStore(assign.memory, NameOf(assign.op, kAssignSymbols), values, indices, line);
}

void FunctionEmitter::Emit(const CheckedIf& node, SourceLine line) {
  int nested = 0;  // conditions that need lines before them: an `if` inside the `else`
  ExpressionEmitter::Places outer;
  for (size_t i = 0; i < node.branches.size(); ++i) {
    const CheckedIfBranch& branch = node.branches[i];
    SourceLine branch_line = i == 0 ? line : LineOf(branch.condition.span);
    std::string condition = expressions_->EmitScalar(branch.condition).text;
    std::vector<std::string> parts = expressions_->TakeParts();
    if (i == 0) outer = expressions_->known_places();
    if (i > 0 && !parts.empty()) {
      writer_.Line("} else {");
      writer_.Indent();
      ++nested;
    }
    WriteLines(parts, branch_line);
    bool continues = i > 0 && parts.empty();
    writer_.Line(fmt::format("{}if ({}) {{", continues ? "} else " : "", condition), branch_line);
    writer_.Indent();
    EmitBlock(branch.body);
    writer_.Outdent();
  }
  if (!node.otherwise.empty()) {
    writer_.Line("} else {");
    writer_.Indent();
    EmitBlock(node.otherwise);
    writer_.Outdent();
  }
  writer_.Line("}");
  for (; nested > 0; --nested) {
    writer_.Outdent();
    writer_.Line("}");
  }
  expressions_->set_known_places(std::move(outer));
}

void FunctionEmitter::Emit(const CheckedFor& loop, SourceLine line) {
  for (const CheckedPass& pass : loop.passes) {
    writer_.Line(fmt::format("{{  // {} = {}", loop.variable, pass.value), line);
    writer_.Indent();
    // Each pass is a scope of its own, and its names end with it.
    const size_t outer = function_.names.Mark();
    EmitBlock(pass.body);
    function_.names.GiveBackTo(outer);
    writer_.Outdent();
    writer_.Line("}");
  }
}

void FunctionEmitter::Emit(const CheckedReward& reward, SourceLine line) {
  CppText value = expressions_->EmitScalar(reward.value);
  WriteLines(expressions_->TakeParts(), line);
  if (reward.is_rate) {
    value = BinaryText(BinaryOperator::kMultiply, value, {"frame->time_step"});
  }
  writer_.Line(fmt::format("{}(frame, reward, {}, {});", helpers_.Use(Helper::kPay),
                           names_.terms[reward.term], value.text),
               line);
}

void FunctionEmitter::Emit(const CheckedEnd& end, SourceLine line) {
  writer_.Line(fmt::format("{}(frame, {});", helpers_.Use(Helper::kEnd), end.end), line);
}

void FunctionEmitter::Emit(const CheckedLog& log, SourceLine line) {
  CppText value = expressions_->EmitScalar(log.value);
  WriteLines(expressions_->TakeParts(), line);
  helpers_.Use(Helper::kMin);
  helpers_.Use(Helper::kMax);
  writer_.Line(fmt::format("{}(frame, {}, {});", helpers_.Use(Helper::kNote), names_.logs[log.log],
                           value.text),
               line);
}

void FunctionEmitter::Emit(const CheckedRequire& require, SourceLine line) {
  CppText condition = expressions_->EmitScalar(require.condition);
  WriteLines(expressions_->TakeParts(), line);
  writer_.Line(fmt::format("{}(frame, {}, {});", helpers_.Use(Helper::kRequire),
                           require.requirement, condition.text),
               line);
}

void FunctionEmitter::Emit(const CheckedRedraw& redraw, SourceLine line) {
  writer_.Line(fmt::format("{}(frame);", names_.draws[redraw.goal]), line);
}

void FunctionEmitter::Emit(const CheckedNext& next, SourceLine line) {
  writer_.Line(fmt::format("if ({0} < 0) {0} = {1};", function_.next_phase, next.phase), line);
}

void FunctionEmitter::Emit(const CheckedPhaseSwitch& phases, SourceLine line) {
  const std::string& present = function_.values.memory[task_.phase_memory.present];
  const std::string& next = function_.next_phase = function_.names.Add("next");
  writer_.Line(fmt::format("{} {} = -1;", CppType(Scalar::kInt), next), line);
  writer_.Line(fmt::format("switch ({}) {{", present), line);
  writer_.Indent();
  for (size_t i = 0; i < phases.blocks.size(); ++i) {
    const SourceLine name = LineOf(task_.phases[i].span);
    writer_.Line(fmt::format("case {}: {{  // {}", i, task_.phases[i].name), name);
    writer_.Indent();
    const size_t outer = function_.names.Mark();
    EmitBlock(phases.blocks[i]);
    function_.names.GiveBackTo(outer);
    writer_.Line("break;", name);
    writer_.Outdent();
    writer_.Line("}");
  }
  writer_.Outdent();
  writer_.Line("}");
  writer_.Line(fmt::format("if ({} >= 0) {{", next), line);
  writer_.Indent();
  writer_.Line(fmt::format("{} = {};", present, next), line);
  writer_.Line(fmt::format("{} = 0;", function_.values.memory[task_.phase_memory.time]), line);
  writer_.Outdent();
  writer_.Line("}");
}

void FunctionEmitter::Emit(const CheckedAdvance& advance, SourceLine line) {
  const CheckedTimeFunction& function = task_.time_functions[advance.function];
  const Type& type = advance.value.type;
  const std::vector<std::string>& memory = function_.values.memory;
  TimeFunctionNames names{.value = memory[function.value],
                          .past = memory[function.past],
                          .next = memory[function.next],
                          .now = function_.names.Add("now"),
                          .duration = ""};
  std::vector<std::string> definition;
  if (IsScalar(type)) {
    const std::string value = expressions_->EmitScalar(advance.value).text;
    definition = {fmt::format("const {} {} = {};", CppType(type.scalar), names.now, value)};
  } else {
    definition =
        ArrayDefinition(names.now, type, expressions_->EmitElements(advance.value, type.size()));
  }
  bool counts_steps = false;
  if (advance.duration) {
    names.duration = AtLeast(Precedence::kPrefix, expressions_->EmitScalar(*advance.duration));
    counts_steps = advance.duration->type.scalar == Scalar::kInt;
  }
  WriteLines(expressions_->TakeParts(), line);
  WriteLines(definition, line);
  WriteLines(AdvanceLines(function, type, advance.is_start, counts_steps, names,
                          expressions_->written_out(), helpers_),
             line);
}

void FunctionEmitter::Emit(const CheckedPotentialStep& step, SourceLine line) {
  const CheckedPotential& potential = task_.potentials[step.potential];
  const std::vector<std::string>& memory = function_.values.memory;
  const std::string& last = memory[potential.last];
  const std::string now = function_.names.Add("now");
  const CppText value = expressions_->EmitScalar(step.value);
  WriteLines(expressions_->TakeParts(), line);
  writer_.Line(fmt::format("const double {} = {};", now, value.text), line);
  if (step.moment != CheckedPotentialStep::kStart) {
    const std::string growth =
        step.moment == CheckedPotentialStep::kAction
            ? fmt::format("frame->discount * {} - {}", now, last)
            : fmt::format("{}(frame, {}, {}, {})", helpers_.Use(Helper::kLastGrowth),
                          memory[potential.paid], last, now);
    writer_.Line(fmt::format("if ({}) {}(frame, reward, {}, {});", memory[potential.known],
                             helpers_.Use(Helper::kPay), names_.terms[potential.term], growth),
                 line);
  }
  if (step.moment == CheckedPotentialStep::kEnd) return;
  const bool is_paid = step.moment == CheckedPotentialStep::kAction;
  writer_.Line(fmt::format("{} = {};", last, now), line);
  writer_.Line(fmt::format("{} = true;", memory[potential.known]), line);
  if (is_paid) writer_.Line(fmt::format("{} = true;", memory[potential.paid]), line);
}

void FunctionEmitter::EmitReset(const CheckedMemory& memory, uint32_t index) {
  SourceLine line = LineOf(memory.span);
  std::vector<CppText> elements = expressions_->EmitElements(memory.initial, memory.type.size());
  WriteLines(expressions_->TakeParts(), line);
  EmitStore(index, "=", elements, AllIndices(memory.type.size()), line);
}

void FunctionEmitter::EmitStore(uint32_t memory, std::string_view op,
                                const std::vector<CppText>& values,
                                const std::vector<uint32_t>& indices, SourceLine line) {
  const std::string& name = function_.values.memory[memory];
  if (IsScalar(task_.memory[memory].type)) {
    writer_.Line(fmt::format("{} {} {};", name, op, values.front().text), line);
    return;
  }
  WriteLines(ArrayAssignment(name, op, values, indices, function_.names), line);
}

void FunctionEmitter::WriteLines(const std::vector<std::string>& lines, SourceLine line) {
  for (const std::string& text : lines) writer_.Line(text, line);
}

}  // namespace compiler
