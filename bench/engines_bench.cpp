// What three robots cost in our solver and in another engine, in simulated seconds per second of
// CPU time (PROFILE_x):
//   standing   holding the first pose
//   falling    the first second of a fall, from a height, tilted
//   lying      where such a fall has ended, holding the pose
// The profiles are stepped in turns, so that whatever else the machine does slows all alike.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/thread_seconds.h"
#include "runtime/training/simulation/world.h"

namespace runtime {
namespace {

enum class Course { kStands, kFalls, kLies };

constexpr double kFall = 1;  // [s]

const robot::RobotDescription& RobotCalled(const std::string& name) {
  static std::map<std::string, robot::RobotDescription> robots;
  const auto known = robots.find(name);
  if (known != robots.end()) return known->second;
  return robots[name] = robot::ReadRobot(std::string(ROBOTS) + "/" + name + "/robot.toml");
}

// A robot in a profile, and the time that it takes.
class Contender {
 public:
  Contender(const robot::RobotDescription& robot, const Profile& profile, Course course)
      : robot_(robot), profile_(profile), course_(course) {
    Begin();
    if (course == Course::kLies) {
      while (time_ < 2 * kFall) Step();
    }
  }

  void RunTimeStep() {
    if (course_ == Course::kFalls && time_ > kFall) Begin();
    const double start = ThreadSeconds();
    Step();
    seconds_ += ThreadSeconds() - start;
  }
  double seconds() const { return seconds_; }
  const Profile& profile() const { return profile_; }

 private:
  void Begin() {
    robot::StartState start = robot::RestIn(robot_.poses[0]);
    targets_ = start.pose.joint_angles;
    if (course_ != Course::kStands) {
      start.pose.position[2] += 0.3;
      start.pose.orientation = {std::cos(0.4), std::sin(0.4), 0, 0};
    }
    world_ = std::make_unique<World>(robot_, profile_, start);
    time_ = 0;
  }
  void Step() {
    for (int i = 0; i < world_->physics_steps_per_time_step(); ++i) world_->Step(targets_);
    time_ += robot_.controller.time_step;
  }

  const robot::RobotDescription& robot_;
  const Profile& profile_;
  Course course_;
  std::vector<double> targets_;
  std::unique_ptr<World> world_;
  double time_ = 0;
  double seconds_ = 0;
};

void Engines(benchmark::State& state, const std::string& name, Course course) {
  const robot::RobotDescription& robot = RobotCalled(name);
  std::vector<Contender> contenders;
  for (const char* profile : {"fast-tree", "paper-tree", "mujoco"}) {
    if (!FindProfile(profile).IsBuilt()) continue;
    contenders.emplace_back(robot, FindProfile(profile), course);
  }
  for (auto _ : state) {
    for (Contender& contender : contenders) contender.RunTimeStep();
  }
  for (const Contender& contender : contenders) {
    state.counters[std::string(contender.profile().name) + "_x"] =
        static_cast<double>(state.iterations()) * robot.controller.time_step / contender.seconds();
  }
}

void NewMujocoWorld(benchmark::State& state) {
  if (!FindProfile("mujoco").IsBuilt()) return state.SkipWithError("built without MuJoCo");
  const robot::RobotDescription& robot = RobotCalled("humanoid");
  const World before(robot, FindProfile("mujoco"), robot.poses[0]);  // whose model is shared
  for (auto _ : state) {
    const World world(robot, FindProfile("mujoco"), robot.poses[0]);
    benchmark::DoNotOptimize(world.body().body(0));
  }
}
BENCHMARK(NewMujocoWorld)->Unit(benchmark::kMicrosecond);

[[maybe_unused]] const bool registered = [] {
  for (const char* robot : {"humanoid", "quadruped", "hexapod"}) {
    for (const auto& [name, course] : {std::pair{"standing", Course::kStands},
                                       {"falling", Course::kFalls},
                                       {"lying", Course::kLies}}) {
      benchmark::RegisterBenchmark((std::string("Engines/") + robot + "/" + name).c_str(), Engines,
                                   std::string(robot), course)
          ->Unit(benchmark::kMicrosecond)
          ->MinTime(1);
    }
  }
  return true;
}();

}  // namespace
}  // namespace runtime
