#include "runtime/training/simulation/robot_sensors.h"

#include <algorithm>
#include <cassert>

namespace runtime {
namespace {

void Copy(const dReal* from, size_t count, double* to) { std::copy_n(from, count, to); }

// Column `index` of ODE's rotation matrix, which has rows of four.
void CopyColumn(const dReal* rotation, int index, double* to) {
  for (int row = 0; row < 3; ++row) to[row] = rotation[4 * row + index];
}

void CopyFromLinks(const RobotBody& body, const dReal* (*read)(dBodyID), size_t count, double* to) {
  for (int i = 0; i < body.link_count(); ++i) Copy(read(body.body(i)), count, to + count * i);
}

// What an accelerometer feels that moves with this acceleration.
Vector3 Felt(const Vector3& acceleration) { return acceleration + Vector3(0, 0, robot::kGravity); }

void CopyFromSites(const RobotBody& body, Vector3 (BodySite::*read)() const, double* to) {
  for (const BodySite& site : body.sites()) {
    Vector3::Map(to) = (site.*read)();
    to += 3;
  }
}

}  // namespace

RobotSensor::RobotSensor(const SensorMoment& moment, const robot::SensorDescription& description,
                         const robot::RobotDescription& robot)
    : LazySensor(moment, description.type,
                 static_cast<size_t>(robot::ElementCount(description, robot))),
      description_(&description) {}

void RobotSensor::AddNoise() {
  double deviation = 0;
  if (description_->id == robot::SensorId::kJointAngle) deviation = moment().noise.angle;
  if (description_->id == robot::SensorId::kJointVelocity ||
      description_->id == robot::SensorId::kBaseAngularVelocity)
    deviation = moment().noise.rate;
  if (description_->id == robot::SensorId::kBaseVelocity) deviation = moment().noise.velocity;
  if (deviation == 0) return;
  const auto sensor = static_cast<uint64_t>(description_->id);
  for (size_t i = 0; i < real_count(); ++i) {
    const uint64_t index = moment().since_start * real_count() + i;
    reals()[i] += deviation * moment().random.Normal(sensor, index);
  }
}

void RobotSensor::Compute() {
  const RobotBody& body = world().body();
  const dBodyID base = body.body(0);
  double* const out = reals();
  switch (description_->id) {
    case robot::SensorId::kTime:
      *out = time();
      break;
    case robot::SensorId::kBasePosition:
      Copy(dBodyGetPosition(base), 3, out);
      break;
    case robot::SensorId::kBaseOrientation:
      Copy(dBodyGetQuaternion(base), 4, out);
      break;
    case robot::SensorId::kBaseRotation:
      for (int row = 0; row < 3; ++row) Copy(dBodyGetRotation(base) + 4 * row, 3, out + 3 * row);
      break;
    case robot::SensorId::kBaseForward:
      CopyColumn(dBodyGetRotation(base), 0, out);
      break;
    case robot::SensorId::kBaseLeft:
      CopyColumn(dBodyGetRotation(base), 1, out);
      break;
    case robot::SensorId::kBaseUp:
      CopyColumn(dBodyGetRotation(base), 2, out);
      break;
    case robot::SensorId::kBaseVelocity:
      Copy(dBodyGetLinearVel(base), 3, out);
      break;
    case robot::SensorId::kBaseAngularVelocity:
      Copy(dBodyGetAngularVel(base), 3, out);
      break;
    case robot::SensorId::kBaseAcceleration: {
      const Vector3 felt = Felt(world().means().BaseAcceleration());
      dVector3 in_body;
      dBodyVectorFromWorld(base, felt[0], felt[1], felt[2], in_body);
      Copy(in_body, 3, out);
      break;
    }
    case robot::SensorId::kJointAngle:
      for (int j = 0; j < body.joint_count(); ++j) out[j] = body.JointAngle(j);
      break;
    case robot::SensorId::kJointVelocity:
      for (int j = 0; j < body.joint_count(); ++j) out[j] = body.joint(j).Rate();
      break;
    case robot::SensorId::kJointAcceleration:
      for (int j = 0; j < body.joint_count(); ++j) out[j] = world().means().JointAcceleration(j);
      break;
    case robot::SensorId::kJointTorque:
      std::copy_n(world().controller().torques().begin(), body.joint_count(), out);
      break;
    case robot::SensorId::kJointTarget:
      std::copy_n(world().controller().targets().begin(), body.joint_count(), out);
      break;
    case robot::SensorId::kLinkPosition:
      CopyFromLinks(body, dBodyGetPosition, 3, out);
      break;
    case robot::SensorId::kLinkOrientation:
      CopyFromLinks(body, dBodyGetQuaternion, 4, out);
      break;
    case robot::SensorId::kLinkVelocity:
      CopyFromLinks(body, dBodyGetLinearVel, 3, out);
      break;
    case robot::SensorId::kLinkAngularVelocity:
      CopyFromLinks(body, dBodyGetAngularVel, 3, out);
      break;
    case robot::SensorId::kContact:
      for (int i = 0; i < body.link_count(); ++i) flags()[i] = world().contacts().flag(i);
      break;
    case robot::SensorId::kContactForce:
      for (int i = 0; i < body.link_count(); ++i) {
        Vector3::Map(out + 3 * i) = world().means().ContactForce(i);
      }
      break;
    case robot::SensorId::kSitePosition:
      CopyFromSites(body, &BodySite::Position, out);
      break;
    case robot::SensorId::kSiteOrientation:
      for (size_t i = 0; i < body.sites().size(); ++i) {
        const Eigen::Quaterniond q = body.sites()[i].Orientation();
        Eigen::Vector4d::Map(out + 4 * i) << q.w(), q.vec();
      }
      break;
    case robot::SensorId::kSiteVelocity:
      CopyFromSites(body, &BodySite::Velocity, out);
      break;
    case robot::SensorId::kSiteAngularVelocity:
      CopyFromSites(body, &BodySite::AngularVelocity, out);
      break;
    case robot::SensorId::kSiteAcceleration:
      for (size_t i = 0; i < body.sites().size(); ++i) {
        const Vector3 felt = Felt(world().means().SiteAcceleration(static_cast<int>(i)));
        Vector3::Map(out + 3 * i) = body.sites()[i].Orientation().conjugate() * felt;
      }
      break;
    case robot::SensorId::kCount:
      assert(!"a sensor");
  }
  AddNoise();
}

RobotSensors::RobotSensors(const robot::RobotDescription& robot,
                           const world::WorldDescription* around) {
  for (const robot::SensorDescription& description : robot::SensorsOf(robot)) {
    sensors_.emplace_back(moment_, description, robot);
  }
  if (around == nullptr) return;
  for (world::ThingSensor& description : world::SensorsOf(*around)) {
    thing_sensors_.emplace_back(moment_, std::move(description), robot);
  }
}

void RobotSensors::Refresh(const World& world, double time) {
  moment_.world = &world;
  moment_.time = time;
  ++moment_.number;
  ++moment_.since_start;
}

void RobotSensors::SetNoise(const Randomization::Noise& noise, const EpisodeRandom& random) {
  moment_.noise = noise;
  moment_.random = random;
  moment_.since_start = 0;
}

void RobotSensors::Freeze() {
  for (RobotSensor& sensor : sensors_) sensor.Freeze();
  for (ThingSensor& sensor : thing_sensors_) sensor.Freeze();
}

void RobotSensors::EndPeek() {
  moment_.is_peeking = false;
  for (RobotSensor& sensor : sensors_) sensor.EndPeek();
  for (ThingSensor& sensor : thing_sensors_) sensor.EndPeek();
}

}  // namespace runtime
