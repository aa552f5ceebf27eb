// What a MuJoCo model says of its sites, and of frames that a robot has as sites.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace runtime {

// In the world's frame where the model's joints are at their references.
struct SitePart {
  std::string name;  // "" where the model has none
  Eigen::Vector3d position;
  Eigen::Quaterniond orientation;
};

// The body's own frame, under its name.
SitePart FrameOf(const mjModel& model, const mjData& data, int body);

// The body's sites, in the model's order.
std::vector<SitePart> SitesOf(const mjModel& model, const mjData& data, int body);

}  // namespace runtime
