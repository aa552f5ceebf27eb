#include "runtime/analysis/study/behavior_groups.h"

#include <fmt/format.h>

#include "runtime/analysis/behavior/behavior.h"
#include "runtime/analysis/behavior/clustering.h"
#include "runtime/analysis/behavior/robot_scale.h"
#include "runtime/base/in_parallel.h"
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

// What there is to know of each run.
struct Finding {
  std::optional<RunBehavior> behavior;
  std::string note;  // what is wrong; may be empty
};

std::vector<RunBehavior> FinalBehaviors(const StudyExperiment& experiment,
                                        std::vector<std::string>& notes) {
  const RecordedBody body = ParseBody(experiment.record().body).value();
  const std::vector<robot::Link> links = body.links();
  if (links.empty()) return {};
  const double scale = ScaleOfRobot(experiment);
  std::vector<Finding> findings(experiment.runs.size());
  InParallel(findings.size(), [&](size_t i) {
    const StudyRun& run = experiment.runs[i];
    if (!run.is_finished()) return;
    try {
      const std::optional<FinalRecording> final = ReadFinalRecording(run);
      if (!final) return;
      const Motion motion = ReadMotion(final->recording, static_cast<int>(body.parts.size()));
      findings[i].behavior = {i, DescribeBehavior(OfLinks(motion, links.size()), links, scale)};
    } catch (const UserError& error) {
      findings[i].note =
          fmt::format("The last recording of {} is left out: {}.", run.name, error.what());
    }
  });
  std::vector<RunBehavior> behaviors;
  for (Finding& finding : findings) {
    if (finding.behavior) behaviors.push_back(std::move(*finding.behavior));
    if (!finding.note.empty()) notes.push_back(std::move(finding.note));
  }
  return behaviors;
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
  const auto at = [&](int number) -> const RunBehavior& {
    return behaviors[static_cast<size_t>(number)];
  };
  const auto distance = [&](int a, int b) {
    return DistanceBetween(at(a).behavior, at(b).behavior).total();
  };
  std::vector<BehaviorGroup> groups;
  for (const AlikeGroup& alike :
       GroupAlike(static_cast<int>(behaviors.size()), distance, kSameBehavior)) {
    BehaviorGroup& group = groups.emplace_back();
    for (const int member : alike.members) group.runs.push_back(at(member).run);
    group.typical = at(alike.typical).run;
  }
  return groups;
}

}  // namespace runtime
