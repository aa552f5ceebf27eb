#include <algorithm>
#include <utility>

#include "runtime/training/simulation/robot_sensors.h"

namespace runtime {
namespace {

size_t CountOf(const world::ThingSensor& sensor, const robot::RobotDescription& robot) {
  constexpr size_t kVector = 3, kQuaternion = 4;
  switch (sensor.quantity) {
    case world::Quantity::kPosition:
    case world::Quantity::kVelocity:
    case world::Quantity::kAngularVelocity:
      return kVector;
    case world::Quantity::kOrientation:
      return kQuaternion;
    case world::Quantity::kContact:
      break;
  }
  return robot.links.size();
}

}  // namespace

ThingSensor::ThingSensor(const SensorMoment& moment, world::ThingSensor description,
                         const robot::RobotDescription& robot)
    : LazySensor(moment, description.type, CountOf(description, robot)),
      description_(std::move(description)) {}

void ThingSensor::Compute() {
  const int index = world().surroundings().BodyOf(description_.thing);
  const bool is_fixed = index < 0 && description_.quantity != world::Quantity::kContact;
  if (is_fixed) return ComputeFixed(world().surroundings().things()[description_.thing]);
  const RobotBody& body = world().body();
  switch (description_.quantity) {
    case world::Quantity::kPosition:
      std::copy_n(dBodyGetPosition(body.body(index)), 3, reals());
      return;
    case world::Quantity::kOrientation:
      std::copy_n(dBodyGetQuaternion(body.body(index)), 4, reals());
      return;
    case world::Quantity::kVelocity:
      std::copy_n(dBodyGetLinearVel(body.body(index)), 3, reals());
      return;
    case world::Quantity::kAngularVelocity:
      std::copy_n(dBodyGetAngularVel(body.body(index)), 3, reals());
      return;
    case world::Quantity::kContact:
      for (int i = 0; i < body.link_count(); ++i)
        flags()[i] = world().contacts_with(description_.thing).flag(i);
      return;
  }
}

// Its velocities stay 0.
void ThingSensor::ComputeFixed(const world::Thing& thing) {
  if (description_.quantity == world::Quantity::kPosition)
    std::ranges::copy(thing.position, reals());
  if (description_.quantity == world::Quantity::kOrientation)
    std::ranges::copy(thing.orientation, reals());
}

}  // namespace runtime
