// The changes of a run: what was done, and what is still to be done again.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runtime/core/task/plugin.h"
#include "runtime/training/run/change.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// Between two time steps of a run.
struct RunPosition {
  int64_t episode = 0;  // that runs, or is about to start
  int64_t step = 0;     // time steps done in it

  auto operator<=>(const RunPosition&) const = default;
  // The first episode all of which comes after it.
  int64_t next_whole_episode() const { return step == 0 ? episode : episode + 1; }
};

// A change that is still to be done.
struct DueChange {
  ChangeRecord record;
  // Of the task that it brings, where it is loaded already. A change that was read from the record
  // has none.
  std::shared_ptr<const Plugin> plugin;

  RunPosition position() const { return {record.episode, record.step}; }
};

// A change stands in the run's record before it takes effect, with the position at which it does.
// So a run that goes on from a checkpoint meets the same changes at the same places, and one that
// has an effect only in the next episode is not lost with the program. By position and then id, the
// changes stand in the order in which they took effect.
class Journal {
 public:
  // Reads what the record has. `database` outlives this object.
  explicit Journal(RunDatabase& database);

  // Of the changes up to `position` that were not taken yet, the first. Changes that are in
  // quarantine are passed over. What was taken is in the run's record only.
  std::optional<DueChange> TakeDue(const RunPosition& position);
  // The same for a change that takes effect at `position` now. That is later than it stands in the
  // record where an episode was to be repeated and, because of what was changed meanwhile, has
  // ended before: then the change stands there from now on, with another id.
  std::optional<DueChange> TakeDueNow(const RunPosition& position);
  // Whether there may be one: as cheap as can be.
  bool has_due(const RunPosition& position) const {
    return !due_.empty() && due_.front().position() <= position;
  }

  // What is still to be done, in its order.
  const std::deque<DueChange>& due() const { return due_; }

  // Writes down a change that is about to take effect.
  ChangeRecord AddDone(const RunPosition& position, Change change, std::string text);
  // Writes down a change that is taken when it is due, after all others of its position.
  void AddDue(const RunPosition& position, Change change, std::string text,
              std::shared_ptr<const Plugin> plugin);
  // The last one that was added could not be done.
  void Remove(const ChangeRecord& change);
  // A change that did harm is never done again.
  void Quarantine(const RunPosition& position, const ChangeRecord& change, const std::string& why);

  bool IsInQuarantine(const ChangeRecord& change) const;
  // Tasks (TaskRecord::id) that have crashed.
  const std::set<int64_t>& bad_tasks() const { return bad_tasks_; }
  // The changes that were passed over so far.
  const std::vector<ChangeRecord>& passed_over() const { return passed_over_; }

 private:
  void NoteQuarantine(const PutInQuarantine& quarantine);

  RunDatabase& database_;
  std::deque<DueChange> due_;  // by position, then id
  RunPosition moved_to_;       // where a change was moved to last
  std::vector<ChangeRecord> passed_over_;
  std::set<int64_t> bad_tasks_;
  std::set<int64_t> bad_changes_;
};

// Whether it can be taken back. What removes a module cannot: a checkpoint that was saved since
// knows nothing of the module.
bool CanBeBlamed(const ChangeRecord& change);

// For a process that guards the trainer.

// Writes down that the task crashed, or did not come back, so that it is never run again in this
// run.
void QuarantineTask(RunDatabase& database, int64_t task, const std::string& why);
// The trainer has crashed. If a change of the last two episodes can be blamed for it, it is put
// into quarantine; returns whether there is one.
bool QuarantineLastChange(RunDatabase& database, const std::string& why);

}  // namespace runtime
