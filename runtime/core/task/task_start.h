// How a task draws the first state of an episode.
#pragma once

#include <cstdint>
#include <optional>

#include "plugins/host/task_frame.h"
#include "plugins/robot/start_state.h"

namespace runtime {

// Nothing where the task names no pose. What is drawn follows from the frame's seed, its params,
// the memory of the run, and `attempt`: how many states were drawn for this episode before, all in
// the same pose and with the same goals. Throws UserError where the task lets a joint begin beyond
// its stops, or something begin at what is no finite number: the robot is another one than it was
// built for. Precondition: the task fits the robot (robot_check.h).
std::optional<robot::StartState> DrawStart(host::TaskFrame& host,
                                           const robot::RobotDescription& robot, uint32_t attempt);

}  // namespace runtime
