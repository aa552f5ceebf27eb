// Whole plugins, called as a host calls them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <taskc/largest_reward.h>

#include <limits>

#include "base/seal/sha256.h"
#include "tests/compiler/emit/compiled_task.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using testing::DoubleNear;
using testing::StrEq;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kStep = 0.005;

// The task of section II-A, shortened.
constexpr const char* kCrawling = R"(/// Move forward.
task crawling for humanoid
start standing
/// What a fall costs.
param fall_penalty: real = 4 in 0 .. 20
memory sum_of_reward: real = 0
memory fallen: bool = false per action
metric distance = base.position.x
metric max height = base.position.z
on end_of_time_step {
  reward rate forward = 0.25 / 5 ms * dot(base.velocity.xy, base.up.xy)
  reward rate turning = -0.025 / 5 ms * abs(base.angular_velocity.z)
  if not fallen and any(contact[body, head]) {
    fallen = true
    reward fall = -fall_penalty
  }
  sum_of_reward += reward
  if sum_of_reward < -40 { end_episode failure "falls too often" }
  if time > 20 s { truncate_episode "time is up" }
}
)";

class Crawling : public testing::Test {
 protected:
  static void SetUpTestSuite() { task_ = std::make_unique<CompiledTask>(kCrawling); }
  static void TearDownTestSuite() { task_.reset(); }

  Crawling() : instance_(*task_) {
    instance_.Fire(TASKC_START_OF_EPISODE);
    instance_.Fire(TASKC_START_OF_ACTION);
  }

  void TouchGround(size_t link) {
    std::vector<double> contact(18);
    contact[link] = 1;
    instance_.Sense("contact", contact);
  }
  void Step() { instance_.Fire(TASKC_END_OF_TIME_STEP, kStep); }

  static std::unique_ptr<CompiledTask> task_;
  Instance instance_;
};
std::unique_ptr<CompiledTask> Crawling::task_;

TEST_F(Crawling, PaysWhatThePaperSays) {
  instance_.Sense("base.velocity", {2, 3, 9});
  instance_.Sense("base.up", {0.8, 0.1, 0.5});
  instance_.Sense("base.angular_velocity", {9, 9, -0.6});
  Step();
  // Per step of 5 ms: 0.25 (2 * 0.8 + 3 * 0.1) - 0.025 * 0.6.
  EXPECT_THAT(instance_.Term("forward"), DoubleNear(0.475, 1e-12));
  EXPECT_THAT(instance_.Term("turning"), DoubleNear(-0.015, 1e-12));
  EXPECT_THAT(instance_.reward(), DoubleNear(0.46, 1e-12));
  EXPECT_EQ(instance_.Term("fall"), 0);
  EXPECT_EQ(instance_.end(), -1);
  EXPECT_EQ(instance_.fault(), -1);
}

TEST_F(Crawling, PaysARateInProportionToTheStep) {
  instance_.Sense("base.velocity", {2, 0, 0});
  instance_.Sense("base.up", {1, 0, 0});
  instance_.Fire(TASKC_END_OF_TIME_STEP, kStep / 25);
  EXPECT_THAT(instance_.reward(), DoubleNear(0.02, 1e-12));
}

TEST_F(Crawling, PaysAFallOnceInAnAction) {
  TouchGround(1);
  Step();
  EXPECT_EQ(instance_.reward(), -4);
  Step();
  EXPECT_EQ(instance_.reward(), 0);
  instance_.Fire(TASKC_START_OF_ACTION);
  Step();
  EXPECT_EQ(instance_.reward(), -4);
  EXPECT_EQ(instance_.Term("fall"), -8);
  EXPECT_EQ(instance_.Memory("sum_of_reward"), -8);
}

TEST_F(Crawling, DoesNotMindOtherLinks) {
  TouchGround(4);
  Step();
  EXPECT_EQ(instance_.reward(), 0);
}

TEST_F(Crawling, TakesThePresentValueOfAParam) {
  instance_.SetParam("fall_penalty", 7);
  TouchGround(0);
  Step();
  EXPECT_EQ(instance_.reward(), -7);
}

TEST_F(Crawling, ForgetsAtTheStartOfAnEpisode) {
  TouchGround(0);
  Step();
  EXPECT_EQ(instance_.Memory("fallen"), 1);
  instance_.Fire(TASKC_START_OF_EPISODE);
  EXPECT_EQ(instance_.Memory("fallen"), 0);
  EXPECT_EQ(instance_.Memory("sum_of_reward"), 0);
}

