// Folders of many runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/command_line/command.h"
#include "runtime/live/workers/supervisor.h"
#include "runtime/trainer/runs/run_session.h"

namespace runtime {

// Of the run with this seed among many: FOLDER/seed3.
std::filesystem::path SeedFolder(const std::filesystem::path& folder, uint64_t seed);

// The runs in `folder`, and in the folders in it, in the order of their names with numbers taken as
// numbers. None where `folder` is a run itself.
std::vector<std::filesystem::path> FindRuns(const std::filesystem::path& folder);

// Says on standard error which folders in `folder` a trainer began to make runs in, and was ended
// before they were runs.
void WarnOfUnfinishedRuns(const std::filesystem::path& folder);

// How far each of these runs of `folder` is; of one that cannot be read, that it has failed, and
// why, which is also said on standard error. On all cores.
std::vector<RunProgress> ReadProgressOrFailures(const std::filesystem::path& folder,
                                                const std::vector<std::filesystem::path>& runs);

// --jobs; `what`: "how many runs to train at a time"; 0 stands for as many as there are cores.
void AddJobsOption(command_line::Command& command, int& jobs, const std::string& what);
int JobsOrCores(int jobs);
// The same for the episodes of a run: no more than can be watched.
int EpisodesAtATime(int jobs);

// How far these runs of `folder` are; those that are not over wait.
std::vector<RunProgress> RunsToTrain(const std::filesystem::path& folder,
                                     const std::vector<std::filesystem::path>& runs);
// What a worker is called with that trains a run on from its last checkpoint. Where those that wait
// of `runs` are fewer than `jobs`, each runs several episodes at a time.
WorkerWords WordsToTrain(const std::vector<RunProgress>& runs, int jobs);

// Trains these runs of `folder` to their end, in this order, from their last checkpoints, `jobs` at
// a time; returns the exit status.
int TrainRuns(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& runs,
              int jobs, const OutputOptions& output);

}  // namespace runtime
