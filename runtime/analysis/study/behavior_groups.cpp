#include "runtime/analysis/study/behavior_groups.h"

#include <fmt/format.h>

#include "runtime/analysis/behavior/behavior.h"
#include "runtime/analysis/behavior/clustering.h"
#include "runtime/analysis/behavior/robot_scale.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

double ScaleOfRobot(const StudyExperiment& experiment) {
  const ScratchFolder scratch;
  return ScaleOf(ReadKeptRobot(scratch.path(), experiment.record().robot_description));
}

struct RunBehavior {
  size_t run = 0;
  Behavior behavior;
};

std::vector<RunBehavior> FinalBehaviors(const StudyExperiment& experiment,
                                        std::vector<std::string>& notes) {
  std::vector<RunBehavior> behaviors;
  const RecordedBody body = ParseBody(experiment.record().body).value();
  const std::vector<robot::Link> links = body.links();
  if (links.empty()) return behaviors;
  const double scale = ScaleOfRobot(experiment);
  for (size_t i = 0; i < experiment.runs.size(); ++i) {
    const StudyRun& run = experiment.runs[i];
    if (!run.is_finished()) continue;
    try {
      const std::optional<FinalRecording> final = ReadFinalRecording(run);
      if (!final) continue;
      const Motion motion = ReadMotion(final->recording, static_cast<int>(body.parts.size()));
      behaviors.push_back({i, DescribeBehavior(OfLinks(motion, links.size()), links, scale)});
    } catch (const UserError& error) {
      notes.push_back(
          fmt::format("The last recording of {} is left out: {}.", run.name, error.what()));
    }
  }
  return behaviors;
}

Eigen::MatrixXd Distances(const std::vector<RunBehavior>& behaviors) {
  const auto count = static_cast<Eigen::Index>(behaviors.size());
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = a + 1; b < count; ++b) {
      const double distance = DistanceBetween(behaviors[static_cast<size_t>(a)].behavior,
                                              behaviors[static_cast<size_t>(b)].behavior)
                                  .total();
      distances(a, b) = distances(b, a) = distance;
    }
  }
  return distances;
}

}  // namespace

std::string GroupName(size_t group) {
  constexpr size_t kLetters = 26;
  const std::string last(1, static_cast<char>('A' + group % kLetters));
  return group < kLetters ? last : GroupName(group / kLetters - 1) + last;
}

std::optional<FinalRecording> ReadFinalRecording(const StudyRun& run) {
  const RunDatabase database = RunDatabase::OpenToRead(run.folder);
  const int64_t episode = database.ReadLastRecordedEpisode();
  std::optional<Recording> recording = database.ReadRecording(episode);
  if (!recording) return std::nullopt;
  return FinalRecording{episode, std::move(*recording)};
}

std::vector<BehaviorGroup> GroupBehaviors(const StudyExperiment& experiment,
                                          std::vector<std::string>& notes) {
  const std::vector<RunBehavior> behaviors = FinalBehaviors(experiment, notes);
  const Eigen::MatrixXd distances = Distances(behaviors);
  const auto run_of = [&](int behavior) { return behaviors[static_cast<size_t>(behavior)].run; };
  std::vector<BehaviorGroup> groups;
  for (const std::vector<int>& members : Cluster(distances, kSameBehavior)) {
    BehaviorGroup& group = groups.emplace_back();
    for (const int member : members) group.runs.push_back(run_of(member));
    group.typical = run_of(MostTypical(distances, members));
  }
  return groups;
}

}  // namespace runtime
