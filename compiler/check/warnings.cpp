#include "compiler/check/warnings.h"

#include <algorithm>
#include <set>

#include "compiler/check/fold.h"
#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

bool IsStep(EventKind event) { return event >= EventKind::kStartOfTimeStep; }

// Which params and memory are read, and which memory is set.
class Uses {
 public:
  explicit Uses(const CheckedTask& task) {
    for (const CheckedEvent& event : task.events)
      ForEachStatement(event.body, [&](const CheckedStatement& statement) { Add(statement); });
    for (const CheckedMetric& metric : task.metrics) AddReads(metric.value, nullptr);
    for (const CheckedMemory& memory : task.memory) AddReads(memory.initial, nullptr);
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
    if (!uses.IsMemoryRead(i)) {
      Report(diagnostics, code::kNeverRead, memory.span,
             fmt::format("the memory `{}` is never read", memory.name),
             {.note = uses.IsMemorySet(i) ? "it is only set" : ""});
    } else if (!uses.IsMemorySet(i)) {
      Report(diagnostics, code::kNeverSet, memory.span,
             fmt::format("the memory `{}` is never set", memory.name),
             {.help = "what never changes can be a `param`"});
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
  ForEachStatement(event.body, [&](const CheckedStatement& statement) {
    const auto* let = std::get_if<CheckedLet>(&statement.node);
    if (let != nullptr && !read.contains(let->local))
      Report(diagnostics, code::kUnusedLocal, statement.span,
             fmt::format("`{}` is never used", event.locals[let->local].name));
  });
}

void WarnOfConstantConditions(const CheckedEvent& event, Diagnostics& diagnostics) {
  ForEachStatement(event.body, [&](const CheckedStatement& statement) {
    const auto* branches = std::get_if<CheckedIf>(&statement.node);
    if (branches == nullptr) return;
    for (const CheckedIfBranch& branch : branches->branches)
      if (const auto value = ValueOf(branch.condition))
        Report(diagnostics, code::kConstantCondition, branch.condition.span,
               fmt::format("this condition is always {}", *value != 0 ? "true" : "false"));
  });
}

// Paid at each step of an event, a plain reward adds up to more the shorter the steps are.
void WarnOfRewardEveryStep(const CheckedTask& task, const CheckedEvent& event,
                           Diagnostics& diagnostics) {
  for (const CheckedStatement& statement : event.body) {
    const auto* reward = std::get_if<CheckedReward>(&statement.node);
    if (reward == nullptr || reward->is_rate) continue;
    const std::string& term = task.terms[reward->term].name;
    const std::string_view name = term == kReward ? "NAME" : std::string_view(term);
    Report(
        diagnostics, code::kRewardEveryStep, statement.span,
        "this is paid at every step, so its sum depends on the length of the steps",
        {.help = fmt::format("write `reward rate {} = ...` with what it pays per second", name)});
  }
}

void WarnOfUnpaidReward(const CheckedEvent& event, Diagnostics& diagnostics) {
  ForEachStatement(event.body, [&](const CheckedStatement& statement) {
    if (std::holds_alternative<CheckedReward>(statement.node))
      Report(diagnostics, code::kUnpaidReward, statement.span,
             "no action gets this reward: it is paid before the first or after the last one",
             {.help = "pay it in another event, such as `end_of_time_step`"});
  });
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

void WarnOfNoEnd(const CheckedTask& task, const SyntaxTree& tree, Diagnostics& diagnostics) {
  if (!task.ends.empty()) return;
  Report(diagnostics, code::kNeverEnds, tree.task->span,
         fmt::format("no episode of `{}` ever ends", task.name),
         {.help = "limit its time: `if time > 20 s { truncate_episode \"time is up\" }`"});
}

}  // namespace

void Warn(const CheckedTask& task, const SyntaxTree& tree, Diagnostics& diagnostics) {
  WarnOfUnused(task, diagnostics);
  WarnOfUnusedSensors(task, tree, diagnostics);
  WarnOfNoEnd(task, tree, diagnostics);
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
