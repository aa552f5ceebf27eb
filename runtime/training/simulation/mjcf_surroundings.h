// What is around a robot as MJCF says it: the ground, and the things on it.
#pragma once

#include <string>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/mjcf_text.h"
#include "runtime/training/simulation/robot_body.h"
#include "runtime/training/simulation/surroundings.h"

namespace runtime {

// Names that no link can have. A thing that moves is a body with a free joint; body, joint and geom
// are called alike, and a fixed thing is a geom of the world with that name.
std::string MjcfNameOf(const world::Thing& thing);

// The file in which a model with hills finds their heights, in MuJoCo's own format for them.
inline constexpr const char* kHillsFile = "hills.hf";
// What is in it; nothing where there are no hills.
std::string HillsFile(const Surroundings& around);

void AppendAssets(const Surroundings& around, MjcfText& text);
void AppendGround(const Surroundings& around, MjcfText& text);
// After the robot, so that its coordinates are the first.
void AppendThings(const Surroundings& around, const RobotBody& body, MjcfText& text);
// What touches the ground and the things. A fixed base touches neither the ground nor fixed things.
void AppendPairs(const robot::RobotDescription& robot, const Surroundings& around, MjcfText& text);

}  // namespace runtime
