// A recorded episode as an MCAP file (mcap_writer.h), in the messages that Foxglove shows.
#pragma once

#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/behavior/motion.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// Times are those of the episode, from 0. Topics:
//   /robot         foxglove.SceneUpdate: the links' shapes, each in its own frame
//   /tf            foxglove.FrameTransforms: each link's frame in `world`, in each recorded frame
//   /goal/NAME     taskc.Goal: what the robot was told, with its unit, whenever it was
//   /episode       taskc.Episode: at the end, its return, how it ended, its terms, metrics and logs
// `links` are the parts of ParseBody(), things of the world among them.
std::string McapOf(const RunRecord& run, const EpisodeRecord& episode, const Motion& motion,
                   const std::vector<robot::Link>& links);

}  // namespace runtime
