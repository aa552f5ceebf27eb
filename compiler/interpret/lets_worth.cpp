#include "compiler/interpret/lets_worth.h"

#include <algorithm>
#include <cmath>

#include "compiler/check/traversal.h"
#include "compiler/interpret/expression_evaluator.h"

namespace compiler {
namespace {

// Of an int, and of a bool, only what an int can be: what a host tells may come from anywhere.
bool Fits(Scalar scalar, double number) {
  constexpr double kLargest = 9007199254740992;  // 2^53: so far each double is one int
  return scalar == Scalar::kReal || (std::abs(number) <= kLargest && number == std::floor(number));
}

// The frame of a moment, and what of it a host has told.
class Moment {
 public:
  Moment(const CheckedTask& task, const KnownNumbers& known)
      : known_(known),
        frame_(task),
        has_sensor_(task.sensors.size()),
        has_param_(task.params.size()),
        has_memory_(task.memory.size()) {
    for (size_t i = 0; i < task.sensors.size(); ++i) {
      const CheckedSensor& sensor = task.sensors[i];
      has_sensor_[i] = Take(sensor.name, sensor.type, frame_.sensors[i]);
    }
    for (size_t i = 0; i < task.params.size(); ++i) {
      const auto* numbers = Told(task.params[i].name, task.params[i].type);
      if (numbers != nullptr) frame_.params[i] = numbers->front();
      has_param_[i] = numbers != nullptr;
    }
    for (size_t i = 0; i < task.memory.size(); ++i) {
      const CheckedMemory& memory = task.memory[i];
      has_memory_[i] = memory.is_declared && Take(memory.name, memory.type, frame_.memory[i]);
    }
    for (const CheckedGoal& goal : task.goals)
      has_memory_[goal.memory] = Take(goal.name, goal.type, frame_.memory[goal.memory]);
  }

  const Frame& frame() const { return frame_; }

  bool Has(const SensorRead& read) const { return has_sensor_[read.sensor]; }
  bool Has(const ParamRead& read) const { return has_param_[read.param]; }
  bool Has(const MemoryRead& read) const { return has_memory_[read.memory]; }

 private:
  // Null where nothing was told of it, or what it cannot be.
  const std::vector<double>* Told(const std::string& name, const Type& type) const {
    const auto found = known_.find(name);
    if (found == known_.end() || found->second.size() != type.size()) return nullptr;
    const auto fits = [&](double number) { return Fits(type.scalar, number); };
    return std::ranges::all_of(found->second, fits) ? &found->second : nullptr;
  }
  bool Take(const std::string& name, const Type& type, Value& place) const {
    const auto* numbers = Told(name, type);
    if (numbers != nullptr) place = MakeValue(type.scalar, *numbers);
    return numbers != nullptr;
  }

  const KnownNumbers& known_;
  Frame frame_;
  std::vector<bool> has_sensor_;
  std::vector<bool> has_param_;
  std::vector<bool> has_memory_;
};

// The lets of one event.
class EventLets {
 public:
  EventLets(const CheckedTask& task, const CheckedEvent& event, const Moment& moment)
      : event_(event),
        moment_(moment),
        locals_(event.locals.size()),
        is_known_(event.locals.size()),
        evaluator_(task, moment.frame(), locals_, kNoArguments, DrawPlace{}) {
    ForEachStatement(event.body, [&](const CheckedStatement& statement) {
      if (const auto* let = std::get_if<CheckedLet>(&statement.node)) Set(*let);
    });
  }

  void AddTo(std::vector<LetWorth>& worth) const {
    for (size_t i = 0; i < locals_.size(); ++i) {
      const auto& [name, type, unit] = event_.locals[i];
      if (is_known_[i]) worth.push_back({name, type, unit, locals_[i]});
    }
  }

 private:
  void Set(const CheckedLet& let) {
    is_known_[let.local] = Leads(let.value);
    if (is_known_[let.local]) locals_[let.local] = evaluator_.Evaluate(let.value);
  }

  // Whether all that the expression reads is known. A function reads nothing but its arguments.
  bool Leads(const CheckedExpression& expression) const {
    bool leads = true;
    ForEachPart(expression, [&](const CheckedExpression& part) {
      leads = leads && std::visit([&](const auto& node) { return IsKnown(node); }, part.node);
    });
    return leads;
  }

  template <typename Node>
  bool IsKnown(const Node& node) const {
    if constexpr (requires { moment_.Has(node); }) return moment_.Has(node);
    if constexpr (std::is_same_v<Node, LocalRead>) return is_known_[node.local];
    return !std::is_same_v<Node, RewardSoFar> && !std::is_same_v<Node, TimeStep> &&
           !std::is_same_v<Node, Draw> && !std::is_same_v<Node, TestRead>;
  }

  inline static const std::vector<Value> kNoArguments;

  const CheckedEvent& event_;
  const Moment& moment_;
  std::vector<Value> locals_;
  std::vector<bool> is_known_;
  ExpressionEvaluator evaluator_;
};

}  // namespace

std::vector<LetWorth> LetsWorth(const CheckedTask& task, const KnownNumbers& known) {
  const Moment moment(task, known);
  std::map<std::string, int> uses;  // also where an episode starts: a page shows them all
  const auto count = [&](const CheckedEvent& event) {
    for (const Local& local : event.locals) ++uses[local.name];
  };
  count(task.start.block);
  std::vector<LetWorth> worth;
  for (const CheckedEvent& event : task.events) {
    count(event);
    EventLets(task, event, moment).AddTo(worth);
  }
  std::erase_if(worth, [&](const LetWorth& let) { return uses[let.name] > 1; });
  return worth;
}

}  // namespace compiler
