#include "runtime/training/simulation/world.h"

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
             const robot::StartState& start)
    : physics_steps_per_time_step_(profile.PhysicsStepsPerTimeStep(robot.controller.time_step)),
      settings_(Settings(profile, robot.controller.time_step / physics_steps_per_time_step_)),
      threading_(MakeThreading()),
      world_(MakeWorld(threading_.get(), settings_)),
      body_(robot, start, world_.get()),
      collision_(robot, body_),
      controller_(robot, body_, profile, physics_time_step(), settings_.cfm),
      soundness_(robot, body_, settings_.gravity, physics_time_step()),
      contact_filter_(body_.link_count(), physics_time_step()),
      means_(body_),
      solver_(MakeSolver(robot, profile, settings_, controller_, body_, world_.get())) {
  collision_.Update();
  contact_filter_.Start(collision_.ground());
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
  contact_filter_.Update(collision_.ground());
  means_.Add(physics_time_step());
  if (!body_.IsPlausible()) throw OdeFailure("a link moves faster than anything can");
}

}  // namespace runtime
