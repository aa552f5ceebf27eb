#include "runtime/live/control/journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace runtime {
namespace {

constexpr const char* kQuarantine = "quarantine";

int64_t LastEpisode(const RunDatabase& database) {
  const std::vector<EpisodeRecord> episodes = database.ReadEpisodes();
  return episodes.empty() ? 0 : episodes.back().number;
}

// `what`: "task" or "change" with its id, and "why".
ChangeRecord AddQuarantine(RunDatabase& database, const RunPosition& position, nlohmann::json what,
                           const std::string& text) {
  what["command"] = kQuarantine;
  ChangeRecord quarantine;
  quarantine.episode = position.episode;
  quarantine.step = position.step;
  quarantine.kind = kQuarantine;
  quarantine.text = text;
  quarantine.data = what.dump();
  database.AddChange(quarantine);
  return quarantine;
}

}  // namespace

Journal::Journal(RunDatabase& database) : database_(database) {
  for (ChangeRecord& change : database.ReadChanges()) {
    if (change.kind == kQuarantine) {
      NoteQuarantine(change);
    } else {
      due_.push_back(std::move(change));
    }
  }
  std::ranges::stable_sort(due_, {}, PositionOf);
}

void Journal::NoteQuarantine(const ChangeRecord& quarantine) {
  const auto data = nlohmann::json::parse(quarantine.data);
  if (data.contains("task")) bad_tasks_.insert(data.at("task").get<int64_t>());
  if (data.contains("change")) bad_changes_.insert(data.at("change").get<int64_t>());
}

bool Journal::IsInQuarantine(const ChangeRecord& change) const {
  if (bad_changes_.contains(change.id)) return true;
  if (bad_tasks_.empty()) return false;
  return bad_tasks_.contains(nlohmann::json::parse(change.data).value("task", int64_t{0}));
}

std::optional<ChangeRecord> Journal::TakeDue(const RunPosition& position) {
  while (has_due(position)) {
    ChangeRecord change = std::move(due_.front());
    due_.pop_front();
    if (!IsInQuarantine(change)) return change;
    passed_over_.push_back(std::move(change));
  }
  return std::nullopt;
}

std::optional<ChangeRecord> Journal::TakeDueNow(const RunPosition& position) {
  std::optional<ChangeRecord> change = TakeDue(position);
  if (!change) return change;
  // What comes after one that was moved to the end of this position stays after it.
  const bool is_late = PositionOf(*change) < position;
  if (!is_late && moved_to_ != position) return change;
  change->id = database_.MoveChange(change->id, position.episode, position.step);
  change->episode = position.episode;
  change->step = position.step;
  moved_to_ = position;
  return change;
}

ChangeRecord Journal::AddDone(const RunPosition& position, const std::string& kind,
                              const std::string& text, const std::string& data) {
  ChangeRecord change;
  change.episode = position.episode;
  change.step = position.step;
  change.kind = kind;
  change.text = text;
  change.data = data;
  change.id = database_.AddChange(change);
  return change;
}

void Journal::AddDue(const RunPosition& position, const std::string& kind, const std::string& text,
                     const std::string& data) {
  ChangeRecord change = AddDone(position, kind, text, data);
  due_.insert(std::ranges::upper_bound(due_, position, {}, PositionOf), std::move(change));
}

void Journal::Remove(const ChangeRecord& change) { database_.RemoveChange(change.id); }

void Journal::Quarantine(const RunPosition& position, const ChangeRecord& change,
                         const std::string& why) {
  NoteQuarantine(AddQuarantine(database_, position, {{"change", change.id}, {"why", why}},
                               fmt::format("taken back: {} ({})", change.text, why)));
}

bool CanBeBlamed(const ChangeRecord& change) {
  return change.kind != kQuarantine && change.kind != "unload" && change.kind != "module_remove";
}

void QuarantineTask(RunDatabase& database, int64_t task, const std::string& why) {
  const std::string name = TaskWithId(database.ReadRun(), task).task;
  AddQuarantine(database, {LastEpisode(database) + 1, 0}, {{"task", task}, {"why", why}},
                fmt::format("never again: {} ({})", name, why));
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
