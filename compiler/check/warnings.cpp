#include "compiler/check/warnings.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "compiler/check/fold.h"
#include "compiler/check/names.h"
#include "compiler/check/real_equality.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

bool IsStep(EventKind event) { return event >= EventKind::kStartOfTimeStep; }

// What stands once in the source stands once for each pass of the loops around it in the checked
// task: a list of such places, each of which is warned of at most once, and only if all of its
// copies are alike.
class Places {
 public:
  // `message`: empty where nothing is to be said.
  void Add(Span span, std::string_view message) {
    const auto [found, is_new] = messages_.try_emplace(span.begin, span, message);
    if (!is_new && found->second.second != message) found->second.second.clear();
  }
  void Warn(std::string_view code, Diagnostics& diagnostics, const std::string& help = "") const {
    for (const auto& [begin, place] : messages_)
      if (!place.second.empty())
        Report(diagnostics, code, place.first, place.second, {.help = help});
  }

 private:
  std::map<uint32_t, std::pair<Span, std::string>> messages_;
};

// Which params and memory are read, and which memory is set.
class Uses {
 public:
  explicit Uses(const CheckedTask& task) {
    for (const CheckedEvent& event : task.events)
      ForEachStatement(event.body, [&](const CheckedStatement& statement) { Add(statement); });
    ForEachStatement(task.start.block.body,
                     [&](const CheckedStatement& statement) { Add(statement); });
    for (const CheckedMetric& metric : task.metrics) AddReads(metric.value, nullptr);
    for (const CheckedObservation& observation : task.observations)
      AddReads(observation.value, nullptr);
    for (const CheckedMemory& memory : task.memory) AddReads(memory.initial, nullptr);
    for (const CheckedGoal& goal : task.goals) {
      AddReads(goal.value, nullptr);
      if (goal.interval) AddReads(goal.interval->length, nullptr);
    }
  }

  bool IsParamRead(uint32_t param) const { return read_params_.contains(param); }
  bool IsMemoryRead(uint32_t memory) const { return read_memory_.contains(memory); }
  bool IsMemorySet(uint32_t memory) const { return set_memory_.contains(memory); }

 private:
  void Add(const CheckedStatement& statement) {
    const auto* assign = std::get_if<CheckedAssign>(&statement.node);
    if (assign != nullptr) set_memory_.insert(assign->memory);
    ForEachExpression(statement, [&](const CheckedExpression& value) { AddReads(value, assign); });
  }

  // What a memory reads of itself, as in `n = n + 1`, is no use of it.
  void AddReads(const CheckedExpression& expression, const CheckedAssign* assign) {
    ForEachPart(expression, [&](const CheckedExpression& part) {
      if (const auto* param = std::get_if<ParamRead>(&part.node)) read_params_.insert(param->param);
      if (const auto* read = std::get_if<MemoryRead>(&part.node))
        if (assign == nullptr || assign->memory != read->memory) read_memory_.insert(read->memory);
    });
  }

  std::set<uint32_t> read_params_;
  std::set<uint32_t> read_memory_;
  std::set<uint32_t> set_memory_;
};

void WarnOfUnused(const CheckedTask& task, Diagnostics& diagnostics) {
  const Uses uses(task);
  for (uint32_t i = 0; i < task.params.size(); ++i)
    if (!uses.IsParamRead(i))
      Report(diagnostics, code::kUnusedParam, task.params[i].span,
             fmt::format("the param `{}` is never used", task.params[i].name));
  for (uint32_t i = 0; i < task.memory.size(); ++i) {
    const CheckedMemory& memory = task.memory[i];
    if (!memory.is_declared) continue;
    if (!uses.IsMemoryRead(i)) {
      Report(diagnostics, code::kNeverRead, memory.span,
             fmt::format("the memory `{}` is never read", memory.name),
             {.note = uses.IsMemorySet(i) ? "it is only set" : ""});
    } else if (!uses.IsMemorySet(i)) {
      Report(diagnostics, code::kNeverSet, memory.span,
             fmt::format("the memory `{}` is never set", memory.name),
             {.help = IsScalar(memory.type) ? "what never changes can be a `param`" : ""});
    }
  }
}

void WarnOfUnusedGoals(const CheckedTask& task, Diagnostics& diagnostics) {
  const Uses uses(task);
  for (const CheckedGoal& goal : task.goals)
    if (!uses.IsMemoryRead(goal.memory))
      Report(diagnostics, code::kUnusedGoal, goal.span,
             fmt::format("the goal `{}` is never used", goal.name),
             {.note = "nothing that the task pays or measures depends on it"});
}