TEST_F(Crawling, EndsForTheFirstReason) {
  instance_.SetParam("fall_penalty", 41);
  TouchGround(0);
  instance_.Sense("time", {20.5});
  Step();
  ASSERT_EQ(instance_.end(), 0);
  EXPECT_THAT(task_->plugin().ends[0].reason, StrEq("falls too often"));
  EXPECT_EQ(task_->plugin().ends[0].kind, TASKC_FAILURE);
  EXPECT_EQ(task_->plugin().ends[1].kind, TASKC_TRUNCATED);
}

TEST_F(Crawling, IsTruncatedAfterTwentySeconds) {
  instance_.Sense("time", {20});
  Step();
  EXPECT_EQ(instance_.end(), -1);
  instance_.Sense("time", {20.005});
  Step();
  EXPECT_EQ(instance_.end(), 1);
}

TEST_F(Crawling, ReportsAndDoesNotPayWhatIsNotFinite) {
  instance_.Sense("base.velocity", {kNan, 0, 0});
  instance_.Sense("base.angular_velocity", {0, 0, -0.6});
  Step();
  EXPECT_EQ(instance_.fault(), 0);
  EXPECT_EQ(instance_.Term("forward"), 0);
  EXPECT_THAT(instance_.reward(), DoubleNear(-0.015, 1e-12));
  instance_.Sense("base.angular_velocity", {0, 0, kInfinity});
  Step();
  EXPECT_EQ(instance_.fault(), 0) << "the first one counts";
  instance_.Sense("base.velocity", {0, 0, 0});
  Step();
  EXPECT_EQ(instance_.fault(), 1);
  EXPECT_EQ(instance_.reward(), 0);
}

TEST_F(Crawling, MeasuresItsMetrics) {
  instance_.Sense("base.position", {1.25, 3, 0.24});
  instance_.Measure();
  EXPECT_EQ(instance_.Metric("distance"), 1.25);
  EXPECT_EQ(instance_.Metric("height"), 0.24);
  EXPECT_EQ(task_->plugin().metrics[0].reduction, TASKC_LAST);
  EXPECT_EQ(task_->plugin().metrics[1].reduction, TASKC_MAX);
}

TEST_F(Crawling, SharesNothingBetweenInstances) {
  Instance other(*task_);
  other.Fire(TASKC_START_OF_EPISODE);
  TouchGround(0);
  Step();
  other.Fire(TASKC_END_OF_TIME_STEP, kStep);
  EXPECT_EQ(instance_.Memory("sum_of_reward"), -4);
  EXPECT_EQ(other.Memory("sum_of_reward"), 0);
  EXPECT_EQ(other.Term("fall"), 0);
}

TEST_F(Crawling, DescribesItself) {
  const taskc_plugin& plugin = task_->plugin();
  EXPECT_EQ(plugin.abi_version, TASKC_ABI_VERSION);
  EXPECT_EQ(plugin.struct_size, sizeof(taskc_plugin));
  EXPECT_THAT(plugin.name, StrEq("crawling"));
  EXPECT_THAT(plugin.doc, StrEq("Move forward."));
  EXPECT_THAT(plugin.robot, StrEq("humanoid"));
  ASSERT_EQ(plugin.pose_count, 1u);
  EXPECT_THAT(plugin.poses[0].name, StrEq("standing"));
  ASSERT_EQ(plugin.source_count, 1u);
  EXPECT_THAT(plugin.sources[0].text, StrEq(kCrawling));
  EXPECT_THAT(plugin.source_hash, StrEq(seal::Sha256(kCrawling)));
  ASSERT_EQ(plugin.param_count, 1u);
  EXPECT_THAT(plugin.params[0].doc, StrEq("What a fall costs."));
  EXPECT_EQ(plugin.params[0].initial, 4);
  EXPECT_EQ(plugin.params[0].maximum, 20);
  ASSERT_EQ(plugin.term_count, 3u);
  EXPECT_THAT(plugin.terms[2].name, StrEq("fall"));
  EXPECT_EQ(plugin.terms[2].place.source, 0u);
  EXPECT_EQ(plugin.terms[2].place.line, 15u);
  ASSERT_EQ(plugin.memory_count, 3u);
  EXPECT_EQ(plugin.memory[1].scope, TASKC_PER_ACTION);
  EXPECT_THAT(plugin.memory[2].name, StrEq("ended#"));
  EXPECT_EQ(plugin.memory[2].scope, TASKC_PER_EPISODE);
  EXPECT_LE(plugin.memory[1].offset + 1, plugin.memory_size);
}

