// How alike the profiles are, and what they cost: many runs of a robot with the same random targets
// in each, and what their ends and their contacts are on average; and how far its joints are from
// the paper's simulation with tiny steps where nothing touches it. Prints a table (Markdown).
//
//   profile_ensemble [ROBOT [RUNS [PROFILE[@STEP[:DAMPING]]...]]]
//
// STEP [ms] and DAMPING [N s/m] take the place of the profile's longest step and of the damping of
// its contacts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "bench/random_motion.h"
#include "runtime/base/thread_seconds.h"
#include "runtime/training/simulation/world.h"

namespace runtime {
namespace {

constexpr double kSeconds = 2;

class Average {
 public:
  void Add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  std::string Text(int digits) const {
    const double mean = sum_ / count_;
    const double variance = (squares_ / count_ - mean * mean) / (count_ - 1);
    return fmt::format("{:.{}f} ± {:.{}f}", mean, digits, std::sqrt(std::max(0.0, variance)),
                       digits);
  }

 private:
  int count_ = 0;
  double sum_ = 0;
  double squares_ = 0;
};

// Postures of a robot without a net of its own: every joint anywhere near its rest.
class RandomPostures {
 public:
  RandomPostures(const robot::RobotDescription& robot, double reach, unsigned seed)
      : robot_(robot), reach_(reach), random_(seed) {}

  void Next(std::span<double> targets) {
    const std::vector<double>& rest = robot_.poses[0].joint_angles;
    for (size_t j = 0; j < targets.size(); ++j) {
      const double low = std::max(robot_.joints[j].low, rest[j] - reach_);
      const double high = std::min(robot_.joints[j].high, rest[j] + reach_);
      targets[j] = std::uniform_real_distribution(low, high)(random_);
    }
  }

 private:
  const robot::RobotDescription& robot_;
  double reach_;  // [rad]
  std::mt19937 random_;
};

// A new posture every 0.2 s, in the air, and with links that do not touch each other.
class InTheAir {
 public:
  explicit InTheAir(const robot::RobotDescription& robot) : robot_(Untouchable(robot)) {
    static constexpr Profile kReference = {"reference", 0.00002, JointDrive::kTorque, 800,
                                           SolverKind::kTree};
    for (unsigned run = 0; run < kRuns; ++run) right_.push_back(Angles(kReference, run));
  }

  // Root mean square of the differences of the joints' angles from the reference [rad].
  double Error(const Profile& profile) const {
    double squares = 0;
    size_t count = 0;
    for (unsigned run = 0; run < kRuns; ++run) {
      const std::vector<double> angles = Angles(profile, run);
      for (size_t i = 0; i < angles.size(); ++i) squares += std::pow(angles[i] - right_[run][i], 2);
      count += angles.size();
    }
    return std::sqrt(squares / static_cast<double>(count));
  }

 private:
  static constexpr unsigned kRuns = 4;
  static constexpr double kTimeStep = 0.02;  // between two looks [s]
  static constexpr int kTimeSteps = 50;

  static robot::RobotDescription Untouchable(robot::RobotDescription robot) {
    robot.poses[0].position[2] = 100;
    robot.contact_exclusions = CollidingLinks(robot);
    return robot;
  }

  // The joints' angles at the end of each time step [rad].
  std::vector<double> Angles(const Profile& profile, unsigned run) const {
    World world(robot_, profile, robot_.poses[0]);
    RandomPostures postures(robot_, 1, run + 1);
    std::vector<double> targets(robot_.joints.size());
    std::vector<double> angles;
    const auto steps = std::lround(kTimeStep / world.physics_time_step());
    for (int i = 0; i < kTimeSteps; ++i) {
      if (i % 10 == 0) postures.Next(targets);
      for (int step = 0; step < steps; ++step) world.Step(targets);
      for (int j = 0; j < world.body().joint_count(); ++j) {
        angles.push_back(world.body().JointAngle(j));
      }
    }
    return angles;
  }

  robot::RobotDescription robot_;
  std::vector<std::vector<double>> right_;  // of each run
};

// What a robot is told to do on the ground: the humanoid what a beginner does, others a new posture
// every 0.16 s.
class OnTheGround {
 public:
  OnTheGround(const robot::RobotDescription& robot, unsigned seed) : postures_(robot, 0.6, seed) {
    if (robot.name == "humanoid") humanoid_ = std::make_unique<RandomMotion>(seed);
  }

  // The joints' targets of the next time step.
  void Next(std::span<double> targets) {
    if (humanoid_) return humanoid_->Next(targets);
    if (steps_++ % 32 == 0) postures_.Next(targets);
  }

