// The database of one run: DIR/run.db (schema.sql). One program writes it, any number read it at
// the same time (write-ahead log). What was saved once stays, whatever happens to the trainer.
//
// All functions throw UserError, naming the file, what failed and the remedy: RecordError where it
// cannot be read or written. Those that read check what they read: of a database that was damaged
// they give what is right, or throw.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

struct RunAndEpisodes {
  RunRecord run;
  std::vector<EpisodeRecord> episodes;  // their tasks are among the run's
};

class RunDatabase {
 public:
  // Makes the folder and a new run in it, in the state `running`: all of it or, where the program
  // is killed meanwhile, nothing that counts as a run. Refuses a folder that holds a run.
  static RunDatabase Create(const std::filesystem::path& folder, const RunRecord& run);
  // To continue a run. Refuses a run that another trainer works on.
  static RunDatabase Open(const std::filesystem::path& folder);
  static RunDatabase OpenToRead(const std::filesystem::path& folder);
  // Whether `folder` holds a run; also one that cannot be read.
  static bool Exists(const std::filesystem::path& folder);
  // Whether a trainer was killed in it, or works in it, before its run was made. A run can be made
  // there as in any folder without one.
  static bool IsUnfinished(const std::filesystem::path& folder);
  // Throws if it holds a run.
  static void CheckIsFree(const std::filesystem::path& folder);

  RunDatabase(RunDatabase&&) noexcept;
  RunDatabase& operator=(RunDatabase&&) noexcept;
  ~RunDatabase();

  RunRecord ReadRun() const;
  RunAndEpisodes ReadRunAndEpisodes() const;  // of one moment
  // What a trainer that was killed left behind reads as interrupted.
  RunState ReadState() const;
  std::string ReadValue(const std::string& key) const;  // of the table `run`; "" if there is none
  std::vector<EpisodeRecord> ReadEpisodes() const;      // ascending, with all their values
  std::vector<CurveRecord> ReadLearnerCurves() const;   // in the order in which it shows them
  std::vector<ChangeRecord> ReadChanges() const;        // in the order in which they were added
  std::optional<Checkpoint> ReadCheckpoint() const;
  int64_t ReadCheckpointEpisode() const;  // from which a run continues; 0 if there is no checkpoint
  std::optional<Recording> ReadRecording(int64_t episode) const;
  int64_t ReadLastRecordedEpisode() const;                    // 0 if there is none
  std::vector<RecordedEpisode> ReadRecordedEpisodes() const;  // ascending

  // All of these at once or nothing. `tape`: that of the recording (runtime/training/run/tape.h),
  // or empty.
  void AddEpisode(const EpisodeRecord& episode, const std::optional<Recording>& recording,
                  const std::optional<Checkpoint>& checkpoint, const std::string& tape = {});
  void WriteCheckpoint(const Checkpoint& checkpoint);
  // Returns the id that the task, or the change, has from now on; the record's own does not count.
  int64_t AddTask(const TaskRecord& task);
  int64_t AddChange(const ChangeRecord& change);
  // What the learner is going to show of each episode, also where it has shown something else up to
  // now. Other values of an episode are not saved.
  void SetLearnerCurves(const std::vector<CurveRecord>& curves);
  // Where in the run a change takes effect, after all that stand there already. Returns its new id.
  int64_t MoveChange(int64_t id, int64_t episode, int64_t step);
  void RemoveChange(int64_t id);
  // Deletes the episodes after `episode` with all that belongs to them. Changes stay.
  void DeleteEpisodesAfter(int64_t episode);
  // Also notes the time at which the run was finished or interrupted.
  void SetState(RunState state);
  void SetEpisodesPlanned(int64_t episodes);

 private:
  struct Impl;
  explicit RunDatabase(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace runtime
