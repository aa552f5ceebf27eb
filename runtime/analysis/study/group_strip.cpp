#include "runtime/analysis/study/group_strip.h"

#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/snapshot_strip.h"
#include "runtime/training/run/body_json.h"
#include "runtime/training/run/recorded_ground.h"

namespace runtime {

GroupStrip DrawGroupStrip(const ExperimentResult& result, const BehaviorGroup& group, int height) {
  const RunRecord& record = result.experiment->record();
  const RecordedBody body = ParseBody(record.body).value();
  const StripOptions options{.height = height, .things = body.things, .ground = GroundOf(record)};
  const FinalRecording final = *ReadFinalRecording(*result.runs[group.typical].run);
  const Motion motion = ReadMotion(final.recording, static_cast<int>(body.parts.size()));
  return {final.episode, SnapshotTimes(motion, options),
          SnapshotStrip(motion, body.parts, options)};
}

}  // namespace runtime
