// A whole task: what its declarations and statements become.
#include <gmock/gmock.h>

#include <limits>

#include "compiler/check/fold.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

const CheckedBlock& BlockOf(const CheckedTask& task, EventKind event) {
  return task.events[static_cast<size_t>(event)].body;
}

TEST(Task, HasTheHeaderOfItsSource) {
  const CheckedTask task = CheckTask("/// Lies still.\ntask resting for humanoid\nstart lying\n");
  EXPECT_EQ(task.name, "resting");
  EXPECT_EQ(task.doc, "Lies still.");
  EXPECT_EQ(task.robot, "humanoid");
  EXPECT_THAT(task.start.poses, testing::ElementsAre("lying"));
}

TEST(Task, HasParamsInSiUnits) {
  const CheckedTask task =
      CheckTask(TaskText("param reach: real [m] = 5 cm in 0 .. 1 m\nparam steps: int = 3\n"
                         "param enabled: bool = true\nparam bend: real [rad] = 180 deg",
                         ""));
  ASSERT_EQ(task.params.size(), 4u);
  EXPECT_EQ(task.params[0].initial, 0.05);
  EXPECT_EQ(task.params[0].minimum, 0);
  EXPECT_EQ(task.params[0].maximum, 1);
  EXPECT_EQ(ToString(task.params[0].unit), "m");
  EXPECT_EQ(task.params[1].type.scalar, Scalar::kInt);
  EXPECT_EQ(task.params[1].minimum, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(task.params[1].maximum, std::numeric_limits<double>::infinity());
  EXPECT_EQ(task.params[2].initial, 1);
  EXPECT_EQ(task.params[2].minimum, 0);
  EXPECT_EQ(task.params[2].maximum, 1);
  EXPECT_DOUBLE_EQ(task.params[3].initial, 3.141592653589793);
}

TEST(Task, HasParamsFromConstantsOfAnyShape) {
  const CheckedTask task =
      CheckTask(TaskText("param far: real [m] = norm(corner) in 0 m .. 2 * corner.y\n"
                         "param near: real = norm(vec3(3, 4, 0))\n"
                         "const corner: vec3 [m] = vec3(3 m, 4 m, 0)",
                         ""));
  ASSERT_EQ(task.params.size(), 2u);
  EXPECT_EQ(task.params[0].initial, 5);
  EXPECT_EQ(task.params[0].maximum, 8);
  EXPECT_EQ(task.params[1].initial, 5);
}

TEST(Task, HasConstsAndSets) {
  const CheckedTask task = CheckTask(
      TaskText("const wide: real[joint] = 0.5\nconst turn: real [rad] = half * 180 deg\n"
               "const half: real = 1 / most\nconst most: int = 2\n"
               "set soles = feet\nset others = links - soles - {2..15}\nset few = most - 1..3",
               "reward a = turn / 1 rad + wide[3] + joint.angle[most + 1] / 1 rad\n"
               "for l in others { if contact[l] { reward b = 1 } }"));
  ASSERT_EQ(task.consts.size(), 4u);
  EXPECT_EQ(task.consts[0].elements, std::vector<double>(17, 0.5));
  EXPECT_DOUBLE_EQ(task.consts[3].elements[0], 1.5707963267948966);
  ASSERT_EQ(task.sets.size(), 3u);
  EXPECT_EQ(task.sets[0].parts, "link");
  EXPECT_EQ(task.sets[0].names, (std::vector<std::string>{"left_foot", "right_foot"}));
  EXPECT_EQ(task.sets[1].names, (std::vector<std::string>{"body", "head", "right_ankle"}));
  EXPECT_EQ(task.sets[2].indices, (std::vector<uint32_t>{1, 2, 3}));
  EXPECT_EQ(std::get<CheckedFor>(BlockOf(task, EventKind::kEndOfTimeStep)[1].node).passes.size(),
            3u);
}

TEST(Task, HasMemoryOfThreeScopes) {
  const CheckedTask task = CheckTask(
      TaskText("memory a: real = 1\nmemory b: bool = false per action\nmemory c: int = 2 per run\n"
               "memory d: vec3 [m] = 5 cm\nmemory e: real = gain\nparam gain: real = 3",
               ""));
  ASSERT_EQ(task.memory.size(), 5u);
  EXPECT_EQ(task.memory[0].scope, MemoryScope::kPerEpisode);
  EXPECT_EQ(ToString(task.memory[0].initial.type), "real");
  EXPECT_EQ(task.memory[1].scope, MemoryScope::kPerAction);
  EXPECT_EQ(task.memory[2].scope, MemoryScope::kPerRun);
  EXPECT_EQ(ValueOf(task.memory[3].initial), 0.05);
  EXPECT_EQ(ToString(task.memory[3].initial.type), "real");
  EXPECT_EQ(std::get<ParamRead>(task.memory[4].initial.node).param, 0u);
}

TEST(Task, HasOneTermForAllStatementsThatPayIt) {
  const std::string text = TaskText("",
                                    "/// The way ahead.\nreward rate forward = base.velocity.x\nif "
                                    "contact[head] {\n  reward fall = -1\n"
                                    "}\nif contact[body] {\n  reward fall = -2\n}");
  const CheckedTask task = CheckTask(text);
  ASSERT_EQ(task.terms.size(), 2u);
  EXPECT_EQ(task.terms[0].name, "forward");
  EXPECT_EQ(task.terms[1].name, "fall");
  EXPECT_EQ(task.terms[0].doc, "The way ahead.");
  EXPECT_EQ(task.terms[1].span.begin, text.find("reward fall = -1"));
}

TEST(Task, PaysAnonymousRewardsToTheTermCalledReward) {
  const CheckedTask task =
      CheckTask("task paying for humanoid\non end_of_action {\n  reward += 2\n  reward -= 3\n}\n");
  ASSERT_EQ(task.terms.size(), 1u);
  EXPECT_EQ(task.terms[0].name, "reward");
  const CheckedBlock& block = BlockOf(task, EventKind::kEndOfAction);
  ASSERT_EQ(block.size(), 2u);
  EXPECT_EQ(ValueOf(std::get<CheckedReward>(block[0].node).value), 2);
  EXPECT_EQ(ValueOf(std::get<CheckedReward>(block[1].node).value), -3);
}

TEST(Task, HasOneEndForEachStatement) {
  const std::string text = TaskText("",
                                    "if contact[head] { end_episode failure \"falls\" }\n"
                                    "if base.position.x > 1 m { end_episode success \"arrives\" }\n"
                                    "if time > 20 s { truncate_episode \"time is up\" }");
  const CheckedTask task = CheckTask(text);
  ASSERT_EQ(task.ends.size(), 3u);
  EXPECT_EQ(task.ends[0].kind, EndKind::kFailure);
  EXPECT_EQ(task.ends[0].reason, "falls");
  EXPECT_EQ(task.ends[0].span.begin, text.find("end_episode failure"));
  EXPECT_EQ(task.ends[1].kind, EndKind::kSuccess);
  EXPECT_EQ(task.ends[2].kind, EndKind::kTruncated);
}

TEST(Task, RemembersThatItHasEndedTheEpisode) {
  const std::string end = "if contact[head] { end_episode failure \"falls\" }";
  const CheckedTask task = CheckTask(TaskText("memory n: int = 0", "n += 1\n" + end));
  ASSERT_EQ(task.ended, 1u);
  EXPECT_FALSE(task.memory[1].is_declared);
  EXPECT_EQ(task.memory[1].scope, MemoryScope::kPerEpisode);
  EXPECT_TRUE(CheckTask(TaskText("", "require base.position.z > 0 m")).ended);
  EXPECT_TRUE(CheckTask(TaskText("after_end stop", end)).ended);
  EXPECT_FALSE(CheckTask(TaskText("after_end continue", end)).ended);
  EXPECT_FALSE(CheckTask(TaskText("", "reward a = 1")).ended);
  EXPECT_FALSE(CheckTask("task t for humanoid\n"
                         "on end_of_episode { require base.position.z > 0 m }\n")
                   .ended);
}

TEST(Task, HasMetricsAsReals) {
  const CheckedTask task = CheckTask(
      "task measured for humanoid\n/// Links on the ground.\nmetric max touches = count(contact)\n"
      "metric sum rolls = base.angular_velocity.y * time_step / 360 deg\n");
  ASSERT_EQ(task.metrics.size(), 2u);
  EXPECT_EQ(task.metrics[0].name, "touches");
  EXPECT_EQ(task.metrics[0].doc, "Links on the ground.");
  EXPECT_EQ(task.metrics[0].reduction, Reduction::kMax);
  EXPECT_EQ(ToString(task.metrics[0].value.type), "real");
  EXPECT_EQ(ToString(task.metrics[1].value.unit), "");
}

TEST(Task, KnowsWhichEventsItDeclares) {
  const CheckedTask task = CheckTask("task quiet for humanoid\non end_of_action {\n}\n");
  EXPECT_TRUE(task.events[static_cast<size_t>(EventKind::kEndOfAction)].is_declared);
  EXPECT_FALSE(task.events[static_cast<size_t>(EventKind::kStartOfAction)].is_declared);
}

TEST(Task, HasLocalsForEachEvent) {
  const CheckedTask task =
      CheckTask(TaskText("", "if contact[head] {\n  let x = 1 m\n} else {\n  let x = true\n}") +
                "on end_of_action {\n  let y = 2\n}\n");
  const auto& locals = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)].locals;
  ASSERT_EQ(locals.size(), 2u);
  EXPECT_EQ(ToString(locals[0].unit), "m");
  EXPECT_EQ(ToString(locals[1].type), "bool");
  EXPECT_EQ(task.events[static_cast<size_t>(EventKind::kEndOfAction)].locals.size(), 1u);
}

TEST(Task, KeepsTheBranchesOfAnIf) {
  const CheckedTask task = CheckTask(TaskText(
      "",
      "if contact[head] {\n reward a = 1\n} else if contact[body] {\n} else {\n reward b = 2\n}"));
  const auto& branches = std::get<CheckedIf>(BlockOf(task, EventKind::kEndOfTimeStep).at(0).node);
  ASSERT_EQ(branches.branches.size(), 2u);
  EXPECT_EQ(branches.branches[0].body.size(), 1u);
  EXPECT_EQ(branches.branches[1].body.size(), 0u);
  EXPECT_EQ(branches.otherwise.size(), 1u);
}

}  // namespace
}  // namespace compiler
