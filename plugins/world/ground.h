// Where the ground of a world is.
#pragma once

#include <vector>

#include "plugins/world/world_description.h"

namespace world {

// How high the ground is there [m].
double HeightAt(const Ground& ground, double x, double y);

// Which way is up from the ground: a unit vector. Steps and hills count as level.
Vector3 NormalOf(const Ground& ground);

// The turn that lays what is level on the ground.
Quaternion TurnOf(const Ground& ground);

// A block from z = 0 up, as wide as the world.
struct Block {
  double low_x = 0;
  double high_x = 0;
  double height = 0;
};
// The steps of stairs; of other ground nothing.
std::vector<Block> BlocksOf(const Ground& ground);

inline constexpr double kWidth = 100;  // of what is as wide as the world, or without end [m]

// The place of a thing that is put down at (x, y): turned with the ground and just touching it, or,
// where that is not even, above the highest point below. `turn`: its own, on level ground.
void PutDown(const Ground& ground, double x, double y, const Quaternion& turn, Thing& thing);

}  // namespace world
