#include "runtime/core/task/task_goals.h"

#include <utility>

#include "plugins/host/scalar_bytes.h"
#include "runtime/core/module/episode_seed.h"

namespace runtime {
namespace {

bool IsSame(const taskc_goal& a, const taskc_goal& b) {
  return std::string_view(a.name) == b.name && std::string_view(a.type) == b.type &&
         std::string_view(a.unit) == b.unit;
}

}  // namespace

TaskGoals::TaskGoals(host::TaskFrame& host)
    : host_(host), goals_(host.plugin().goals, host.plugin().goal_count), counts_(goals_.size()) {}

void TaskGoals::StartEpisode(uint64_t run_seed, int64_t episode) {
  host_.SetSeed(EpisodeSeed(run_seed, episode));
  draws_.clear();
  counts_.assign(goals_.size(), 0);
  for (size_t i = 0; i < goals_.size(); ++i) {
    if (IsHeld(i)) Note(i, 0);
  }
}

void TaskGoals::NoteDraws(double time) {
  for (size_t i = 0; i < goals_.size(); ++i) {
    const int64_t count = host_.DrawCount(goals_[i]);
    if (count == counts_[i]) continue;
    counts_[i] = count;
    Note(i, time);
  }
}

std::optional<size_t> TaskGoals::Find(std::string_view name) const {
  for (size_t i = 0; i < goals_.size(); ++i) {
    if (goals_[i].name == name) return i;
  }
  return std::nullopt;
}

std::vector<double> TaskGoals::Value(size_t goal) const {
  const taskc_goal& entry = goals_[goal];
  const std::byte* place = std::as_const(host_).Bytes(entry).data();
  std::vector<double> value;
  for (uint32_t i = 0; i < entry.rows * entry.columns; ++i) {
    value.push_back(host::LoadScalar(place + i * host::ScalarSize(entry.scalar), entry.scalar));
  }
  return value;
}

void TaskGoals::Hold(size_t goal, std::span<const double> value, double time) {
  const taskc_goal& entry = goals_[goal];
  std::byte* place = host_.Bytes(entry).data();
  for (size_t i = 0; i < value.size(); ++i) {
    host::StoreScalar(place + i * host::ScalarSize(entry.scalar), entry.scalar, value[i]);
  }
  host_.Hold(entry, true);
  Note(goal, time);
}

void TaskGoals::TakeOver(const TaskGoals& old) {
  draws_.clear();
  for (const GoalDraw& draw : old.draws_) {
    for (size_t i = 0; i < goals_.size(); ++i) {
      if (IsSame(goals_[i], old.goals_[draw.goal])) draws_.push_back({i, draw.time, draw.value});
    }
  }
  for (size_t i = 0; i < goals_.size(); ++i) counts_[i] = host_.DrawCount(goals_[i]);
}

}  // namespace runtime