 private:
  RandomPostures postures_;
  std::unique_ptr<RandomMotion> humanoid_;
  int steps_ = 0;
};

// A profile in the table.
class Row {
 public:
  Row(const robot::RobotDescription& robot, std::string name, Profile profile)
      : robot_(robot), name_(std::move(name)), profile_(profile) {
    profile_.name = name_;
  }

  void Run(unsigned seed) {
    const double start = ThreadSeconds();
    try {
      Measure(seed);
    } catch (const OdeFailure&) {
      ++diverged_;
    }
    cpu_seconds_ += ThreadSeconds() - start;
    ++runs_;
  }

  void Print(const InTheAir& air) const {
    fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.1e} | {:.1f} |\n", name_, height_.Text(4),
               distance_.Text(3), contacts_.Text(2), links_.Text(2), joint_speed_.Text(2),
               diverged_, air.Error(profile_), runs_ * kSeconds / cpu_seconds_);
  }

 private:
  void Measure(unsigned seed) {
    World world(robot_, profile_, robot_.poses[0]);
    OnTheGround motion(robot_, seed);
    std::vector<double> targets(robot_.joints.size());
    const auto time_steps = std::lround(kSeconds / robot_.controller.time_step);
    double contacts = 0, links = 0, joint_speed = 0;
    for (int step = 0; step < time_steps; ++step) {
      motion.Next(targets);
      for (int i = 0; i < world.physics_steps_per_time_step(); ++i) world.Step(targets);
      contacts += static_cast<double>(world.collision().contacts().size());
      for (int i = 0; i < world.body().link_count(); ++i) links += world.contacts().flag(i);
      for (int j = 0; j < world.body().joint_count(); ++j) {
        joint_speed += std::abs(dJointGetHingeAngleRate(world.body().joint(j).id()));
      }
    }
    const dReal* base = dBodyGetPosition(world.body().body(0));
    height_.Add(base[2]);
    distance_.Add(std::hypot(base[0], base[1]));
    contacts_.Add(contacts / time_steps);
    links_.Add(links / time_steps);
    joint_speed_.Add(joint_speed / time_steps / world.body().joint_count());
  }

  const robot::RobotDescription& robot_;
  std::string name_;
  Profile profile_;
  Average height_, distance_, contacts_, links_, joint_speed_;
  int runs_ = 0;
  int diverged_ = 0;
  double cpu_seconds_ = 0;
};

// "fast-tree@2.5:2250".
Profile ProfileOf(const std::string& text) {
  const size_t at = text.find('@');
  Profile profile = FindProfile(text.substr(0, at));
  if (at == std::string::npos) return profile;
  profile.longest_time_step = std::atof(text.c_str() + at + 1) / 1000;
  const size_t colon = text.find(':', at);
  if (colon != std::string::npos) profile.contact_damping = std::atof(text.c_str() + colon + 1);
  return profile;
}

void PrintTable(const robot::RobotDescription& robot, int runs,
                const std::vector<std::string>& profiles) {
  const InTheAir air(robot);
  std::vector<std::unique_ptr<Row>> rows;
  for (const std::string& text : profiles) {
    const Profile profile = ProfileOf(text);
    if (profile.IsBuilt()) rows.push_back(std::make_unique<Row>(robot, text, profile));
  }
  // In turns, so that whatever else the machine does slows all alike.
  for (int run = 1; run <= runs; ++run) {
    for (const auto& row : rows) row->Run(static_cast<unsigned>(run));
  }
  fmt::print(
      "| {}, {} runs | height (m) | distance (m) | contact points | links in `contact` | "
      "joint speed (rad/s) | diverged | rms, air (rad) | × real time |\n"
      "|---|---|---|---|---|---|---|---|---|\n",
      robot.name, runs);
  for (const auto& row : rows) row->Print(air);
}

}  // namespace
}  // namespace runtime

int main(int argc, char** argv) {
  const std::string robot = argc > 1 ? argv[1] : "humanoid";
  const int runs = argc > 2 ? std::atoi(argv[2]) : 256;
  std::vector<std::string> profiles(argv + std::min(argc, 3), argv + argc);
  if (profiles.empty()) {
    for (const runtime::Profile& profile : runtime::kProfiles) profiles.emplace_back(profile.name);
  }
  runtime::PrintTable(robot::ReadRobot(std::string(ROBOTS) + "/" + robot + "/robot.toml"), runs,
                      profiles);
}
