#pragma once

#include <taskc/plugin.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "plugins/host/task_frame.h"

namespace runtime {

// A goal that the robot was told, by the task or by a client.
struct GoalDraw {
  size_t goal = 0;            // its number in the task
  double time = 0;            // [s] since the start of the episode
  std::vector<double> value;  // in SI units; a bool is 0 or 1
  bool operator==(const GoalDraw&) const = default;
};

// The goals of one instance of a task, and what they were in the current episode.
class TaskGoals {
 public:
  // Refers to `host`, which must outlive this.
  explicit TaskGoals(host::TaskFrame& host);

  // Before the event at the start of an episode. What is drawn in it depends on these two alone.
  void StartEpisode(uint64_t run_seed, int64_t episode);
  // After each event: notes what it has drawn. Allocates only where it has drawn something.
  void NoteDraws(double time);

  std::span<const taskc_goal> goals() const { return goals_; }
  // The goal of this name, or nothing.
  std::optional<size_t> Find(std::string_view name) const;
  std::vector<double> Value(size_t goal) const;
  bool IsHeld(size_t goal) const { return host_.IsHeld(goals_[goal]); }
  // Of the current episode, in their order. A goal that is held is noted at the start of each.
  const std::vector<GoalDraw>& draws() const { return draws_; }

  // From now on the goal has this value: as many numbers as it has elements, whole ones for a goal
  // of ints or bools. The task does not draw it until Release().
  void Hold(size_t goal, std::span<const double> value, double time);
  // The task draws the goal again, at its next occasion.
  void Release(size_t goal) { host_.Hold(goals_[goal], false); }

  // Goes on in the episode of `old`, whose memory the host has taken over.
  void TakeOver(const TaskGoals& old);

 private:
  void Note(size_t goal, double time) { draws_.push_back({goal, time, Value(goal)}); }

  host::TaskFrame& host_;
  std::span<const taskc_goal> goals_;
  std::vector<int64_t> counts_;  // of each goal's draws that have been noted
  std::vector<GoalDraw> draws_;
};

}  // namespace runtime
