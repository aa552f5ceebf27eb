// How alike the profiles are: many runs of the humanoid with the same random targets in each, and
// what their ends and their contacts are on average; and how far their joints are from the paper's
// simulation with tiny steps where nothing touches the robot. Prints a table (Markdown).
//
//   profile_ensemble [RUNS [PROFILE...]]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "bench/random_motion.h"
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

// A new posture every 0.2 s, in the air, and with links that do not touch each other.
class InTheAir {
 public:
  static constexpr int kRuns = 4;
  static constexpr double kTimeStep = 0.02;  // between two looks [s]
  static constexpr int kTimeSteps = 50;

  // The joints' angles at the end of each time step [rad].
  static std::vector<double> Angles(const Profile& profile, unsigned seed) {
    static const robot::RobotDescription humanoid = Untouchable();
    World world(humanoid, profile, humanoid.poses[0]);
    std::mt19937 random(seed);
    std::vector<double> targets(Humanoid().joints.size());
    std::vector<double> angles;
    const auto steps = std::lround(kTimeStep / world.physics_time_step());
    for (int i = 0; i < kTimeSteps; ++i) {
      if (i % 10 == 0) NextPosture(random, targets);
      for (int step = 0; step < steps; ++step) world.Step(targets);
      for (int j = 0; j < world.body().joint_count(); ++j) {
        angles.push_back(world.body().JointAngle(j));
      }
    }
    return angles;
  }

  // Root mean square of the differences.
  static double Error(const Profile& profile) {
    static constexpr Profile kReference = {"reference", 0.00002, JointDrive::kTorque, 800,
                                           SolverKind::kTree};
    double squares = 0;
    size_t count = 0;
    for (unsigned run = 1; run <= kRuns; ++run) {
      const std::vector<double> right = Angles(kReference, run);
      const std::vector<double> angles = Angles(profile, run);
      for (size_t i = 0; i < right.size(); ++i) squares += std::pow(angles[i] - right[i], 2);
      count += right.size();
    }
    return std::sqrt(squares / static_cast<double>(count));
  }

 private:
  static robot::RobotDescription Untouchable() {
    robot::RobotDescription humanoid = Humanoid();
    humanoid.poses[0].position[2] = 100;
    humanoid.contact_exclusions = CollidingLinks(humanoid);
    return humanoid;
  }
  static void NextPosture(std::mt19937& random, std::vector<double>& targets) {
    for (size_t j = 0; j < targets.size(); ++j) {
      const double low = std::max(Humanoid().joints[j].low, -1.0);
      const double high = std::min(Humanoid().joints[j].high, 1.0);
      targets[j] = std::uniform_real_distribution(low, high)(random);
    }
  }
};

struct Averages {
  Average height, distance, contacts, links, joint_speed;
};

void Run(const Profile& profile, unsigned seed, Averages& averages) {
  World world(Humanoid(), profile, Humanoid().poses[0]);
  RandomMotion motion(seed);
  std::vector<double> targets(Humanoid().joints.size());
  const auto time_steps = std::lround(kSeconds / Humanoid().controller.time_step);
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
  averages.height.Add(base[2]);
  averages.distance.Add(std::hypot(base[0], base[1]));
  averages.contacts.Add(contacts / time_steps);
  averages.links.Add(links / time_steps);
  averages.joint_speed.Add(joint_speed / time_steps / world.body().joint_count());
}

double CpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void PrintRow(const Profile& profile, int runs) {
  Averages averages;
  int diverged = 0;
  const double start = CpuSeconds();
  for (int run = 0; run < runs; ++run) {
    try {
      Run(profile, static_cast<unsigned>(run + 1), averages);
    } catch (const OdeFailure&) {
      ++diverged;
    }
  }
  const double seconds = CpuSeconds() - start;
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.1e} | {:.1f} |\n", profile.name,
             averages.height.Text(4), averages.distance.Text(3), averages.contacts.Text(2),
             averages.links.Text(2), averages.joint_speed.Text(2), diverged,
             InTheAir::Error(profile), runs * kSeconds / seconds);
}

}  // namespace
}  // namespace runtime

int main(int argc, char** argv) {
  const int runs = argc > 1 ? std::atoi(argv[1]) : 256;
  fmt::print(
      "| profile | height (m) | distance (m) | contact points | links in `contact` | joint speed "
      "(rad/s) | diverged | rms, air (rad) | × real time "
      "|\n|---|---|---|---|---|---|---|---|---|\n");
  for (const runtime::Profile& profile : runtime::kProfiles) {
    bool wanted = argc <= 2;
    for (int i = 2; i < argc; ++i) wanted |= argv[i] == profile.name;
    if (wanted && profile.IsBuilt()) runtime::PrintRow(profile, runs);
  }
}
