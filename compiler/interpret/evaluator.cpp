#include "compiler/interpret/evaluator.h"

#include <taskc/largest_reward.h>

#include <cmath>

#include "compiler/check/after_end.h"
#include "compiler/check/arithmetic.h"
#include "compiler/check/memory_reset.h"
#include "compiler/interpret/expression_evaluator.h"
#include "compiler/interpret/time_functions.h"

namespace compiler {
namespace {

void SetOnce(int32_t& first, uint32_t index) {
  if (first < 0) first = static_cast<int32_t>(index);
}

}  // namespace

Frame::Frame(const CheckedTask& task)
    : terms(task.terms.size()),
      metrics(task.metrics.size()),
      observations(task.observation_size),
      logs(task.logs.size()) {
  for (const CheckedSensor& sensor : task.sensors) {
    sensors.push_back(Filled(sensor.type.scalar, sensor.type.size(), 0));
  }
  for (const CheckedParam& param : task.params) params.push_back(param.initial);
  for (const CheckedMemory& variable : task.memory) {
    memory.push_back(Filled(variable.type.scalar, variable.type.size(), 0));
  }
}

Evaluator::Evaluator(const CheckedTask& task) : task_(task), frame_(task) { Initialize(); }

void Evaluator::Initialize() {
  for (uint32_t i = 0; i < task_.memory.size(); ++i) Reset(i);
  for (uint32_t i = 0; i < task_.goals.size(); ++i) Run(CheckedRedraw{i});
}

void Evaluator::DrawPose() {
  const size_t count = task_.start.poses.size();
  frame_.pose = 0;
  if (count > 1)
    frame_.pose =
        static_cast<int32_t>(DrawChoice({frame_.seed, task_.start.stream, 0}, 0, 0, count));
}

void Evaluator::DrawStart() {
  const CheckedEvent& block = task_.start.block;
  if (block.body.empty()) return;
  for (uint32_t i = 0; i < task_.memory.size(); ++i) {
    if (IsResetAt(EventKind::kStartOfEpisode, task_.memory[i].scope)) Reset(i);
  }
  for (uint32_t i = 0; i < task_.goals.size(); ++i) Run(CheckedRedraw{i});
  locals_.assign(block.locals.size(), {});
  lets_.assign(block.locals.size(), nullptr);
  place_ = {frame_.seed, task_.start.stream, frame_.attempt};
  Run(block.body);
}

void Evaluator::Fire(EventKind kind, double time_step) {
  const CheckedEvent& event = task_.events[static_cast<size_t>(kind)];
  frame_.time_step = time_step;
  frame_.reward = 0;
  frame_.end = -1;
  frame_.fault = -1;
  frame_.violation = -1;
  if (StopsAfterEnd(task_, kind) && IsTrue(frame_.memory[*task_.ended])) return;
  for (uint32_t i = 0; i < task_.memory.size(); ++i) {
    if (IsResetAt(kind, task_.memory[i].scope)) Reset(i);
  }
  locals_.assign(event.locals.size(), {});
  lets_.assign(event.locals.size(), nullptr);
  Run(event.body);
  if (frame_.first_end < 0) frame_.first_end = frame_.end;
  if (frame_.first_violation < 0) frame_.first_violation = frame_.violation;
  if (task_.ended && (frame_.end >= 0 || frame_.violation >= 0)) {
    frame_.memory[*task_.ended] = Integers{1};
  }
}

void Evaluator::Measure() {
  for (size_t i = 0; i < task_.metrics.size(); ++i) {
    frame_.metrics[i] = RealOf(Evaluate(task_.metrics[i].value));
  }
}

void Evaluator::Observe() {
  for (const CheckedObservation& observation : task_.observations) {
    const Value value = Evaluate(observation.value);
    std::visit(
        [&](const auto& elements) {
          for (size_t i = 0; i < elements.size(); ++i)
            frame_.observations[observation.offset + i] = static_cast<double>(elements[i]);
        },
        value);
  }
}

Value Evaluator::Evaluate(const CheckedExpression& expression) const {
  return ExpressionEvaluator(task_, frame_, {}, {}, {}).Evaluate(expression);
}

Value Evaluator::EvaluateHere(const CheckedExpression& expression) const {
  return ExpressionEvaluator(task_, frame_, locals_, {}, place_).Evaluate(expression);
}

void Evaluator::Reset(uint32_t memory) {
  Assign(AssignOperator::kSet, {}, Evaluate(task_.memory[memory].initial), frame_.memory[memory]);
}

void Evaluator::Run(const CheckedBlock& block) {
  for (const CheckedStatement& statement : block) {
    std::visit([this](const auto& node) { Run(node); }, statement.node);
  }
}

void Evaluator::Run(const CheckedLet& let) {
  locals_[let.local] = EvaluateHere(let.value);
  lets_[let.local] = &let.value;
}

void Evaluator::Run(const CheckedAssign& assign) {
  Assign(assign.op, assign.elements, EvaluateHere(assign.value), frame_.memory[assign.memory]);
}

void Evaluator::Run(const CheckedIf& branches) {
  for (const CheckedIfBranch& branch : branches.branches) {
    if (IsTrue(EvaluateHere(branch.condition))) return Run(branch.body);
  }
  Run(branches.otherwise);
}

void Evaluator::Run(const CheckedFor& loop) {
  for (const CheckedPass& pass : loop.passes) Run(pass.body);
}

void Evaluator::Run(const CheckedReward& reward) {
  double value = RealOf(EvaluateHere(reward.value));
  if (reward.is_rate) value = value * frame_.time_step;
  Pay(reward.term, value, reward.value);
}

void Evaluator::Pay(uint32_t term, double value, const CheckedExpression& expression) {
  // What gives no finite reward, or too large a one, is reported instead of paid.
  const bool is_paid = std::abs(frame_.reward + value) <= TASKC_LARGEST_REWARD;
  if (!is_paid && term == watched_ && !blame_) {
    blame_ = ExpressionEvaluator(task_, frame_, locals_, {}, place_).BlameFor(expression, lets_);
  }
  if (!is_paid) return SetOnce(frame_.fault, term);
  frame_.reward += value;
  frame_.terms[term] += value;
}

void Evaluator::Run(const CheckedEnd& end) { SetOnce(frame_.end, end.end); }

void Evaluator::Run(const CheckedLog& log) {
  const double value = RealOf(EvaluateHere(log.value));
  LogState& state = frame_.logs[log.log];
  const bool is_first = state.count == 0;
  ++state.count;
  state.last = value;
  state.sum = is_first ? value : state.sum + value;
  const double lowest[] = {state.minimum, value};
  const double highest[] = {state.maximum, value};
  state.minimum = is_first ? value : Calculate(Builtin::kMin, lowest);
  state.maximum = is_first ? value : Calculate(Builtin::kMax, highest);
}

void Evaluator::Run(const CheckedRequire& require) {
  if (!IsTrue(EvaluateHere(require.condition))) SetOnce(frame_.violation, require.requirement);
}

void Evaluator::Run(const CheckedRedraw& redraw) {
  const CheckedGoal& goal = task_.goals[redraw.goal];
  if (IsTrue(frame_.memory[goal.held])) return;
  auto& draws = std::get<Integers>(frame_.memory[goal.draws]).front();
  const DrawPlace place{frame_.seed, goal.stream, static_cast<uint32_t>(draws)};
  const auto evaluate = [&](const CheckedExpression& expression) {
    return ExpressionEvaluator(task_, frame_, {}, {}, place).Evaluate(expression);
  };
  Assign(AssignOperator::kSet, {}, evaluate(goal.value), frame_.memory[goal.memory]);
  if (goal.interval) frame_.memory[goal.interval->left] = evaluate(goal.interval->length);
  ++draws;
}

void Evaluator::Run(const CheckedNext& next) { SetOnce(next_phase_, next.phase); }

void Evaluator::Run(const CheckedPhaseSwitch& phases) {
  const auto present = [&]() -> int64_t& {
    return std::get<Integers>(frame_.memory[task_.phase_memory.present]).front();
  };
  next_phase_ = -1;
  Run(phases.blocks[static_cast<size_t>(present())]);
  if (next_phase_ < 0) return;
  present() = next_phase_;
  frame_.memory[task_.phase_memory.time] = Reals{0};
}

void Evaluator::Run(const CheckedPotentialStep& step) {
  const CheckedPotential& potential = task_.potentials[step.potential];
  const double now = RealOf(EvaluateHere(step.value));
  double& last = std::get<Reals>(frame_.memory[potential.last]).front();
  int64_t& is_known = std::get<Integers>(frame_.memory[potential.known]).front();
  int64_t& is_paid = std::get<Integers>(frame_.memory[potential.paid]).front();
  const bool is_end = step.moment == CheckedPotentialStep::kEnd;
  if (step.moment != CheckedPotentialStep::kStart && is_known != 0) {
    const bool is_terminal = is_end && frame_.outcome != EndKind::kTruncated;
    // At a terminal end the potential is 0, also where an action ends with the episode.
    const double growth = is_end && is_paid != 0
                              ? (is_terminal ? 0.0 - frame_.discount * last : 0.0)
                              : (is_terminal ? 0.0 - last : frame_.discount * now - last);
    Pay(potential.term, growth, step.value);
  }
  if (is_end) return;
  last = now;
  is_known = 1;
  if (step.moment == CheckedPotentialStep::kAction) is_paid = 1;
}

void Evaluator::Run(const CheckedAdvance& advance) {
  const CheckedTimeFunction& function = task_.time_functions[advance.function];
  const Value now = EvaluateHere(advance.value);
  double duration = 0;
  if (advance.duration) duration = RealOf(EvaluateHere(*advance.duration));
  const bool counts_steps = advance.duration && advance.duration->type.scalar == Scalar::kInt;
  Advance({.function = function,
           .is_start = advance.is_start,
           .counts_steps = counts_steps,
           .duration = duration,
           .time_step = frame_.time_step},
          now, frame_.memory);
}

}  // namespace compiler
