#include "runtime/live/control/journal.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/variant/overloaded.h"

namespace runtime {
namespace {

int64_t LastEpisode(const RunDatabase& database) {
  const std::vector<EpisodeRecord> episodes = database.ReadEpisodes();
  return episodes.empty() ? 0 : episodes.back().number;
}

ChangeRecord Record(const RunPosition& position, Change change, std::string text) {
  ChangeRecord record;
  record.episode = position.episode;
  record.step = position.step;
  record.change = std::move(change);
  record.text = std::move(text);
  return record;
}

}  // namespace

Journal::Journal(RunDatabase& database) : database_(database) {
  for (ChangeRecord& change : database.ReadChanges()) {
    if (const auto* quarantine = std::get_if<PutInQuarantine>(&change.change)) {
      NoteQuarantine(*quarantine);
    } else {
      due_.push_back({std::move(change), nullptr});
    }
  }
  std::ranges::stable_sort(due_, {}, &DueChange::position);
}

void Journal::NoteQuarantine(const PutInQuarantine& quarantine) {
  if (quarantine.task) bad_tasks_.insert(*quarantine.task);
  if (quarantine.change) bad_changes_.insert(*quarantine.change);
}

bool Journal::IsInQuarantine(const ChangeRecord& change) const {
  if (bad_changes_.contains(change.id)) return true;
  const std::optional<TaskOfModule> brought = TaskBroughtBy(change.change);
  return brought && bad_tasks_.contains(brought->task);
}

std::optional<DueChange> Journal::TakeDue(const RunPosition& position) {
  while (has_due(position)) {
    DueChange due = std::move(due_.front());
    due_.pop_front();
    if (!IsInQuarantine(due.record)) return due;
    passed_over_.push_back(std::move(due.record));
  }
  return std::nullopt;
}

std::optional<DueChange> Journal::TakeDueNow(const RunPosition& position) {
  std::optional<DueChange> due = TakeDue(position);
  if (!due) return due;
  // What comes after one that was moved to the end of this position stays after it.
  const bool is_late = due->position() < position;
  if (!is_late && moved_to_ != position) return due;
  ChangeRecord& change = due->record;
  change.id = database_.MoveChange(change.id, position.episode, position.step);
  change.episode = position.episode;
  change.step = position.step;
  moved_to_ = position;
  return due;
}

ChangeRecord Journal::AddDone(const RunPosition& position, Change change, std::string text) {
  ChangeRecord record = Record(position, std::move(change), std::move(text));
  record.id = database_.AddChange(record);
  return record;
}

void Journal::AddDue(const RunPosition& position, Change change, std::string text,
                     std::shared_ptr<const Plugin> plugin) {
  DueChange due{AddDone(position, std::move(change), std::move(text)), std::move(plugin)};
  due_.insert(std::ranges::upper_bound(due_, position, {}, &DueChange::position), std::move(due));
}

void Journal::Remove(const ChangeRecord& change) { database_.RemoveChange(change.id); }

void Journal::Quarantine(const RunPosition& position, const ChangeRecord& change,
                         const std::string& why) {
  const PutInQuarantine quarantine{.task = {}, .change = change.id, .why = why};
  AddDone(position, quarantine, fmt::format("taken back: {} ({})", change.text, why));
  NoteQuarantine(quarantine);
}

bool CanBeBlamed(const ChangeRecord& change) {
  return std::visit(
      variant::Overloaded{
          [](const variant::OneOf<UnloadShadow, ReleaseGoal, RemoveModule, PutInQuarantine> auto&) {
            return false;
          },
          [](const variant::OneOf<SwapTask, LoadShadow, RollBackTask, PromoteTask, SetParameter,
                                  ScheduleParameter, HoldGoal, ConnectPorts, DisconnectPorts,
                                  AddModule, UnknownChange> auto&) { return true; },
      },
      change.change);
}

void QuarantineTask(RunDatabase& database, int64_t task, const std::string& why) {
  const std::string name = TaskWithId(database.ReadRun(), task).task;
  database.AddChange(Record({LastEpisode(database) + 1, 0},
                            PutInQuarantine{.task = task, .change = {}, .why = why},
                            fmt::format("never again: {} ({})", name, why)));
}

bool QuarantineLastChange(RunDatabase& database, const std::string& why) {
  const int64_t last_episode = LastEpisode(database);
  Journal journal(database);
  const ChangeRecord* last = nullptr;
  const std::vector<ChangeRecord> changes = database.ReadChanges();
  for (const ChangeRecord& change : changes) {
    const bool is_recent = change.episode >= last_episode;
    if (is_recent && CanBeBlamed(change) && !journal.IsInQuarantine(change)) last = &change;
  }
  if (last == nullptr) return false;
  journal.Quarantine({last_episode + 1, 0}, *last, why);
  return true;
}

}  // namespace runtime
