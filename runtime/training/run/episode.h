// One episode of a graph, from its start to its end.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "runtime/training/environment/environment.h"
#include "runtime/training/learning/learner.h"
#include "runtime/training/run/run_records.h"
#include "runtime/training/run/task_modules.h"

namespace runtime {

// What an episode needs of a graph, which outlives this.
struct EpisodeModules {
  Environment& environment;
  Learner& learner;
  const TaskModules& tasks;
};

// Called with 0 when the episode has started, then after each time step with their number.
using AfterStep = std::function<void(int64_t steps)>;

// Called when the episode has started, with what the task drew for its start.
using NoteStart = std::function<void(const std::optional<robot::StartState>& drawn)>;

// An episode in parts, for who runs its time steps between other things: StartEpisode(), then
// Environment::RunTimeStep() until the learner says that it is over.
void StartEpisode(int64_t number, const EpisodeModules& modules, const NoteStart& note_start = {});
// Of an episode that is over; without the time that it took.
EpisodeRecord RecordOfEpisode(int64_t number, int64_t steps, const EpisodeModules& modules);

// Runs an episode; `number` is its own. `tasks` may change in `after_step`: the record is of those
// at the end.
EpisodeRecord RunEpisode(int64_t number, const EpisodeModules& modules, const AfterStep& after_step,
                         const NoteStart& note_start = {});

// What the learner shows of the episode that ran last, and what it has passed over in it; and what
// was random in that.
void NoteLearner(const Learner& learner, const Environment& environment, EpisodeRecord& episode);

}  // namespace runtime
