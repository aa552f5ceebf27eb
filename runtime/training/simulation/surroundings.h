// What is around the robot in an ODE world: the ground, and the things on it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "plugins/world/world_description.h"
#include "runtime/training/simulation/robot_body.h"
#include "runtime/training/simulation/spatial.h"

namespace runtime {

// A piece of the ground. What touches it reaches below the plane  normal . place = offset  and is
// not all left of `low_x` or right of `high_x`.
struct GroundPart {
  OdeGeom geom;
  Vector3 normal{0, 0, 1};
  double offset = 0;
  double low_x = -robot::kUnlimited;
  double high_x = robot::kUnlimited;
};

// How far steps and hills go on below the plane [m].
inline constexpr double kGroundDepth = 1;

class Surroundings {
 public:
  // Makes all of it as `world` says, or flat ground where that is null. What can move becomes one
  // of the bodies of `body`. `world` and `ode` outlive the object.
  Surroundings(const world::WorldDescription* world, dWorldID ode, RobotBody& body);

  const world::WorldDescription* description() const { return world_; }  // as it was given
  const std::vector<GroundPart>& ground() const { return ground_; }
  double friction() const {
    return world_ == nullptr ? robot::kUnlimited : world_->ground.friction;
  }
  // The plane z = 0.
  bool IsFlat() const;
  // How high the ground is [m].
  double HeightAt(double x, double y) const;

  std::span<const world::Thing> things() const;
  // The number of a thing's body; of one that is fixed -1.
  int BodyOf(size_t thing) const { return bodies_[thing]; }
  dGeomID GeomOf(size_t thing, const RobotBody& body) const;

 private:
  void AddGround();
  void AddSteps();
  void AddHills(const world::HeightMap& map);
  void AddThing(const world::Thing& thing, dWorldID ode, RobotBody& body);

  struct DestroyHills {
    void operator()(dxHeightfieldData* data) const { dGeomHeightfieldDataDestroy(data); }
  };

  const world::WorldDescription* world_;
  std::unique_ptr<dxHeightfieldData, DestroyHills> hills_;  // outlives the ground
  std::vector<GroundPart> ground_;
  std::vector<int> bodies_;           // of the things
  std::vector<OdeGeom> fixed_geoms_;  // of the things; null of those that move
};

}  // namespace runtime
