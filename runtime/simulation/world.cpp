#include "runtime/simulation/world.h"

namespace runtime {
namespace {

OdeThreading MakeThreading() {
  UseOdeInThisThread();
  return OdeThreading(dThreadingAllocateSelfThreadedImplementation());
}

OdeWorld MakeWorld(dThreadingImplementationID threading) {
  OdeWorld world(dWorldCreate());
  // ODE's default is shared between worlds and not made for several threads.
  dWorldSetStepThreadingImplementation(world.get(), dThreadingImplementationGetFunctions(threading),
                                       threading);
  dWorldSetGravity(world.get(), 0, 0, -9.8);
  dWorldSetERP(world.get(), 0.2);
  dWorldSetCFM(world.get(), 1e-5);
  return world;
}

}  // namespace

World::World(const robot::RobotDescription& robot, const Profile& profile, const robot::Pose& pose)
    : steps_per_control_step_(profile.StepsPerControlStep(robot.controller.time_step)),
      time_step_(robot.controller.time_step / steps_per_control_step_),
      threading_(MakeThreading()),
      world_(MakeWorld(threading_.get())),
      body_(robot, pose, world_.get()),
      collision_(robot, body_, world_.get(), profile.ContactSoftness(time_step_)),
      controller_(robot, body_, world_.get(), profile.drive, time_step_),
      contact_filter_(body_.link_count(), time_step_) {
  collision_.Update();
  contact_filter_.Start(collision_.ground());
}

void World::Step(std::span<const double> targets) {
  controller_.Apply(targets);
  collision_.Update();
  try {
    dWorldStep(world_.get(), time_step_);
  } catch (const OdeFailure&) {
    KeepForever(std::move(threading_));
    throw;
  }
  contact_filter_.Update(collision_.ground());
  if (!body_.IsPlausible()) throw OdeFailure("a link moves faster than anything can");
}

}  // namespace runtime
