#include "runtime/training/simulation/world.h"

#include <algorithm>
#include <cmath>

#include "runtime/training/simulation/ground_height.h"

namespace runtime {
namespace {

OdeThreading MakeThreading() {
  UseOdeInThisThread();
  return OdeThreading(dThreadingAllocateSelfThreadedImplementation());
}

SolverSettings Settings(const Profile& profile, double time_step) {
  return {.time_step = time_step, .contacts = profile.ContactSoftness(time_step)};
}

OdeWorld MakeWorld(dThreadingImplementationID threading, const SolverSettings& settings) {
  OdeWorld world(dWorldCreate());
  // ODE's default is shared between worlds and not made for several threads.
  dWorldSetStepThreadingImplementation(world.get(), dThreadingImplementationGetFunctions(threading),
                                       threading);
  dWorldSetGravity(world.get(), 0, 0, -settings.gravity);
  dWorldSetERP(world.get(), settings.erp);
  dWorldSetCFM(world.get(), settings.cfm);
  return world;
}

}  // namespace

World::World(const robot::RobotDescription& robot, const Profile& profile,
             const robot::StartState& start, const world::WorldDescription* around)
    : physics_steps_per_time_step_(profile.PhysicsStepsPerTimeStep(robot.controller.time_step)),
      settings_(Settings(profile, robot.controller.time_step / physics_steps_per_time_step_)),
      threading_(MakeThreading()),
      world_(MakeWorld(threading_.get(), settings_)),
      body_(robot, start, world_.get()),
      surroundings_(around, world_.get(), body_),
      collision_(robot, body_, surroundings_),
      controller_(robot, body_, profile, physics_time_step(), settings_.cfm),
      soundness_(robot, body_, settings_.gravity, physics_time_step()),
      contact_filter_(body_.link_count(), physics_time_step()),
      means_(body_),
      solver_(
          MakeSolver(robot, surroundings_, profile, settings_, controller_, body_, world_.get())) {
  if (!surroundings_.IsFlat() && !robot.has_fixed_base) PutOnGround(robot, start);
  collision_.Update();
  contact_filter_.Start(collision_.ground());
  for (size_t i = 0; i < surroundings_.things().size(); ++i) {
    thing_contacts_.emplace_back(body_.link_count(), physics_time_step());
    thing_contacts_.back().Start(collision_.touches(i));
  }
}

// As high above the ground below the base as on flat ground, and higher where a link would then be
// deeper in the ground than there.
void World::PutOnGround(const robot::RobotDescription& robot, const robot::StartState& start) {
  constexpr int kMostTries = 50;
  constexpr double kRounding = 1e-6;  // [m]
  const dReal* base = dBodyGetPosition(body_.body(0));
  body_.Lift(surroundings_.HeightAt(base[0], base[1]));
  const double usual = std::max(0.0, -LowestPoint(robot, OnGround(robot, start)));
  for (int i = 0; i < kMostTries; ++i) {
    collision_.Update();
    const double deeper = DepthInGround() - usual;
    if (deeper <= kRounding) return;
    body_.Lift(deeper);
  }
}

// How far the links would have to be lifted out of the ground.
double World::DepthInGround() const {
  constexpr double kSteepest = 0.1;  // walls do not let go of what is lifted
  double deepest = 0;
  for (const Contact& contact : collision_.contacts()) {
    const bool is_ground = std::min(contact.first, contact.second) == Contact::kGround;
    const bool is_link = std::max(contact.first, contact.second) < body_.link_count();
    const double up = std::abs(contact.geometry.normal[2]);
    if (is_ground && is_link && up > kSteepest)
      deepest = std::max(deepest, contact.geometry.depth / up);
  }
  return deepest;
}

void World::Push(const Vector3& velocity) {
  for (int i = 0; i < body_.link_count(); ++i) {
    const Vector3 pushed = ToEigen(dBodyGetLinearVel(body_.body(i))) + velocity;
    dBodySetLinearVel(body_.body(i), pushed[0], pushed[1], pushed[2]);
  }
  soundness_.Restart();
}

void World::Step(std::span<const double> targets) {
  controller_.Update(targets);
  soundness_.Check(controller_);
  collision_.Update();
  try {
    solver_->Step(collision_.contacts(), controller_, means_.impulses());
  } catch (const OdeFailure&) {
    KeepForever(std::move(threading_));
    throw;
  }
  body_.CountTurns();
  const std::span<const unsigned char> found = solver_->ground();
  contact_filter_.Update(found.empty() ? collision_.ground() : found);
  for (size_t i = 0; i < thing_contacts_.size(); ++i) {
    const std::span<const unsigned char> touching = solver_->touches(i);
    thing_contacts_[i].Update(touching.empty() ? collision_.touches(i) : touching);
  }
  means_.Add(physics_time_step());
  if (!body_.IsPlausible()) throw OdeFailure("a link moves faster than anything can");
}

}  // namespace runtime
