#include "compiler/task_tests/test_run.h"

#include <fmt/format.h>

#include <optional>

#include "compiler/check/test_blocks.h"
#include "compiler/task_tests/rest_values.h"
#include "compiler/task_tests/side_by_side.h"

namespace compiler {
namespace {

class TestRun {
 public:
  TestRun(const CheckedTask& task, const Sources& sources, const taskc_plugin& plugin)
      : task_(task), sources_(sources), both_(task, plugin) {
    for (uint32_t i = 0; i < task.sensors.size(); ++i) {
      both_.SetSensor(i, RestValue(task.sensors[i]));
    }
  }

  void Run(const CheckedTestStatement& statement) {
    std::visit([&](const auto& node) { Run(node, statement.span); }, statement.node);
  }

  std::vector<Failure> TakeFailures() { return std::move(failures_); }

 private:
  const Frame& frame() const { return both_.evaluator().frame(); }

  void Run(const CheckedGiven& given, Span) {
    const Value value = both_.evaluator().Evaluate(given.value);
    switch (given.target) {
      case CheckedGiven::kSensor:
        return both_.SetSensor(given.index, Changed(frame().sensors[given.index], given, value));
      case CheckedGiven::kParam:
        return both_.SetParam(given.index, RealOf(value));
      case CheckedGiven::kMemory:
        return both_.SetMemory(given.index, Changed(frame().memory[given.index], given, value));
      case CheckedGiven::kGoal: {
        const CheckedGoal& goal = task_.goals[given.index];
        both_.SetMemory(goal.held, Integers{1});
        return both_.SetMemory(goal.memory, Changed(frame().memory[goal.memory], given, value));
      }
      case CheckedGiven::kTimeStep:
        time_step_ = RealOf(value);
        return;
      case CheckedGiven::kDiscount:
        both_.SetDiscount(RealOf(value));
    }
  }

  static Value Changed(Value old, const CheckedGiven& given, const Value& value) {
    Assign(AssignOperator::kSet, given.elements, value, old);
    return old;
  }

  void Run(const CheckedFire& fire, Span) {
    double time_step = RestTimeStep(fire.event);
    if (time_step > 0) time_step = time_step_.value_or(time_step);
    for (uint32_t i = 0; i < fire.times; ++i) both_.Fire(fire.event, time_step);
  }

  void Run(const CheckedExpect& expect, Span span) {
    both_.Record();
    if (IsTrue(both_.evaluator().Evaluate(expect.condition))) return;
    failures_.push_back({span, "", Explain(expect.condition, task_, both_.evaluator(), sources_)});
  }

  void Run(const CheckedExpectEnd& expect, Span span) {
    const int32_t end = frame().first_end;
    if (end < 0) return failures_.push_back({span, WithoutEnd(), {}});
    const CheckedEndReason& reached = task_.ends[static_cast<size_t>(end)];
    if (reached.kind == expect.kind && reached.reason == expect.reason) return;
    failures_.push_back(
        {span, "it ended differently: " + EndText(reached.kind, reached.reason), {}});
  }

  std::string WithoutEnd() const {
    const int32_t violation = frame().first_violation;
    if (violation < 0) return "the episode has not ended";
    return fmt::format("the episode has ended by a requirement: {}",
                       task_.requirements[static_cast<size_t>(violation)].reason);
  }

  const CheckedTask& task_;
  const Sources& sources_;
  SideBySide both_;
  std::optional<double> time_step_;  // as given
  std::vector<Failure> failures_;
};

}  // namespace

TestResult RunTest(const CheckedTest& test, const CheckedTask& task, const Sources& sources,
                   const taskc_plugin& plugin) {
  TestRun run(task, sources, plugin);
  for (const CheckedTestStatement& statement : test.statements) run.Run(statement);
  return {test.name, test.span, run.TakeFailures()};
}

}  // namespace compiler
