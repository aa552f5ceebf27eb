#include "runtime/analysis/study/group_strip.h"

#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/snapshot_strip.h"
#include "runtime/training/run/body_json.h"

namespace runtime {

GroupStrip DrawGroupStrip(const ExperimentResult& result, const BehaviorGroup& group, int height) {
  const StripOptions options{.height = height};
  const std::vector<robot::Link> links = ParseBody(result.experiment->record().body).value();
  const FinalRecording final = *ReadFinalRecording(*result.runs[group.typical].run);
  const Motion motion = ReadMotion(final.recording, static_cast<int>(links.size()));
  return {final.episode, SnapshotTimes(motion, options), SnapshotStrip(motion, links, options)};
}

}  // namespace runtime