// The parameters and local values that a function does not read.
void WarnOfUnusedInside(const CheckedFunction& function, const FunctionDeclaration& declaration,
                        Diagnostics& diagnostics) {
  std::set<uint32_t> arguments;
  std::set<uint32_t> locals;
  const auto collect = [&](const CheckedExpression& part) {
    if (const auto* read = std::get_if<ArgumentRead>(&part.node)) arguments.insert(read->argument);
    if (const auto* read = std::get_if<LocalRead>(&part.node)) locals.insert(read->local);
  };
  for (const CheckedLet& let : function.lets) ForEachPart(let.value, collect);
  ForEachPart(function.value, collect);
  for (uint32_t i = 0; i < declaration.parameters.size(); ++i)
    if (!arguments.contains(i))
      Report(diagnostics, code::kUnusedParameter, declaration.parameters[i].name.span,
             fmt::format("the parameter `{}` is never used", declaration.parameters[i].name.text));
  for (uint32_t i = 0; i < declaration.lets.size(); ++i)
    if (!locals.contains(i))
      Report(diagnostics, code::kUnusedLocal, declaration.lets[i].name.span,
             fmt::format("`{}` is never used", declaration.lets[i].name.text));
}

void WarnOfUnusedFunctions(const CheckedTask& task, const SyntaxTree& tree,
                           Diagnostics& diagnostics) {
  for (const Declaration& declaration : tree.declarations) {
    const auto* function = std::get_if<FunctionDeclaration>(&declaration.node);
    if (function == nullptr || declaration.is_imported) continue;
    const auto called =
        std::ranges::find(task.functions, function->name.text, &CheckedFunction::name);
    if (called != task.functions.end()) {
      WarnOfUnusedInside(*called, *function, diagnostics);
    } else {
      Report(diagnostics, code::kUnusedFunction, function->name.span,
             fmt::format("the function `{}` is never called", function->name.text));
    }
  }
}

void WarnOfUnusedLocals(const CheckedEvent& event, Diagnostics& diagnostics) {
  std::set<uint32_t> read;
  ForEachStatement(event.body, [&](const CheckedStatement& statement) {
    ForEachExpression(statement, [&](const CheckedExpression& expression) {
      ForEachPart(expression, [&](const CheckedExpression& part) {
        if (const auto* local = std::get_if<LocalRead>(&part.node)) read.insert(local->local);
      });
    });
  });
  Places places;
  ForEachStatement(event.body, [&](const CheckedStatement& statement) {
    if (const auto* let = std::get_if<CheckedLet>(&statement.node))
      places.Add(statement.span,
                 read.contains(let->local)
                     ? ""
                     : fmt::format("`{}` is never used", event.locals[let->local].name));
  });
  places.Warn(code::kUnusedLocal, diagnostics);
}

void WarnOfConstantConditions(const CheckedEvent& event, Diagnostics& diagnostics) {
  Places places;
  const auto add = [&](const CheckedExpression& condition) {
    const auto value = ValueOf(condition);
    places.Add(condition.span,
               !value ? "" : fmt::format("this condition is always {}", *value != 0));
  };
  ForEachStatement(event.body, [&](const CheckedStatement& statement) {
    if (const auto* require = std::get_if<CheckedRequire>(&statement.node)) add(require->condition);
    if (const auto* branches = std::get_if<CheckedIf>(&statement.node))
      for (const CheckedIfBranch& branch : branches->branches) add(branch.condition);
  });
  places.Warn(code::kConstantCondition, diagnostics);
}

// Calls `visit` for the statements of a block that always run, also in its loops and phases.
template <typename Visit>
void ForEachUnconditional(const CheckedBlock& block, const Visit& visit) {
  for (const CheckedStatement& statement : block) {
    visit(statement);
    if (const auto* loop = std::get_if<CheckedFor>(&statement.node))
      for (const CheckedPass& pass : loop->passes) ForEachUnconditional(pass.body, visit);
    if (const auto* phases = std::get_if<CheckedPhaseSwitch>(&statement.node))
      for (const CheckedBlock& phase : phases->blocks) ForEachUnconditional(phase, visit);
  }
}

