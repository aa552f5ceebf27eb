// What a MuJoCo model says of its bodies, as links of a robot take it.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace runtime {

// Mass, and how it lies, in the world's frame where the model's joints are at their references.
struct MassPart {
  double mass = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the center

  // Both together; `other` may have a negative mass, which takes it away.
  void Add(const MassPart& other);
};

// Whether there can be a body with this inertia.
bool IsPossible(const mjModel& model, int body);

// Nothing for a body that the model gives no mass. An inertia that no body has is changed where it
// is smallest.
MassPart MassOf(const mjModel& model, const mjData& data, int body);

// A shape in the world's frame: its link's frame is not known yet.
struct ShapePart {
  robot::LinkShape shape;  // without position and orientation
  Eigen::Vector3d position;
  Eigen::Quaterniond orientation;
  double volume = 0;
  double friction = 0;
  int contype = 0, conaffinity = 0;
  std::string approximated;  // what the shape stands for, or empty
  std::string mesh;          // MuJoCo's name of it, or empty
};

// The vertices of a mesh, in the frame of the shapes that have it.
std::vector<Eigen::Vector3d> VerticesOf(const mjModel& model, int mesh);

// The shapes with which the body touches others.
std::vector<ShapePart> ShapesOf(const mjModel& model, const mjData& data, int body);

// The box of uniform density that has this mass and inertia.
ShapePart BoxOf(const MassPart& part);

robot::Vector3 ToArray(const Eigen::Vector3d& v);
std::vector<robot::Vector3> ToArrays(const std::vector<Eigen::Vector3d>& points);
robot::Inertia ToInertia(const Eigen::Matrix3d& m);

std::string NameIn(const mjModel& model, mjtObj type, int index);

}  // namespace runtime
