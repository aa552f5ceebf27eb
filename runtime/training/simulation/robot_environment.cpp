#include "runtime/training/simulation/robot_environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "runtime/core/task/plugin.h"
#include "runtime/core/task/task_world.h"

namespace runtime {
namespace {

std::vector<std::string> ProfileNames() {
  std::vector<std::string> names;
  for (const Profile& profile : kProfiles) names.emplace_back(profile.name);
  return names;
}

std::vector<std::string> PoseNames(const robot::RobotDescription& robot) {
  std::vector<std::string> names = {""};
  for (const robot::Pose& pose : robot.poses) names.push_back(pose.name);
  return names;
}

}  // namespace

RobotEnvironment::RobotEnvironment(std::string name, const Context& context)
    : Environment(std::move(name)),
      robot_(RobotOf(context, this->name())),
      around_(context.task == nullptr ? nullptr : WorldOf(context.task->table())),
      seed_(context.seed),
      sensors_(robot_, around_.get()) {
  AddParameter({.name = "profile",
                .doc = "how the robot is simulated: as in the paper or with longer steps, by ODE "
                       "or along its tree",
                .target = &profile_,
                .choices = ProfileNames(),
                .is_live = false});
  AddParameter({"start_pose",
                "the pose that episodes start from; \"\" is what the task says, or else the "
                "robot's first pose",
                &start_pose_, PoseNames(robot_)});
  for (Parameter& parameter : randomization_.Parameters()) AddParameter(std::move(parameter));
  for (RobotSensor& sensor : sensors_.sensors()) {
    const robot::SensorDescription& description = sensor.description();
    AddSensorPort(sensor, description.name, description.type, description.unit);
  }
  for (ThingSensor& sensor : sensors_.thing_sensors()) {
    const world::ThingSensor& description = sensor.description();
    AddSensorPort(sensor, description.name, description.type, description.unit);
  }
}

void RobotEnvironment::AddSensorPort(LazySensor& sensor, std::string_view name,
                                     std::string_view type, std::string_view unit) {
  sensor_ports_.emplace_back(this, std::string(name), &sensor, Bind<&LazySensor::Read>{},
                             SensorTypeText(type, unit));
}

int RobotEnvironment::pose_count() const {
  return static_cast<int>(robot_.links.size() + (around_ == nullptr ? 0 : around_->things.size()));
}

void RobotEnvironment::Set(std::string_view parameter, const ParameterValue& value) {
  const ParameterValue before = Get(parameter);
  Module::Set(parameter, value);
  try {
    randomization_.Check(name());
  } catch (const UserError&) {
    Module::Set(parameter, before);
    throw;
  }
}

void RobotEnvironment::Start() {
  targets_.assign(robot_.joints.size(), 0.0);
  last_pose_.assign(7 * static_cast<size_t>(pose_count()), 0.0f);
}

void RobotEnvironment::StartEpisode(const std::optional<robot::StartState>& start) {
  CountEpisode();
  Randomize();
  Place(start);
  Begin();
}

void RobotEnvironment::BeginEpisode(const StartDraw& draw) {
  Randomize();
  const std::optional<LinkOverlap> overlap = PlaceDrawn(draw);
  Begin();
  if (!overlap) return;
  CapturePose(last_pose_);
  Diverge(
      fmt::format("links overlap in each of {} starts that were drawn: `{}` and `{}` by {:.1f} "
                  "mm in the last one",
                  kMostDraws, robot_.links[overlap->first].name, robot_.links[overlap->second].name,
                  1000 * overlap->depth));
}

std::optional<LinkOverlap> RobotEnvironment::PlaceDrawn(const StartDraw& draw) {
  std::optional<robot::StartState> start = draw(0);
  Place(start);
  if (!start || !start_pose_.empty()) return std::nullopt;
  const Profile& profile = FindProfile(profile_);
  std::optional<LinkOverlap> overlap = FindOverlap(robot_, profile, *start, *world_);
  bool changes = false;
  for (uint32_t attempt = 1; overlap && attempt < kMostDraws; ++attempt) {
    std::optional<robot::StartState> next = draw(attempt);
    if (next == start) continue;
    changes = true;
    start = std::move(next);
    Place(start);
    overlap = FindOverlap(robot_, profile, *start, *world_);
  }
  return changes ? overlap : std::nullopt;
}

void RobotEnvironment::Place(const std::optional<robot::StartState>& start) {
  const Profile& profile = FindProfile(profile_);
  const robot::RobotDescription& robot = changed_robot_ ? *changed_robot_ : robot_;
  const world::WorldDescription* around = changed_around_ ? changed_around_.get() : around_.get();
  if (start && start_pose_.empty()) {
    world_ = std::make_unique<World>(robot, profile, *start, around);
  } else {
    const robot::Pose* pose =
        start_pose_.empty() ? &robot_.poses.front() : robot_.FindPose(start_pose_);
    assert(pose != nullptr);
    world_ = std::make_unique<World>(robot, profile, *pose, around);
  }
}

void RobotEnvironment::Randomize() {
  random_ = EpisodeRandom(seed_, episode());
  if (changed_robot_ != nullptr) world_.reset();  // before what it was made of
  changed_robot_.reset();
  changed_around_.reset();
  sensors_.SetNoise(randomization_.noise(), random_);
  past_targets_.clear();
  draw_ = {};
  if (randomization_.IsOff()) return;
  draw_ = randomization_.DrawFor(random_);
  changed_robot_ =
      std::make_unique<const robot::RobotDescription>(randomization_.Change(robot_, draw_));
  const bool changes_ground = draw_.friction < robot::kUnlimited;
  if (changes_ground) {
    changed_around_ = std::make_unique<const world::WorldDescription>(
        randomization_.Change(around_.get(), draw_));
  }
  past_targets_.resize(static_cast<size_t>(std::floor(draw_.delay / time_step() + 0.5)));
  pushes_ = 0;
  next_push_ = 0;
  PlanPush();
}

void RobotEnvironment::PlanPush() {
  if (randomization_.has_pushes()) next_push_ += randomization_.PushAfter(random_, pushes_);
}

void RobotEnvironment::Push() {
  if (!randomization_.has_pushes() || time_ < next_push_) return;
  const std::array<double, 2> push = randomization_.PushOf(random_, pushes_++);
  world_->Push({push[0], push[1], 0});
  PlanPush();
}

void RobotEnvironment::DelayTargets() {
  if (past_targets_.empty()) return;
  if (time_steps_ == 0) std::ranges::fill(past_targets_, targets_);
  std::swap(past_targets_[static_cast<size_t>(time_steps_) % past_targets_.size()], targets_);
}

void RobotEnvironment::Begin() {
  running_ = true;
  time_steps_ = 0;
  time_ = 0;
  std::fill(targets_.begin(), targets_.end(), 0.0);
  sensors_.Refresh(*world_, time_);
  start_of_episode_();
}

void RobotEnvironment::RunTimeStep() {
  if (!running_) return;
  CapturePose(last_pose_);
  const double length = time_step();
  start_of_time_step_(length);
  if (joint_targets_.connected()) {
    const Eigen::VectorXd& targets = joint_targets_();
    if (targets.size() != static_cast<Eigen::Index>(targets_.size())) ThrowForeignTargets();
    std::copy(targets.begin(), targets.end(), targets_.begin());
    DelayTargets();
  }
  Push();
  for (int i = 0; i < world_->physics_steps_per_time_step(); ++i) {
    if (!StepPhysics(i)) return;
  }
  ++time_steps_;
  end_of_time_step_(length);
}

void RobotEnvironment::ThrowForeignTargets() const {
  throw UserError(fmt::format("`{}` gets {} joint targets, and the robot `{}` has {} joints",
                              name(), joint_targets_().size(), robot_.name, targets_.size()));
}

bool RobotEnvironment::StepPhysics(int index) {
  const double length = world_->physics_time_step();
  start_of_physics_step_(length);
  if (index == 0) world_->StartTimeStep(WantedMeans());
  try {
    world_->Step(targets_);
  } catch (const OdeFailure& failure) {
    Diverge(fmt::format("the simulation diverged: {}", failure.what()));
    return false;
  }
  // Counted, not summed, so that 4000 time steps of 5 ms are 20 s and not a little more.
  const bool is_last = index + 1 == world_->physics_steps_per_time_step();
  time_ =
      is_last ? (time_steps_ + 1) * time_step() : time_steps_ * time_step() + (index + 1) * length;
  sensors_.Refresh(*world_, time_);
  end_of_physics_step_(length);
  return true;
}

StepMeans::Wanted RobotEnvironment::WantedMeans() const {
  const auto is_read = [&](robot::SensorId sensor) {
    const auto index = static_cast<size_t>(sensor);
    return index < robot::SensorsOf(robot_).size() && sensor_ports_[index].connected();
  };
  return {.base_acceleration = is_read(robot::SensorId::kBaseAcceleration),
          .joint_accelerations = is_read(robot::SensorId::kJointAcceleration),
          .contact_forces = is_read(robot::SensorId::kContactForce),
          .site_accelerations = is_read(robot::SensorId::kSiteAcceleration)};
}

void RobotEnvironment::Diverge(std::string why) {
  running_ = false;
  sensors_.Freeze();
  why_diverged_ = std::move(why);
  end_of_episode_({EndKind::kDiverged, why_diverged_.c_str()});
}

void RobotEnvironment::CaptureContacts(std::span<uint8_t> out) const {
  std::ranges::fill(out, uint8_t{0});
  for (int i = 0; i < link_count(); ++i) {
    const int bit = world_->contacts().flag(i) ? 1 << i % 8 : 0;
    out[static_cast<size_t>(i / 8)] |= static_cast<uint8_t>(bit);
  }
}

void RobotEnvironment::CapturePose(std::span<float> out) const {
  assert(out.size() == 7 * static_cast<size_t>(pose_count()));
  if (!running_) {
    std::copy(last_pose_.begin(), last_pose_.end(), out.begin());
    return;
  }
  auto next = out.begin();
  const auto add = [&](const double* position, const double* orientation) {
    next = std::copy_n(position, 3, next);
    next = std::copy_n(orientation, 4, next);
  };
  const RobotBody& body = world_->body();
  for (int i = 0; i < body.link_count(); ++i)
    add(dBodyGetPosition(body.body(i)), dBodyGetQuaternion(body.body(i)));
  const std::span<const world::Thing> things = world_->surroundings().things();
  for (size_t i = 0; i < things.size(); ++i) {
    const int index = world_->surroundings().BodyOf(i);
    if (index < 0) {
      add(things[i].position.data(), things[i].orientation.data());
    } else {
      add(dBodyGetPosition(body.body(index)), dBodyGetQuaternion(body.body(index)));
    }
  }
}

}  // namespace runtime
