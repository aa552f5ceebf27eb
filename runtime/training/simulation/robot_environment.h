// The module in which a robot lives: it steps the simulation, and offers the robot's sensors.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/values.h"
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
// Signals, in their order: start_of_episode; in every time step start_of_time_step(length [s]),
// then for each physics step start_of_physics_step(length) and end_of_physics_step(length), then
// end_of_time_step(length).
// A simulation that diverges emits end_of_episode(kDiverged, why) in place of the signals that
// would follow. The sensors then keep what was last read from them. So does an episode for which no
// start can be found, right after start_of_episode.
class RobotEnvironment : public Module {
 public:
  static constexpr const char* kRole = "environment";       // for ModuleGraph::FindOnly()
  static constexpr const char* kType = "RobotEnvironment";  // in agent files

  // `context.robot` describes the robot; where there is a `context.task`, it is in that one's
  // world.
  RobotEnvironment(std::string name, const Context& context);

  void Set(std::string_view parameter, const ParameterValue& value) override;
  void Start() override;

  // A fresh world with the robot in its start pose, or else in this state where there is one.
  void StartEpisode(const std::optional<robot::StartState>& start = std::nullopt);

  // How an episode is to start, if anything is said of it; after `attempt` other answers.
  using StartDraw = std::function<std::optional<robot::StartState>(uint32_t attempt)>;
  static constexpr uint32_t kMostDraws = 100;
  // The same in the first state that is drawn in which no links overlap more than in its pose. If
  // there is none in kMostDraws, the episode ends as diverged where it starts. What is drawn is
  // taken as it is where it does not change from draw to draw.
  void StartDrawnEpisode(const StartDraw& draw);

  // The number in the run of the episode that starts next; else it is one more than the last.
  void SetNextEpisode(int64_t number) { episode_ = number - 1; }
  // What the present episode has drawn (runtime/training/simulation/randomization.h).
  std::vector<Randomization::Shown> drawn() const { return randomization_.Show(draw_); }

  // One time step; nothing if the episode has diverged, or none has been started.
  void RunTimeStep();

  const std::string& profile() const { return profile_; }
  const std::string& start_pose() const { return start_pose_; }
  // What CapturePose() tells the poses of: the links, and after them the things of the world.
  int pose_count() const;
  double time_step() const { return robot_.controller.time_step; }  // [s]
  double time() const { return time_; }  // since the start of the episode [s]

  // x, y, z, qw, qx, qy, qz of the frame of each link and each thing, in the world frame; in a
  // diverged episode that of the last time step's start. Precondition: 7 elements for each; an
  // episode was started.
  void CapturePose(std::span<float> out) const;
  // For each link 1 where its contact is felt, else 0. Reads no sensor: these keep what they have.
  // Precondition: an element for each link; an episode was started.
  void CaptureContacts(std::span<float> out) const;

 private:
  void AddSensorPort(LazySensor& sensor, std::string_view name, std::string_view type,
                     std::string_view unit);
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
  int64_t episode_ = 0;  // the number of the current one
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
  Signal<> start_of_episode_{this, "start_of_episode"};
  Signal<double> start_of_time_step_{this, "start_of_time_step"};
  Signal<double> start_of_physics_step_{this, "start_of_physics_step"};
  Signal<double> end_of_physics_step_{this, "end_of_physics_step"};
  Signal<double> end_of_time_step_{this, "end_of_time_step"};
  Signal<EpisodeEnd> end_of_episode_{this, "end_of_episode"};

  std::unique_ptr<World> world_;
  bool running_ = false;
  int time_steps_ = 0;  // done in this episode
  double time_ = 0;
  std::vector<double> targets_;
  std::vector<float> last_pose_;
  std::string why_diverged_;
};

}  // namespace runtime
