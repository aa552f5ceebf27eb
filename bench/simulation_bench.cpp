// What the humanoid's simulation costs, in each profile and in several situations:
//   standing   on its feet, holding its pose
//   lying      on its front, holding its pose
//   crawling   on its front, with random motion as a beginner's
// In each situation the profiles are stepped in turns, so that whatever else the machine does slows
// all alike. Counters, by CPU time:
//   PROFILE_us   one physics step with everything around it
//   PROFILE_x    simulated seconds in one second
// Sensors: what the rarer ones cost where something reads them, as the ratio of the time of a step
// with them to that without.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "bench/random_motion.h"
#include "runtime/base/thread_seconds.h"
#include "runtime/training/simulation/robot_environment.h"

namespace {

double WallSeconds() {
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The physics steps since the last reset, cut where dWorldStep begins and ends. The clock of the
// thread's CPU time is too slow for this, so time goes by the wall, and spans in which the thread
// did not run throughout do not count.
struct Spans {
  double own = 0;
  double ode = 0;
  int64_t own_count = 0;
  int64_t ode_count = 0;
  double last_end = 0;  // of a call of dWorldStep; 0: none

  static constexpr double kLongest = 500e-6;  // s

  void Add(double start, double end) {
    if (last_end > 0 && start - last_end < kLongest) {
      own += start - last_end;
      ++own_count;
    }
    if (end - start < kLongest) {
      ode += end - start;
      ++ode_count;
    }
    last_end = end;
  }
  double own_share() const {
    const double own_mean = own / static_cast<double>(own_count);
    return own_mean / (own_mean + ode / static_cast<double>(ode_count));
  }
};

Spans spans;

}  // namespace

extern "C" int __real_dWorldStep(dWorldID world, dReal step);
extern "C" int __wrap_dWorldStep(dWorldID world, dReal step) {
  const double start = WallSeconds();
  const int result = __real_dWorldStep(world, step);
  spans.Add(start, WallSeconds());
  return result;
}

namespace runtime {
namespace {

// Moves the robot, or holds its pose.
class Mover : public Module {
 public:
  explicit Mover(bool moves) : Module("mover"), moves_(moves) { joint_targets_.setZero(17); }

  void StartOfTimeStep(double) {
    if (moves_) motion_.Next({joint_targets_.data(), static_cast<size_t>(joint_targets_.size())});
  }

  Slot<double> start_of_time_step{this, "start_of_time_step", Bind<&Mover::StartOfTimeStep>{}};
  Out<Eigen::VectorXd> joint_targets{this, "joint_targets", &joint_targets_};

 private:
  bool moves_;
  RandomMotion motion_{1};
  Eigen::VectorXd joint_targets_;
};

struct Situation {
  const char* pose;
  bool moves;
};
constexpr Situation kStanding = {"standing", false};
constexpr Situation kLying = {"lying", false};
constexpr Situation kCrawling = {"lying", true};

const std::vector<std::string> kUsualSensors = {
    "base.position",         "base.orientation", "base.velocity",  "base.up",
    "base.angular_velocity", "joint.angle",      "joint.velocity", "contact"};

// An environment in the middle of an episode, whose sensors are read as a task and a state read
// them.
class Episode {
 public:
  Episode(std::string_view profile, Situation situation,
          const std::vector<std::string>& sensors = kUsualSensors)
      : mover_(situation.moves), environment_("environment", {&Humanoid(), {}, 0}) {
    environment_.Set("profile", std::string(profile));
    environment_.Set("start_pose", std::string(situation.pose));
    for (Port* port : mover_.ports()) {
      Port::Connect(environment_.FindPort(port->name()), *port);
    }
    for (const std::string& name : sensors) {
      Port& port = environment_.FindPort(name);
      Port::Connect(port, sensors_.emplace_back(&mover_, name, port.type().text));
    }
    environment_.Start();
    environment_.StartEpisode();
  }

  void RunTimeStep() {
    const double start = ThreadSeconds();
    environment_.RunTimeStep();
    for (const SensorIn& sensor : sensors_) benchmark::DoNotOptimize(sensor().data);
    seconds_ += ThreadSeconds() - start;
  }

