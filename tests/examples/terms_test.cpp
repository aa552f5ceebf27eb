// Every term of the tasks in examples/tasks against its formula as it was published.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <span>
#include <string>

#include "tests/compiler/emit/compiled_task.h"
#include "tests/examples/published.h"
#include "tests/examples/robot_state.h"
#include "tests/golden.h"

namespace examples {
namespace {

constexpr int kStates = 1000;

// Subnormal numbers have fewer digits.
bool AreClose(double a, double b) {
  const double larger = std::max(std::abs(a), std::abs(b));
  return std::abs(a - b) <= 1e-12 * larger || larger < std::numeric_limits<double>::min();
}

// Counts in `paid` how often each term pays something.
void ExpectEqual(const taskc_plugin& plugin, const compiler::Instance& instance,
                 const Payments& published, std::map<std::string, int>& paid) {
  for (const taskc_reward_term& term : std::span(plugin.terms, plugin.term_count)) {
    const auto found = published.find(term.name);
    const double expected = found == published.end() ? 0 : found->second;
    EXPECT_PRED2(AreClose, instance.Term(term.name), expected) << term.name;
    paid[term.name] += expected != 0;
  }
}

void Compare(const std::string& name, Published& published) {
  const std::string file = SOURCE_DIR "/examples/tasks/" + name + ".task";
  const compiler::CompiledTask task(golden::ReadFile(file), "-O2", file);
  compiler::Instance instance(task);
  std::mt19937_64 random(1);
  std::map<std::string, int> paid;
  const auto next_state = [&](double time) {
    RobotState state = RandomState(random, time);
    published.Adapt(state);
    return state;
  };
  int steps = 0;  // of the episode; 0: another one begins
  for (int i = 0; i < kStates && !testing::Test::HasFailure(); ++i) {
    if (steps == 0) {
      const RobotState first = next_state(0);
      Sense(first, task.plugin(), instance);
      instance.SetSeed(static_cast<taskc_uint64>(i));
      instance.Fire(TASKC_START_OF_EPISODE);
      published.Start(first);
    }
    const RobotState state = next_state(++steps * kTimeStep);
    Sense(state, task.plugin(), instance);
    const Payments expected = published.Step(state, instance);  // before a goal is drawn anew
    instance.ClearTerms();
    instance.Fire(TASKC_END_OF_TIME_STEP, kTimeStep);
    ExpectEqual(task.plugin(), instance, expected, paid);
    EXPECT_EQ(instance.fault(), -1);
    if (instance.end() >= 0) steps = 0;
  }
  for (const auto& [term, count] : paid) EXPECT_GT(count, 5) << term << " is hardly ever paid";
}

TEST(Terms, OfGetUp) { Compare("get_up", *PlaygroundGetUp()); }
TEST(Terms, OfLeap) { Compare("leap", *OwnLeap()); }
TEST(Terms, OfMarch) { Compare("march", *SiekmannMarch()); }
TEST(Terms, OfPressUp) { Compare("press_up", *OwnPressUp()); }
TEST(Terms, OfStand) { Compare("stand", *DmControlStand()); }
TEST(Terms, OfTargets) { Compare("targets", *IsaacLabTargets()); }
TEST(Terms, OfTrack) { Compare("track", *DeepMimicTrack()); }
TEST(Terms, OfVelocity) { Compare("velocity", *IsaacLabVelocity()); }
TEST(Terms, OfWalk) { Compare("walk", *DmControlWalk()); }

}  // namespace
}  // namespace examples
