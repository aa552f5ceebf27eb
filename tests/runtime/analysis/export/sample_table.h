// The table of a made-up run of two episodes, the second of another version of its task.
#pragma once

#include "runtime/analysis/export/episode_table.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {

inline EpisodeTable SampleTable() {
  const TemporaryFolder folder;
  RunDatabase database = RunDatabase::Create(folder.path() / "run", SampleRun());
  database.AddTask(SampleVersion());
  database.SetLearnerCurves({{"kl", "", "", "how far the policy moved"}});
  EpisodeRecord first = SampleEpisode(1);
  first.learner = {{"kl", 0.015625}};
  database.AddEpisode(first, {}, {});
  EpisodeRecord second = SampleEpisode(2);
  second.active = SampleShadow();
  database.AddEpisode(second, {}, {});
  return ReadEpisodeTable(database);
}

}  // namespace runtime