// Paid at each step of an event, a plain reward adds up to more the shorter the steps are.
void WarnOfRewardEveryStep(const CheckedTask& task, const CheckedEvent& event,
                           Diagnostics& diagnostics) {
  std::set<uint32_t> seen;  // where their statements begin
  ForEachUnconditional(event.body, [&](const CheckedStatement& statement) {
    const auto* reward = std::get_if<CheckedReward>(&statement.node);
    if (reward == nullptr || reward->is_rate || !seen.insert(statement.span.begin).second) return;
    const std::string& term = task.terms[reward->term].name;
    const std::string_view name = term == kReward ? "NAME" : std::string_view(term);
    Report(
        diagnostics, code::kRewardEveryStep, statement.span,
        "this is paid at every step, so its sum depends on the length of the steps",
        {.help = fmt::format("write `reward rate {} = ...` with what it pays per second", name)});
  });
}

void WarnOfUnpaidReward(const CheckedEvent& event, Diagnostics& diagnostics) {
  Places places;
  ForEachStatement(event.body, [&](const CheckedStatement& statement) {
    if (std::holds_alternative<CheckedReward>(statement.node))
      places.Add(statement.span,
                 "no action gets this reward: it is paid before the first or after the last one");
  });
  places.Warn(code::kUnpaidReward, diagnostics,
              "pay it in another event, such as `end_of_time_step`");
}

void WarnOfUnusedSensors(const CheckedTask& task, const SyntaxTree& tree,
                         Diagnostics& diagnostics) {
  for (const Declaration& declaration : tree.declarations) {
    const auto* sensor = std::get_if<SensorDeclaration>(&declaration.node);
    if (sensor == nullptr) continue;
    const bool is_read = std::ranges::find(task.sensors, sensor->name.text, &CheckedSensor::name) !=
                         task.sensors.end();
    if (!is_read)
      Report(diagnostics, code::kUnusedSensor, sensor->name.span,
             fmt::format("the sensor `{}` is never read", sensor->name.text));
  }
}

void WarnOfTests(const CheckedTask& task, Diagnostics& diagnostics) {
  for (const CheckedTest& test : task.tests) {
    const bool expects = std::ranges::any_of(test.statements, [](const auto& statement) {
      return std::holds_alternative<CheckedExpect>(statement.node) ||
             std::holds_alternative<CheckedExpectEnd>(statement.node);
    });
    if (!expects)
      Report(diagnostics, code::kExpectsNothing, test.span, "this test expects nothing",
             {.help = "say what must hold: `expect total(TERM) == -4`"});
    for (const CheckedTestStatement& statement : test.statements) {
      const auto* expect = std::get_if<CheckedExpect>(&statement.node);
      if (expect == nullptr) continue;
      if (const auto value = ValueOf(expect->condition))
        Report(diagnostics, code::kConstantCondition, expect->condition.span,
               fmt::format("this condition is always {}", *value != 0));
    }
  }
}

void WarnOfNoEnd(const CheckedTask& task, const SyntaxTree& tree, Diagnostics& diagnostics) {
  if (!task.ends.empty()) return;
  Report(diagnostics, code::kNeverEnds, tree.task->span,
         fmt::format("no episode of `{}` ever ends", task.name),
         {.help = "limit its time: `if time > 20 s { truncate_episode \"time is up\" }`"});
}

}  // namespace

void Warn(const CheckedTask& task, const SyntaxTree& tree, Diagnostics& diagnostics) {
  WarnOfUnused(task, diagnostics);
  WarnOfUnusedGoals(task, diagnostics);
  WarnOfUnusedSensors(task, tree, diagnostics);
  WarnOfUnusedFunctions(task, tree, diagnostics);
  WarnOfNoEnd(task, tree, diagnostics);
  WarnOfTests(task, diagnostics);
  WarnOfRealEquality(task, diagnostics);
  WarnOfUnusedLocals(task.start.block, diagnostics);
  WarnOfConstantConditions(task.start.block, diagnostics);
  for (size_t i = 0; i < task.events.size(); ++i) {
    const auto kind = static_cast<EventKind>(i);
    const CheckedEvent& event = task.events[i];
    WarnOfUnusedLocals(event, diagnostics);
    WarnOfConstantConditions(event, diagnostics);
    if (IsStep(kind)) WarnOfRewardEveryStep(task, event, diagnostics);
    if (kind == EventKind::kStartOfEpisode || kind == EventKind::kEndOfEpisode)
      WarnOfUnpaidReward(event, diagnostics);
  }
}

}  // namespace compiler
