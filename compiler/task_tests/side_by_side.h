// A task that runs twice: as a plugin and in the evaluator, on the same values.
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "compiler/interpret/evaluator.h"
#include "compiler/task_tests/plugin_instance.h"
#include "plugins/host/metric_reducer.h"

namespace compiler {

// The two differ: a mistake of the compiler.
class Disagreement : public std::exception {
 public:
  explicit Disagreement(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

class SideBySide {
 public:
  // `plugin` was made from `task`; refers to both.
  SideBySide(const CheckedTask& task, const taskc_plugin& plugin);

  void SetSensor(uint32_t sensor, const Value& value);
  void SetParam(uint32_t param, double value);
  void SetMemory(uint32_t memory, const Value& value);

  void SetSeed(uint64_t seed);
  void SetDiscount(double discount);

  // Draws how an episode starts, after it was drawn `attempt` times for it; then the two agree as
  // after an event. Throws Disagreement.
  void DrawStart(uint32_t attempt);

  // Runs an event, and computes the metrics and what the learner sees. Then all that can be seen of
  // the two has the same bits; only that numbers which are none (NaN) count as equal whatever
  // theirs are, since no task can tell them apart. Throws Disagreement.
  void Fire(EventKind event, double time_step);

  // Brings up to date what `value(NAME)` reads: what a trainer would record if the episode, which
  // began with this object, ended now.
  void Record();

  const Evaluator& evaluator() const { return evaluator_; }

 private:
  void NoteEnd();
  void Compare() const;
  void CompareMemory(size_t memory) const;
  void CompareLogs() const;

  const CheckedTask& task_;
  PluginInstance plugin_;
  host::MetricReducer reducer_;
  Evaluator evaluator_;
  std::optional<EndKind> outcome_;  // of the first end or requirement that was met
};

}  // namespace compiler
