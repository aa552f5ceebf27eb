#pragma once

#include "plugins/robot/robot_description.h"
#include "runtime/core/task/plugin.h"

namespace runtime {

// Throws UserError, naming the plugin's file and the remedy, unless the robot is the one that the
// task is for and has every sensor that the task reads, with its type, unit and number of elements.
// In a run without a robot all sensors come from other modules, and the task must be for none.
void CheckFitsRobot(const Plugin& plugin, const robot::RobotDescription& robot);

// Throws UserError likewise if the task names a world, and it is not that of the task with which
// the run began.
void CheckFitsWorld(const Plugin& plugin, const Plugin& first);

}  // namespace runtime
