#include "runtime/trainer/rescore/rescore_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/record_error.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_files.h"
#include "runtime/training/run/tape_recorder.h"

namespace runtime {
namespace {

template <class Score>
double MeanOver(const std::vector<RescoredEpisode>& episodes, Score score) {
  double sum = 0;
  for (const RescoredEpisode& episode : episodes) sum += score(episode);
  return sum / static_cast<double>(episodes.size());
}

double RecordedReturn(const RescoredEpisode& episode) { return episode.recorded_return; }
double NewReturn(const RescoredEpisode& episode) { return episode.new_task.episode_return; }

class RunRescorer {
 public:
  RunRescorer(const std::filesystem::path& folder, std::shared_ptr<const Plugin> new_task)
      : folder_(folder),
        database_(RunDatabase::OpenToRead(folder)),
        recorded_(database_.ReadRecordedEpisodes()),
        episodes_(database_.ReadEpisodes()),
        run_(database_.ReadRun()),
        robot_(ReadKeptRobot(scratch_.path(), run_.robot_description)),
        new_task_(std::move(new_task)) {}

  RescoredRun Rescore(const std::string& name, int64_t only, const StopRequest& stop) {
    CheckIsRecorded(only);
    RescoredRun rescored{name, run_.tasks.front().task, run_.profile, {}, {}};
    bool has_tapes = false;
    for (const RecordedEpisode& each : recorded_) {
      if (stop.signal() != 0) break;
      if (only != 0 && each.number != only) continue;
      const EpisodeRecord& episode = episodes_.at(static_cast<size_t>(each.number - 1));
      const std::optional<Recording> recording = database_.ReadRecording(each.number);
      if (!recording) continue;
      const std::string tape = ReadTape(folder_, each.number);
      has_tapes |= !tape.empty();
      try {
        rescored.episodes.push_back(
            RescorerOf(episode.active.task).Rescore(episode, *recording, tape));
      } catch (const RecordError&) {
        throw;
      } catch (const UserError& error) {
        if (rescorers_.empty()) throw;  // the task does not fit
        rescored.left_out.emplace_back(error.what());
      }
    }
    if (rescored.episodes.empty() && stop.signal() == 0) Refuse(has_tapes, rescored);
    return rescored;
  }

 private:
  // One for each task that was active in an episode.
  Rescorer& RescorerOf(int64_t task) {
    const auto known = rescorers_.find(task);
    if (known != rescorers_.end()) return *known->second;
    const auto plugin =
        std::make_shared<const Plugin>(FindKeptPlugin(folder_, TaskWithId(run_, task).plugin));
    auto made = std::make_unique<Rescorer>(robot_, run_.profile, run_.seed, plugin, new_task_);
    return *rescorers_.emplace(task, std::move(made)).first->second;
  }

  void CheckIsRecorded(int64_t episode) const {
    if (episode == 0 ||
        std::ranges::find(recorded_, episode, &RecordedEpisode::number) != recorded_.end())
      return;
    throw UserError(
        fmt::format("{}: episode {} is not recorded; `trainer rescore {}` judges those that are",
                    folder_.string(), episode, folder_.string()));
  }

  [[noreturn]] void Refuse(bool has_tapes, const RescoredRun& rescored) const {
    if (has_tapes) throw UserError(folder_.string() + ": " + rescored.left_out.back());
    throw UserError(fmt::format(
        "{}: none of its recorded episodes was recorded with what it was driven by: older versions "
        "of the trainer do not do that, nor is it done for episodes longer than {:.0f} s; train "
        "again, with `--record-every N` for more episodes",
        folder_.string(), TapeRecorder::kMaximumDuration));
  }

  const std::filesystem::path& folder_;
  const ScratchFolder scratch_;
  const RunDatabase database_;
  // In this order: of a run that is being trained, what each leads to is in the next one.
  const std::vector<RecordedEpisode> recorded_;
  const std::vector<EpisodeRecord> episodes_;
  const RunRecord run_;
  const robot::RobotDescription robot_;
  const std::shared_ptr<const Plugin> new_task_;
  std::map<int64_t, std::unique_ptr<Rescorer>> rescorers_;
};

}  // namespace

double RescoredRun::recorded_return() const { return MeanOver(episodes, RecordedReturn); }
double RescoredRun::new_return() const { return MeanOver(episodes, NewReturn); }

RescoredRun RescoreRun(const std::filesystem::path& folder, const std::string& name,
                       const std::shared_ptr<const Plugin>& new_task, int64_t episode,
                       const StopRequest& stop) {
  return RunRescorer(folder, new_task).Rescore(name, episode, stop);
}

RankCorrelation OrderOf(const RescoredRun& run) {
  std::vector<double> old_returns, new_returns;
  for (const RescoredEpisode& episode : run.episodes) {
    old_returns.push_back(RecordedReturn(episode));
    new_returns.push_back(NewReturn(episode));
  }
  return RankCorrelationOf(old_returns, new_returns);
}

RankCorrelation OrderOf(const std::vector<RescoredRun>& runs) {
  std::vector<double> old_returns, new_returns;
  for (const RescoredRun& run : runs) {
    old_returns.push_back(run.recorded_return());
    new_returns.push_back(run.new_return());
  }
  return RankCorrelationOf(old_returns, new_returns);
}

}  // namespace runtime