TEST_F(Crawling, ReadsOnlyWhatItUses) {
  std::map<std::string, unsigned> read_by;
  const taskc_plugin& plugin = task_->plugin();
  for (unsigned i = 0; i < plugin.sensor_count; ++i) {
    read_by[plugin.sensors[i].name] = plugin.sensors[i].read_by;
  }
  unsigned step = 1u << TASKC_END_OF_TIME_STEP;
  unsigned measure = 1u << TASKC_MEASURE;
  EXPECT_EQ(read_by, (std::map<std::string, unsigned>{{"base.angular_velocity", step},
                                                      {"base.position", measure},
                                                      {"base.up", step},
                                                      {"base.velocity", step},
                                                      {"contact", step},
                                                      {"time", step}}));
}

TEST_F(Crawling, HasFunctionsOnlyForWhatItDoes) {
  const taskc_plugin& plugin = task_->plugin();
  for (int event = 0; event < TASKC_EVENT_COUNT; ++event) {
    // The starts of episode and action give memory its initial values.
    bool is_there = event == TASKC_START_OF_EPISODE || event == TASKC_START_OF_ACTION ||
                    event == TASKC_END_OF_TIME_STEP;
    EXPECT_EQ(plugin.events[event] != nullptr, is_there) << event;
  }
}

TEST(Plugin, ResetsMemoryByItsScope) {
  CompiledTask task(R"(task scopes
param begin: int = 3
memory run_count: int = begin per run
memory episode_count: int = begin per episode
memory action_count: int = 0 per action
on start_of_episode { episode_count += 10 }
on end_of_time_step {
  run_count += 1
  episode_count += 1
  action_count += 1
  if run_count > 100 and episode_count > 100 and action_count > 100 { truncate_episode "long" }
}
)");
  Instance instance(task);
  auto expect = [&](double run, double episode, double action) {
    EXPECT_EQ(instance.Memory("run_count"), run);
    EXPECT_EQ(instance.Memory("episode_count"), episode);
    EXPECT_EQ(instance.Memory("action_count"), action);
  };
  expect(3, 3, 0);
  instance.Fire(TASKC_START_OF_EPISODE);
  expect(3, 13, 0);  // reset first, then the user's block
  instance.Fire(TASKC_END_OF_TIME_STEP);
  instance.Fire(TASKC_END_OF_TIME_STEP);
  expect(5, 15, 2);
  instance.Fire(TASKC_START_OF_ACTION);
  expect(5, 15, 0);
  instance.Fire(TASKC_END_OF_TIME_STEP);
  instance.SetParam("begin", 5);
  instance.Fire(TASKC_START_OF_EPISODE);
  expect(6, 15, 0);
  instance.Initialize();
  expect(5, 5, 0);
}

TEST(Plugin, TakesTheBranchOfTheFirstConditionThatHolds) {
  CompiledTask task(R"(task branches
sensor v: vec3
memory branch: int = 0
metric last_branch = branch
on end_of_time_step {
  if v.x > 1 { branch = 1 }
  else if norm(2 * v) > 4 { branch = 2 }
  else if v.y < 0 {
    if v.z > 0 { branch = 3 } else { branch = 4 }
  } else { branch = 5 }
  if branch > 9 { end_episode success "never" }
}
)");
  auto branch = [&](std::vector<double> v) {
    Instance instance(task);
    instance.Sense("v", v);
    instance.Fire(TASKC_END_OF_TIME_STEP);
    return instance.Memory("branch");
  };
  EXPECT_EQ(branch({2, 9, 9}), 1);
  EXPECT_EQ(branch({0, 3, 0}), 2);
  EXPECT_EQ(branch({0, -1, 1}), 3);
  EXPECT_EQ(branch({0, -1, -1}), 4);
  EXPECT_EQ(branch({0, 1, 0}), 5);
}

