// The runs of a folder, sorted by what they are runs of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/training/run/policy_evaluation.h"
#include "runtime/training/run/run_database.h"

namespace runtime {

struct StudyRun {
  std::filesystem::path folder;
  std::string name;  // of the folder, as seen from the study's
  RunRecord record;
  RunState state = RunState::kInterrupted;
  std::vector<EpisodeRecord> episodes;
  size_t changes = 0;                         // that were made to it while it learned
  std::vector<PolicyEvaluation> evaluations;  // of what it has learned last

  bool is_finished() const;  // all planned episodes are done
};

// Runs of one task, robot, profile and agent, which differ in their seeds only. At least one.
struct StudyExperiment {
  std::string name;  // of the folder that they are in, else TASK-PROFILE
  std::vector<StudyRun> runs;

  const RunRecord& record() const { return runs.front().record; }
  const TaskRecord& task() const { return record().tasks.front(); }
};

struct Study {
  std::vector<StudyExperiment> experiments;  // in the order of their first runs
  std::vector<std::string> notes;            // which runs are missing, or not like the others
};

// `runs`: folders of runs in `folder`, or `folder` itself. Runs of one folder that do not belong
// together are experiments of their own. A run that cannot be read is left out with a note; one
// that was changed while it learned stays, with a note.
Study ReadStudyRuns(const std::filesystem::path& folder,
                    const std::vector<std::filesystem::path>& runs);

}  // namespace runtime
