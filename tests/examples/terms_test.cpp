// Every term of the tasks in examples/tasks against its formula as it was published.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <utility>

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

// One task beside its formulas, through many episodes.
class Comparison {
 public:
  // `never_paid`: a term that has no weight.
  Comparison(const std::string& name, Published& published, std::string never_paid)
      : file_(SOURCE_DIR "/examples/tasks/" + name + ".task"),
        task_(golden::ReadFile(file_), "-O2", file_),
        instance_(task_),
        published_(published),
        never_paid_(std::move(never_paid)) {
    instance_.SetDiscount(kDiscount);
  }

  void Run() {
    int steps = 0;  // of the episode; 0: another one begins
    for (int i = 0; i < kStates && !testing::Test::HasFailure(); ++i) {
      if (steps == 0) StartEpisode(static_cast<taskc_uint64>(i));
      Step(++steps);
      const int end = instance_.end();
      if (end >= 0) EndEpisode(task_.plugin().ends[end].kind);
      if (end < 0 && steps % kStepsInAction == 0) {
        EndAction();
        StartAction();
      }
      if (end >= 0) steps = 0;
    }
    if (steps > 0) EndEpisode(TASKC_TRUNCATED);
    for (const auto& [term, count] : paid_)
      EXPECT_GT(count, term == never_paid_ ? -1 : 5) << term << " is hardly ever paid";
  }

 private:
  static constexpr int kStepsInAction = 4;

  void Sense(double time) {
    state_ = RandomState(random_, time);
    published_.Adapt(state_);
    examples::Sense(state_, task_.plugin(), instance_);
  }

  void StartEpisode(taskc_uint64 seed) {
    Sense(0);
    instance_.SetSeed(seed);
    instance_.Fire(TASKC_START_OF_EPISODE);
    published_.Start(state_);
    potentials_ = published_.Potentials(state_, instance_);
    StartAction();
  }

  void StartAction() {
    instance_.Fire(TASKC_START_OF_ACTION);
    published_.StartAction();
  }

  void Step(int number) {
    Sense(number * kTimeStep);
    // Before a goal is drawn anew.
    const Payments expected = published_.Step(state_, instance_);
    Fire(TASKC_END_OF_TIME_STEP, expected);
  }

  void EndAction() {
    const Payments now = published_.Potentials(state_, instance_);
    Payments expected;
    for (const auto& [term, value] : now) expected[term] = kDiscount * value - potentials_.at(term);
    potentials_ = now;
    Fire(TASKC_END_OF_ACTION, expected);
  }

  void EndEpisode(taskc_int32 outcome) {
    const bool is_limit = outcome == TASKC_TRUNCATED;
    Payments expected;
    for (const auto& [term, value] : published_.Potentials(state_, instance_))
      expected[term] = (is_limit ? kDiscount * value : 0) - potentials_.at(term);
    instance_.SetOutcome(outcome);
    Fire(TASKC_END_OF_EPISODE, expected);
  }

  void Fire(int event, const Payments& expected) {
    instance_.ClearTerms();
    instance_.Fire(event, event == TASKC_END_OF_TIME_STEP ? kTimeStep : 0);
    ExpectEqual(task_.plugin(), instance_, expected, paid_);
    EXPECT_EQ(instance_.fault(), -1);
  }

  const std::string file_;
  const compiler::CompiledTask task_;
  compiler::Instance instance_;
  Published& published_;
  const std::string never_paid_;
  std::mt19937_64 random_{1};
  RobotState state_;
  Payments potentials_;  // where the action has begun
  std::map<std::string, int> paid_;
};

void Compare(const std::string& name, const std::unique_ptr<Published>& published,
             const std::string& never_paid = "") {
  Comparison(name, *published, never_paid).Run();
}

TEST(Terms, OfFollow) { Compare("follow", OwnFollow()); }
TEST(Terms, OfGetUp) { Compare("get_up", PlaygroundGetUp()); }
TEST(Terms, OfGuided) { Compare("guided", NgGuided(), "progress"); }
TEST(Terms, OfLeap) { Compare("leap", OwnLeap()); }
TEST(Terms, OfMarch) { Compare("march", SiekmannMarch()); }
TEST(Terms, OfPressUp) { Compare("press_up", OwnPressUp()); }
TEST(Terms, OfStand) { Compare("stand", DmControlStand()); }
TEST(Terms, OfTargets) { Compare("targets", IsaacLabTargets()); }
TEST(Terms, OfTrack) { Compare("track", DeepMimicTrack()); }
TEST(Terms, OfTrackSpeed) { Compare("track_speed", OwnTrackSpeed()); }
TEST(Terms, OfVelocity) { Compare("velocity", IsaacLabVelocity()); }
TEST(Terms, OfWalk) { Compare("walk", DmControlWalk()); }

}  // namespace
}  // namespace examples