TEST(Plugin, AssignsVectorsAsAWhole) {
  CompiledTask task(R"(task vectors
sensor v: vec3
memory p: vec3 = 0
memory q: real[40] = 2
metric size = norm(p) + sum(q)
on end_of_time_step {
  p += v
  p = p.yzx
  p *= 2
  q += q[1 .. 39, 0]
  let r = q * p.x
  q = r
  if p.x > 1000 { end_episode success "far" }
}
)");
  Instance instance(task);
  instance.Sense("v", {1, 2, 3});
  instance.Fire(TASKC_END_OF_TIME_STEP);
  EXPECT_EQ(instance.Memory("p", 0), 4);
  EXPECT_EQ(instance.Memory("p", 1), 6);
  EXPECT_EQ(instance.Memory("p", 2), 2);
  EXPECT_EQ(instance.Memory("q", 0), 16);  // (2 + 2) * 4
  EXPECT_EQ(instance.Memory("q", 39), 16);
}

TEST(Plugin, ReadsTheRewardOfTheCallSoFar) {
  CompiledTask task(R"(task sums
memory seen: real = 0
metric last_seen = seen
on start_of_action { reward += 1 }
on end_of_action {
  reward first = 2
  seen = reward
  reward -= 0.5
  reward first = reward
  if seen > 9 { end_episode success "never" }
}
)");
  Instance instance(task);
  instance.Fire(TASKC_START_OF_ACTION);
  EXPECT_EQ(instance.reward(), 1);
  instance.Fire(TASKC_END_OF_ACTION);
  EXPECT_EQ(instance.Memory("seen"), 2);
  EXPECT_EQ(instance.reward(), 3);  // 2 - 0.5 + 1.5
  EXPECT_EQ(instance.Term("first"), 3.5);
  EXPECT_EQ(instance.Term("reward"), 0.5);
}

TEST(Plugin, PaysNothingThatMakesTheRewardTooLarge) {
  CompiledTask task(R"(task huge
param size: real = 1e30
on end_of_action {
  reward first = -size
  reward second = -size
  reward third = 1e308
}
)");
  Instance instance(task);
  instance.Fire(TASKC_END_OF_ACTION);
  EXPECT_EQ(instance.reward(), -TASKC_LARGEST_REWARD);
  EXPECT_EQ(instance.fault(), 1);
  EXPECT_EQ(instance.Term("first"), -TASKC_LARGEST_REWARD);
  EXPECT_EQ(instance.Term("second"), 0);
  EXPECT_EQ(instance.Term("third"), 0);
}

TEST(Plugin, MayNameThingsLikeWordsOfCpp) {
  CompiledTask task(R"(task class
sensor new.delete: vec3 [m]
sensor new_delete: real
param double: real = 2
memory frame: real = 0
memory operator: bool = false per action
metric virtual = frame
on end_of_time_step {
  let long = double * new.delete.x
  let Pay = 3 m
  let term_goto = long + Pay
  let part = norm(new.delete - 2 * new.delete)
  operator = not operator
  reward goto = term_goto + part
  frame = new_delete
  if operator { end_episode success "namespace" }
}
)");
  Instance instance(task);
  instance.Sense("new.delete", {3, 4, 0});
  instance.Sense("new_delete", {8});
  instance.Fire(TASKC_END_OF_TIME_STEP);
  EXPECT_EQ(instance.Term("goto"), 14);  // 6 + 3 + 5
  EXPECT_EQ(instance.Memory("frame"), 8);
  EXPECT_EQ(instance.Memory("operator"), 1);
}

TEST(Plugin, CarriesAnySourceText) {
  std::string text = "task t\n";
  text +=
      "// \"quotes\", back\\slashes, trigraphs ?\?/ and ?\?=, tabs\t, \xC3\xA4 \xE2\x82\xAC\r\n";
  text += "metric one = 1\non end_of_action { end_episode success \"say \\\"?\?/\\\"\" }\n";
  // Longer than a string literal that every compiler takes.
  for (int i = 0; i < 6000; ++i) text += fmt::format("// line {}\n", i);
  ASSERT_GT(text.size(), 64u * 1024);
  CompiledTask task(text);
  EXPECT_THAT(task.plugin().sources[0].text, StrEq(text));
  EXPECT_THAT(task.plugin().ends[0].reason, StrEq("say \"?\?/\""));
}

TEST(Plugin, OfTheSmallestTaskIsWhole) {
  CompiledTask task("task nothing\n");
  const taskc_plugin& plugin = task.plugin();
  EXPECT_EQ(plugin.memory_size, 0u);
  EXPECT_EQ(plugin.sensors, nullptr);
  EXPECT_EQ(plugin.measure, nullptr);
  Instance instance(task);  // calls initialize
  for (taskc_event_function event : plugin.events) EXPECT_EQ(event, nullptr);
}

}  // namespace
}  // namespace compiler