  double seconds() const { return seconds_; }

 private:
  Mover mover_;
  RobotEnvironment environment_;
  std::deque<SensorIn> sensors_;
  double seconds_ = 0;
};

void TimeStep(benchmark::State& state, Situation situation) {
  const double time_step = Humanoid().controller.time_step;
  std::vector<std::unique_ptr<Episode>> episodes;
  for (const Profile& profile : kProfiles) {
    if (!profile.IsBuilt()) continue;
    episodes.push_back(std::make_unique<Episode>(profile.name, situation));
  }
  for (auto _ : state) {
    for (const auto& episode : episodes) episode->RunTimeStep();
  }
  for (size_t i = 0; i < episodes.size(); ++i) {
    const std::string name(kProfiles[i].name);
    const double seconds = episodes[i]->seconds() / static_cast<double>(state.iterations());
    state.counters[name + "_us"] = 1e6 * seconds / kProfiles[i].PhysicsStepsPerTimeStep(time_step);
    state.counters[name + "_x"] = time_step / seconds;
  }
}
BENCHMARK_CAPTURE(TimeStep, standing, kStanding)->Unit(benchmark::kMicrosecond)->MinTime(3);
BENCHMARK_CAPTURE(TimeStep, lying, kLying)->Unit(benchmark::kMicrosecond)->MinTime(3);
BENCHMARK_CAPTURE(TimeStep, crawling, kCrawling)->Unit(benchmark::kMicrosecond)->MinTime(3);

void Sensors(benchmark::State& state, const std::vector<std::string>& more) {
  std::vector<std::string> all = kUsualSensors;
  all.insert(all.end(), more.begin(), more.end());
  std::vector<std::unique_ptr<Episode>> without;
  std::vector<std::unique_ptr<Episode>> with;
  for (const Profile& profile : kProfiles) {
    if (!profile.IsBuilt()) continue;
    without.push_back(std::make_unique<Episode>(profile.name, kCrawling));
    with.push_back(std::make_unique<Episode>(profile.name, kCrawling, all));
  }
  for (auto _ : state) {
    for (const auto& episode : without) episode->RunTimeStep();
    for (const auto& episode : with) episode->RunTimeStep();
  }
  for (size_t i = 0; i < with.size(); ++i) {
    state.counters[std::string(kProfiles[i].name)] = with[i]->seconds() / without[i]->seconds();
  }
}
BENCHMARK_CAPTURE(Sensors, links,
                  {"link.position", "link.orientation", "link.velocity", "link.angular_velocity"})
    ->Unit(benchmark::kMicrosecond)
    ->MinTime(3);
BENCHMARK_CAPTURE(Sensors, accelerations, {"base.acceleration", "joint.acceleration"})
    ->Unit(benchmark::kMicrosecond)
    ->MinTime(3);
BENCHMARK_CAPTURE(Sensors, contact_force, {"contact_force"})
    ->Unit(benchmark::kMicrosecond)
    ->MinTime(3);
BENCHMARK_CAPTURE(Sensors, sites,
                  {"site.position", "site.orientation", "site.velocity", "site.angular_velocity",
                   "site.acceleration"})
    ->Unit(benchmark::kMicrosecond)
    ->MinTime(3);

// The part of a physics step of `paper` that is not ODE's dWorldStep: controller, collisions,
// filter, checks, signals, sensors.
void OwnWork(benchmark::State& state) {
  Episode episode("paper", kCrawling);
  spans = {};
  for (auto _ : state) episode.RunTimeStep();
  state.counters["own_share"] = spans.own_share();
  state.counters["own_us"] = 1e6 * spans.own / static_cast<double>(spans.own_count);
}
BENCHMARK(OwnWork)->Unit(benchmark::kMicrosecond)->MinTime(2);

// A fresh world, made at the start of every episode.
void NewWorld(benchmark::State& state) {
  for (auto _ : state) {
    World world(Humanoid(), FindProfile("paper"), Humanoid().poses[0]);
    benchmark::DoNotOptimize(world.body().body(0));
  }
}
BENCHMARK(NewWorld)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace runtime

BENCHMARK_MAIN();
