// A made-up run with two reward terms, one metric, two logs, a goal and two phases.
#pragma once

#include "runtime/training/run/run_records.h"

namespace runtime {

inline TaskRecord SampleTask() {
  TaskRecord task;
  task.id = 1;
  task.module = "task";
  task.task = "crawling";
  task.task_file = "tasks/crawling.task";
  task.task_hash = "0123abcd";
  task.plugin = "plugin-0123.so";
  task.compiler = "taskc 0.1.0";
  task.terms = {{"speed", "forward speed"}, {"fall", ""}};
  task.metrics = {{"distance", "m", "last", "how far it got"}};
  task.logs = {{"speed", "m/s", "mean", "while it moves"}, {"falls", "", "sum", ""}};
  task.goals = {{"place", "vec2", "m", "where to go"}};
  task.phases = {{"reach", "get there"}, {"lift", ""}};
  task.sources = {{"tasks/crawling.task", "task crawling for humanoid\n"},
                  {"tasks/shaping.task", "fn double(x: real) -> real = 2 * x\n"}};
  return task;
}

// Another version, with one more term in front and without a log.
inline TaskRecord SampleVersion() {
  TaskRecord task = SampleTask();
  task.id = 2;
  task.task_hash = "4567cdef";
  task.terms.insert(task.terms.begin(), {"effort", ""});
  task.logs.clear();
  task.goals.clear();
  task.phases.clear();
  return task;
}

inline RunRecord SampleRun() {
  RunRecord run;
  run.robot = "humanoid";
  run.robot_description = "name = \"humanoid\"\n";
  run.agent = "[modules.learner]\ntype = \"PengQLambda\"\n";
  run.profile = "fast";
  run.version = "0.1.0";
  run.body = "[]";
  run.seed = 18446744073709551615u;
  run.episodes_planned = 1000;
  run.record_every = 50;
  run.checkpoint_seconds = 0.1;
  run.tasks = {SampleTask()};
  return run;
}

inline EpisodeRecord SampleEpisode(int64_t number) {
  EpisodeRecord episode;
  episode.number = number;
  episode.active.task = 1;
  episode.active.episode_return = 0.1 * static_cast<double>(number) - 1e-17;
  episode.active.end_kind = "truncated";
  episode.active.end_reason = "time is over";
  episode.steps = 4000 + number;
  episode.actions = 80;
  episode.simulated_seconds = 20.005;
  episode.wall_seconds = 4.5;
  episode.cpu_seconds = 4.25;
  episode.active.faults = 2;
  episode.active.terms = {1.0 / 3.0, -4};
  episode.active.violations = 3;
  episode.active.metrics = {0.25};
  episode.active.logs = {0.125, 7};
  episode.active.goals = {{0, 0, {0.1, -2}}, {0, 3.005, {1e-9, 1.0 / 3.0}}};
  episode.active.phases = {{1.5, 0.1}, {18.505, -4.0 / 3.0}};
  return episode;
}

// What SampleVersion() says of it.
inline Evaluation SampleShadow() {
  return {.task = 2,
          .episode_return = -1.5,
          .end_kind = "failure",
          .end_reason = "fell",
          .faults = 0,
          .violations = 1,
          .terms = {0.5, 1, -4},
          .metrics = {0.75},
          .logs = {},
          .goals = {},
          .phases = {}};
}

}  // namespace runtime
