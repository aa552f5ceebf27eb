// What the humanoid's simulation costs in each profile, while it moves at random as a beginner
// does:
//   us_per_step     CPU time of one physics step, with everything around it
//   own_share       the part of it that is not ODE's dWorldStep
//   times_real_time simulated seconds in one second of CPU time
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <random>

#include "runtime/simulation/robot_environment.h"

namespace {

double Now(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
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
  const double start = Now(CLOCK_MONOTONIC);
  const int result = __real_dWorldStep(world, step);
  spans.Add(start, Now(CLOCK_MONOTONIC));
  return result;
}

namespace runtime {
namespace {

const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription robot = robot::ReadRobot(HUMANOID);
  return robot;
}

// Every 160 ms a new random posture, approached smoothly, as actions do.
class RandomMotion : public Module {
 public:
  RandomMotion() : Module("motion") { joint_targets_.setZero(17); }

  void StartOfTimeStep(double) {
    constexpr int kControlSteps = 32;
    if (steps_ % kControlSteps == 0) {
      from_ = now_;
      for (size_t i = 0; i < 5; ++i) {
        to_[i] = std::uniform_real_distribution(net_.low[i], net_.high[i])(random_);
      }
    }
    const double rest = 1 - (steps_ % kControlSteps) / 60.0;
    for (size_t i = 0; i < 5; ++i) now_[i] = to_[i] - (to_[i] - from_[i]) * rest * rest * rest;
    for (const robot::Coupling& coupling : dof_.couplings) {
      joint_targets_[coupling.joint] = coupling.factor * now_[coupling.coordinate];
    }
    ++steps_;
  }

  Slot<double> start_of_time_step{this, "start_of_time_step",
                                  Bind<&RandomMotion::StartOfTimeStep>{}};
  Out<Eigen::VectorXd> joint_targets{this, "joint_targets", &joint_targets_};

 private:
  const robot::DofConfiguration& dof_ = *Humanoid().FindDof("5");
  const robot::NetDescription& net_ = *Humanoid().FindNet("bq01");
  std::mt19937 random_{1};
  std::array<double, 5> from_{}, to_{}, now_{};
  int steps_ = 0;
  Eigen::VectorXd joint_targets_;
};

// An environment in the middle of an episode of random motion, whose sensors are read as a task and
// a state read them.
class Episode {
 public:
  explicit Episode(const char* profile) : environment_("environment", {&Humanoid(), {}, 0}) {
    environment_.Set("profile", std::string(profile));
    for (Port* port : motion_.ports()) {
      Port::Connect(environment_.FindPort(port->name()), *port);
    }
    for (const char* name : {"base.position", "base.orientation", "base.velocity", "base.up",
                             "base.angular_velocity", "joint.angle", "joint.velocity", "contact"}) {
      sensors_.push_back(static_cast<SensorOut*>(&environment_.FindPort(name)));
    }
    environment_.Start();
    environment_.StartEpisode();
  }

  void StepControl() {
    environment_.StepControl();
    for (const SensorOut* sensor : sensors_) benchmark::DoNotOptimize((*sensor)().data);
  }

 private:
  RandomMotion motion_;
  RobotEnvironment environment_;
  std::vector<SensorOut*> sensors_;
};

void ControlStep(benchmark::State& state, const char* profile) {
  const double control_step = Humanoid().controller.time_step;
  const int physics_steps = FindProfile(profile).StepsPerControlStep(control_step);
  Episode episode(profile);
  spans = {};
  const double start = Now(CLOCK_THREAD_CPUTIME_ID);
  for (auto _ : state) episode.StepControl();
  const double seconds = (Now(CLOCK_THREAD_CPUTIME_ID) - start) / state.iterations();
  state.counters["us_per_step"] = 1e6 * seconds / physics_steps;
  state.counters["own_share"] = spans.own_share();
  state.counters["times_real_time"] = control_step / seconds;
}

void Paper(benchmark::State& state) { ControlStep(state, "paper"); }
void Fast(benchmark::State& state) { ControlStep(state, "fast"); }
void PaperTree(benchmark::State& state) { ControlStep(state, "paper-tree"); }
void FastTree(benchmark::State& state) { ControlStep(state, "fast-tree"); }
BENCHMARK(PaperTree)->Unit(benchmark::kMicrosecond)->MinTime(5);
BENCHMARK(FastTree)->Unit(benchmark::kMicrosecond)->MinTime(5);
BENCHMARK(Paper)->Unit(benchmark::kMicrosecond)->MinTime(5);
BENCHMARK(Fast)->Unit(benchmark::kMicrosecond)->MinTime(5);

// Both in turns, so that whatever else the machine does slows both alike.
void PaperAgainstFast(benchmark::State& state) {
  Episode paper("paper");
  Episode fast("fast");
  double paper_seconds = 0;
  double fast_seconds = 0;
  for (auto _ : state) {
    const double start = Now(CLOCK_THREAD_CPUTIME_ID);
    paper.StepControl();
    const double middle = Now(CLOCK_THREAD_CPUTIME_ID);
    fast.StepControl();
    paper_seconds += middle - start;
    fast_seconds += Now(CLOCK_THREAD_CPUTIME_ID) - middle;
  }
  state.counters["ratio"] = paper_seconds / fast_seconds;
}
BENCHMARK(PaperAgainstFast)->Unit(benchmark::kMicrosecond)->MinTime(3);

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
