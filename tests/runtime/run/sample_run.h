// A made-up run with two reward terms, one metric and two logs.
#pragma once

#include "runtime/run/run_records.h"

namespace runtime {

inline RunRecord SampleRun() {
  RunRecord run;
  run.task = "crawling";
  run.task_file = "tasks/crawling.task";
  run.task_hash = "0123abcd";
  run.plugin = "plugin-0123.so";
  run.robot = "humanoid";
  run.robot_description = "name = \"humanoid\"\n";
  run.agent = "[modules.learner]\ntype = \"PengQLambda\"\n";
  run.profile = "fast";
  run.version = "0.1.0";
  run.compiler = "taskc 0.1.0";
  run.body = "[]";
  run.seed = 18446744073709551615u;
  run.episodes_planned = 1000;
  run.record_every = 50;
  run.checkpoint_seconds = 0.1;
  run.terms = {{"speed", "forward speed"}, {"fall", ""}};
  run.metrics = {{"distance", "m", "last", "how far it got"}};
  run.logs = {{"speed", "m/s", "mean", "while it moves"}, {"falls", "", "sum", ""}};
  run.sources = {{"tasks/crawling.task", "task crawling for humanoid\n"},
                 {"tasks/shaping.task", "fn double(x: real) -> real = 2 * x\n"}};
  return run;
}

inline EpisodeRecord SampleEpisode(int64_t number) {
  EpisodeRecord episode;
  episode.number = number;
  episode.episode_return = 0.1 * static_cast<double>(number) - 1e-17;
  episode.end_kind = "truncated";
  episode.end_reason = "time is over";
  episode.steps = 4000 + number;
  episode.actions = 80;
  episode.simulated_seconds = 20.005;
  episode.wall_seconds = 4.5;
  episode.faults = 2;
  episode.terms = {1.0 / 3.0, -4};
  episode.violations = 3;
  episode.metrics = {0.25};
  episode.logs = {0.125, 7};
  return episode;
}

}  // namespace runtime
