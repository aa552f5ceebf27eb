// What a start draws.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/interpret/evaluator.h"
#include "compiler/interpret/random_numbers.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

using testing::Each;
using testing::ElementsAre;

class StartRun {
 public:
  explicit StartRun(const std::string& start, const std::string& rest = "")
      : task_(CheckTask("task tested for humanoid\n" + rest + "start " + start + "\n")),
        evaluator_(task_) {}

  void Draw(uint64_t seed, uint32_t attempt = 0) {
    evaluator_.frame().seed = seed;
    evaluator_.frame().attempt = attempt;
    evaluator_.DrawPose();
    evaluator_.DrawStart();
  }
  Reals& Of(const std::string& name) {
    for (const CheckedStartValue& value : task_.start.values)
      if (value.name == name) return std::get<Reals>(evaluator_.frame().memory[value.memory]);
    throw std::runtime_error("no value " + name);
  }
  Reals Memory(const std::string& name) const {
    for (size_t i = 0; i < task_.memory.size(); ++i)
      if (task_.memory[i].name == name) return std::get<Reals>(evaluator_.frame().memory[i]);
    throw std::runtime_error("no memory " + name);
  }
  Evaluator& evaluator() { return evaluator_; }
  const CheckedTask& task() const { return task_; }

 private:
  CheckedTask task_;
  Evaluator evaluator_;
};

TEST(Starts, DrawAPoseEachAsLikely) {
  StartRun run("standing or lying or sitting");
  int counts[3] = {};
  for (uint64_t seed = 0; seed < 3000; ++seed) {
    run.Draw(seed);
    ++counts[run.evaluator().frame().pose];
  }
  for (const int count : counts) EXPECT_NEAR(count, 1000, 100);
}

TEST(Starts, OfOnePoseDrawNothing) {
  StartRun run("lying");
  run.Draw(7);
  EXPECT_EQ(run.evaluator().frame().pose, 0);
  EXPECT_THAT(run.task().start.poses, ElementsAre("lying"));
  EXPECT_TRUE(run.task().start.values.empty());
}

TEST(Starts, ChangeWhatTheHostHasFilledIn) {
  StartRun run("standing { base.position.x += 1 m base.position.yz = 2 m joint.angle *= 2 }");
  run.Of("base.position") = {3, 4, 5};
  run.Of("joint.angle").assign(17, 0.25);
  run.Draw(1);
  EXPECT_THAT(run.Of("base.position"), ElementsAre(4, 2, 2));
  EXPECT_THAT(run.Of("joint.angle"), Each(0.5));
}

TEST(Starts, DrawEachElementByItself) {
  StartRun run("standing { joint.velocity += uniform(-1 rad/s, 1 rad/s) }");
  run.Draw(1);
  const Reals first = run.Of("joint.velocity");
  EXPECT_EQ(std::set<double>(first.begin(), first.end()).size(), first.size());
  std::ranges::fill(run.Of("joint.velocity"), 0.0);
  run.Draw(1);
  EXPECT_EQ(run.Of("joint.velocity"), first);
  std::ranges::fill(run.Of("joint.velocity"), 0.0);
  run.Draw(2);
  EXPECT_NE(run.Of("joint.velocity"), first);
}

// The first random number is that of the pose; the FNV-1a hash of "start#" was computed by another
// program.
TEST(Starts, DrawFromTheirPlace) {
  StartRun run("standing { base.yaw = uniform(1 rad, 2 rad) base.roll = uniform(1 rad, 2 rad) }");
  run.Draw(99);
  const DrawPlace place{99, run.task().start.stream, 0};
  EXPECT_THAT(run.Of("base.yaw"), ElementsAre(DrawUniform(place, 0, 1, 1, 2)));
  EXPECT_THAT(run.Of("base.roll"), ElementsAre(DrawUniform(place, 0, 2, 1, 2)));
}

TEST(Starts, ReadGoalsAsTheEpisodeWillHaveThem) {
  StartRun run("standing { base.yaw = turn }",
               "memory most: real [rad] = 1 rad\ngoal turn: real [rad] = uniform(-most, most)\n"
               "on end_of_time_step { reward rate a = turn most = 3 rad }\n");
  run.evaluator().frame().seed = 5;
  run.evaluator().Fire(EventKind::kStartOfEpisode, 0);
  run.evaluator().Fire(EventKind::kEndOfTimeStep, 0.25);  // changes what goals are drawn from
  run.Draw(6);
  const double yaw = run.Of("base.yaw")[0];
  run.evaluator().Fire(EventKind::kStartOfEpisode, 0);
  EXPECT_EQ(run.Memory("turn")[0], yaw);
}

TEST(Starts, AreOthersInEachAttemptWithTheSamePoseAndGoals) {
  StartRun run("standing or lying { base.yaw = turn base.roll = uniform(1 rad, 2 rad) }",
               "goal turn: real [rad] = uniform(-1 rad, 1 rad)\n"
               "on end_of_time_step { reward rate a = turn }\n");
  std::set<int> poses;
  std::set<double> yaws;
  for (uint32_t attempt = 0; attempt < 20; ++attempt) {
    run.Draw(99, attempt);
    poses.insert(run.evaluator().frame().pose);
    yaws.insert(run.Of("base.yaw")[0]);
    const DrawPlace place{99, run.task().start.stream, attempt};
    EXPECT_THAT(run.Of("base.roll"), ElementsAre(DrawUniform(place, 0, 1, 1, 2)));
  }
  EXPECT_EQ(poses.size(), 1u);
  EXPECT_EQ(yaws.size(), 1u);
}

TEST(Starts, BranchAndLoop) {
  StartRun run(
      "standing {\n  let fast = choose(true, false)\n"
      "  if fast { base.velocity.x = 1 m/s } else { base.velocity.x = 2 m/s }\n"
      "  for j in left_leg_joints { joint.angle[j] += uniform(0 rad, 0.1 rad) }\n}",
      "set left_leg_joints = {left_knee_pitch, left_hip_pitch}\n");
  std::set<double> seen;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    run.Draw(seed);
    seen.insert(run.Of("base.velocity")[0]);
  }
  EXPECT_THAT(seen, ElementsAre(1, 2));
  EXPECT_EQ(std::ranges::count(run.Of("joint.angle"), 0.0), 15);
}

}  // namespace
}  // namespace compiler
