// The module in which a robot lives: it steps the simulation, and offers the robot's sensors.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/values.h"
#include "runtime/training/environment/environment.h"
#include "runtime/training/simulation/link_overlap.h"
#include "runtime/training/simulation/randomization.h"
#include "runtime/training/simulation/robot_sensors.h"
#include "runtime/training/simulation/world.h"

namespace runtime {

// Parameters: `profile` (runtime/training/simulation/profile.h), `start_pose` ("": as the task
// says, or else the robot's first pose), and those of what is random
// (runtime/training/simulation/randomization.h).
//
// Out ports: one for each of the robot's sensors, and of the things in its world, with its name.
// What some of them tell is measured only while something is connected to them, from the next time
// step on (runtime/training/simulation/step_means.h).
// In port: `joint_targets`, one angle for each joint [rad], read at the start of every time
// step, after start_of_time_step. Until the first one, and while nothing is connected, all targets
// are 0.
//
// Signals: those of every environment (environment.h).
// A simulation that diverges emits end_of_episode(kDiverged, why) in place of the signals that
// would follow. The sensors then keep what was last read from them. So does an episode for which no
// start can be found, right after start_of_episode.
class RobotEnvironment : public Environment {
 public:
  static constexpr const char* kType = "RobotEnvironment";  // in agent files

  // `context.robot` describes the robot; where there is a `context.task`, it is in that one's
  // world. Throws UserError where there is no robot.
  RobotEnvironment(std::string name, const Context& context);

  void Set(std::string_view parameter, const ParameterValue& value) override;
  void Start() override;

  // A fresh world with the robot in its start pose, or else in this state where there is one.
  void StartEpisode(const std::optional<robot::StartState>& start = std::nullopt);

  // StartDrawnEpisode() begins in the first state that is drawn in which no links overlap more than
  // in its pose. If there is none in kMostDraws, the episode ends as diverged where it starts. What
  // is drawn is taken as it is where it does not change from draw to draw.
  static constexpr uint32_t kMostDraws = 100;

  // What the present episode has drawn (runtime/training/simulation/randomization.h).
  std::vector<DrawnValue> drawn() const override { return randomization_.Show(draw_); }

  void RunTimeStep() override;

  const std::string& profile() const override { return profile_; }
  const std::string& start_pose() const { return start_pose_; }
  // What the controller was told last [rad], one for each joint. Precondition: an episode was
  // started.
  std::span<const double> told() const { return world_->controller().targets(); }
  // The links, and after them the things of the world.
  int pose_count() const override;
  int link_count() const override { return static_cast<int>(robot_.links.size()); }
  double time_step() const override { return robot_.controller.time_step; }
  double time() const override { return time_; }

  // In a diverged episode that of the last time step's start.
  void CapturePose(std::span<float> out) const override;
  void CaptureContacts(std::span<uint8_t> out) const override;

 private:
  void StartPeek() override { sensors_.StartPeek(); }
  void EndPeek() override { sensors_.EndPeek(); }
  void AddSensorPort(LazySensor& sensor, std::string_view name, std::string_view type,
                     std::string_view unit);
  void BeginEpisode(const StartDraw& draw) override;
  // Draws what the episode that starts is like.
  void Randomize();
  void PlanPush();
  void Push();
  // The targets of so many time steps ago.
  void DelayTargets();
  void Place(const std::optional<robot::StartState>& start);
  // Places the robot. Returns an overlap that all draws have.
  std::optional<LinkOverlap> PlaceDrawn(const StartDraw& draw);
  void Begin();
  [[noreturn]] void ThrowForeignTargets() const;
  // Returns whether the episode can continue.
  bool StepPhysics(int index);
  StepMeans::Wanted WantedMeans() const;
  void Diverge(std::string why);

  const robot::RobotDescription& robot_;
  std::unique_ptr<const world::WorldDescription> around_;  // or null
  std::string profile_ = "paper";
  std::string start_pose_;

  uint64_t seed_;
  Randomization randomization_;
  Randomization::Draw draw_;
  EpisodeRandom random_{0, 0};
  // Of an episode that is randomized; null otherwise.
  std::unique_ptr<const robot::RobotDescription> changed_robot_;
  std::unique_ptr<const world::WorldDescription> changed_around_;
  uint64_t pushes_ = 0;                            // in this episode
  double next_push_ = 0;                           // [s]
  std::vector<std::vector<double>> past_targets_;  // of as many time steps as they come late

  RobotSensors sensors_;
  std::deque<SensorOut> sensor_ports_;
  In<Eigen::VectorXd> joint_targets_{this, "joint_targets", "",
                                     In<Eigen::VectorXd>::Need::kOptional};

  std::unique_ptr<World> world_;
  bool running_ = false;
  int time_steps_ = 0;  // done in this episode
  double time_ = 0;
  std::vector<double> targets_;
  std::vector<float> last_pose_;
  std::string why_diverged_;
};

}  // namespace runtime
