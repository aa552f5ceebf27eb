// When goals are drawn, and what they become.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "compiler/interpret/evaluator.h"
#include "compiler/interpret/random_numbers.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

using testing::ElementsAre;

constexpr double kQuarter = 0.25;  // [s]; exact, so that sums of it are

class GoalRun {
 public:
  explicit GoalRun(const std::string& text)
      : task_(CheckTask("task tested\nsensor x: real\n" + text)), evaluator_(task_) {}

  void Start(uint64_t seed = 1) {
    evaluator_.frame().seed = seed;
    evaluator_.Fire(EventKind::kStartOfEpisode, 0);
  }
  void Step() { evaluator_.Fire(EventKind::kEndOfTimeStep, kQuarter); }
  Reals Value(const std::string& memory) const {
    for (size_t i = 0; i < task_.memory.size(); ++i) {
      if (task_.memory[i].name == memory) return ToReals(evaluator_.frame().memory[i]);
    }
    throw std::runtime_error("no memory " + memory);
  }
  void Set(const std::string& memory, double value) {
    for (size_t i = 0; i < task_.memory.size(); ++i) {
      const Type& type = task_.memory[i].type;
      if (task_.memory[i].name == memory)
        evaluator_.frame().memory[i] = Filled(type.scalar, type.size(), value);
    }
  }
  Frame& frame() { return evaluator_.frame(); }

 private:
  CheckedTask task_;
  Evaluator evaluator_;
};

const std::string kUse = "on end_of_time_step { reward a = x * norm(vec2(aim, aim)) }\n";

TEST(Goals, AreDrawnFromTheirPlace) {
  GoalRun run("goal aim: real = 1 + uniform(2, 4)\n" + kUse);
  run.Start(99);
  // The FNV-1a hash of "aim", computed by another program.
  const DrawPlace place{99, 0x383251F6, 0};
  EXPECT_THAT(run.Value("aim"), ElementsAre(1 + DrawUniform(place, 0, 0, 2, 4)));
}

TEST(Goals, DrawEachElementByItself) {
  GoalRun run("goal v: vec3 = uniform(0, 1)\ngoal aim: real = v.x\n" + kUse);
  run.Start();
  const Reals v = run.Value("v");
  EXPECT_EQ((std::set<double>(v.begin(), v.end()).size()), 3u);
  EXPECT_THAT(run.Value("aim"), ElementsAre(v[0]));
}

TEST(Goals, DrawANumberForEachElementThatItStandsFor) {
  GoalRun run(
      "memory origin: vec2 = 0\nmemory length: real = 0\n"
      "goal target: vec2 = origin + 2 * uniform(0, 1)\n"
      "goal far: vec2 = origin + max(uniform(0, 1), 0.0)\n"
      "goal way: vec3 = choose(1, 2, 3, 4, 5, 6, 7, 8)\n"
      "goal corner: vec2 = choose(vec2(0, 0), vec2(1, 1), vec2(2, 2))\n"
      "goal heading: vec2 = normalize(vec2(normal(0, 1), normal(0, 1)))\n"
      "on end_of_time_step {\n  origin.x += x\n  length += x\n"
      "  reward a = norm(target) + norm(far) + norm(way) + norm(corner) + norm(heading) + "
      "length\n}\n");
  std::set<double> ways;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    run.Start(seed);
    EXPECT_NE(run.Value("target")[0], run.Value("target")[1]);
    EXPECT_NE(run.Value("far")[0], run.Value("far")[1]);
    EXPECT_EQ(run.Value("corner")[0], run.Value("corner")[1]);
    EXPECT_DOUBLE_EQ(std::hypot(run.Value("heading")[0], run.Value("heading")[1]), 1);
    ways.insert(run.Value("way")[0] - run.Value("way")[1]);
  }
  EXPECT_GT(ways.size(), 5u);
}

TEST(Goals, HaveTheSameValuesForTheSameSeed) {
  GoalRun run("goal aim: real = normal(0, 1)\n" + kUse);
  run.Start(5);
  const Reals first = run.Value("aim");
  run.Start(6);
  EXPECT_NE(run.Value("aim"), first);
  run.Start(5);
  EXPECT_EQ(run.Value("aim"), first);
}

TEST(Goals, HaveAValueBeforeTheFirstEpisode) {
  const GoalRun run("goal aim: real = uniform(3, 4)\n" + kUse);
  EXPECT_GE(run.Value("aim")[0], 3);
}

TEST(Goals, StayForTheirTimeAndChangeAtTheNearestStep) {
  GoalRun run("goal aim: real = uniform(0, 1) per 0.6 s\n" + kUse);
  run.Start();
  Reals value = run.Value("aim");
  for (const bool changes : {false, true, false, true, false, true}) {  // 0.5 s is nearest to 0.6 s
    run.Step();
    EXPECT_EQ(run.Value("aim") != value, changes);
    value = run.Value("aim");
  }
}

TEST(Goals, StayBetweenTheShortestAndTheLongestTime) {
  GoalRun run("goal aim: real = uniform(0, 1) per 1 s .. 2 s\n" + kUse);
  std::set<int> lengths;
  run.Start();
  Reals value = run.Value("aim");
  int steps = 0;
  for (int i = 0; i < 1000; ++i) {
    run.Step();
    ++steps;
    if (run.Value("aim") == value) continue;
    value = run.Value("aim");
    lengths.insert(std::exchange(steps, 0));
  }
  EXPECT_THAT(lengths, ElementsAre(4, 5, 6, 7, 8));
}

TEST(Goals, AreDrawnAnewAtOnce) {
  GoalRun run(
      "goal aim: real = uniform(0, 1)\nmemory before: real = 0\nmemory after: real = 0\n"
      "on end_of_time_step {\n  before = aim\n  redraw aim\n  after = aim\n"
      "  reward a = x * (before + after)\n}\n");
  run.Start();
  const Reals first = run.Value("aim");
  run.Step();
  EXPECT_EQ(run.Value("before"), first);
  EXPECT_NE(run.Value("after"), first);
  EXPECT_EQ(run.Value("after"), run.Value("aim"));
  EXPECT_THAT(run.Value("aim#draws"), ElementsAre(2));
}

TEST(Goals, ThatAreHeldAreNotDrawn) {
  GoalRun run(
      "goal aim: real = uniform(0, 1) per 0.25 s\n"
      "on end_of_time_step { redraw aim reward a = x * aim }\n");
  run.Set("aim", 7);
  run.Set("aim#held", 1);
  run.Start();
  run.Step();
  EXPECT_THAT(run.Value("aim"), ElementsAre(7));
  run.Set("aim#held", 0);
  run.Step();
  EXPECT_LT(run.Value("aim")[0], 1);
}

TEST(Goals, FollowMemoryAndParams) {
  GoalRun run(
      "param far: real = 10\nmemory level: real = 1 per run\n"
      "goal aim: real = far * level + choose(0, 0)\n"
      "on end_of_time_step {\n  level += 1\n  reward a = x * aim\n}\n");
  run.Start();
  EXPECT_THAT(run.Value("aim"), ElementsAre(10));
  run.Step();
  run.frame().params[0] = 100;
  run.Start();
  EXPECT_THAT(run.Value("aim"), ElementsAre(200));
}

}  // namespace
}  // namespace compiler
