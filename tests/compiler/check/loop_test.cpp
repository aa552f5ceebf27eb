// Loops and `once`, as the statements that they become.
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

const CheckedBlock& BlockOf(const CheckedTask& task) {
  return task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)].body;
}

const CheckedFor& LoopOf(const CheckedTask& task) {
  return std::get<CheckedFor>(BlockOf(task).at(0).node);
}

std::vector<std::string> ValuesOf(const std::string& items) {
  const CheckedTask task = CheckTask(
      TaskText("memory n: int = 0", "for each in " + items + " { n += 1 }\nreward rate a = n"));
  std::vector<std::string> values;
  for (const CheckedPass& pass : LoopOf(task).passes) values.push_back(pass.value);
  return values;
}

using Values = std::vector<std::string>;

TEST(Loop, GoesThroughWhatItsSetSays) {
  EXPECT_EQ(ValuesOf("0..3"), (Values{"0", "1", "2", "3"}));
  EXPECT_EQ(ValuesOf("7, 2..3"), (Values{"7", "2", "3"}));
  EXPECT_EQ(ValuesOf("feet"), (Values{"left_foot", "right_foot"}));
  EXPECT_EQ(ValuesOf("{body, head} - head"), (Values{"body"}));
  EXPECT_EQ(ValuesOf("neck_yaw"), (Values{"neck_yaw"}));
}

TEST(Loop, HasItsVariableAsAConstantInEachPass) {
  const CheckedTask task = CheckTask(
      TaskText("memory heat: real[4] = 0", "for i in 1..2 { heat[i + 1] = i * heat[i] }"));
  const CheckedFor& loop = LoopOf(task);
  EXPECT_EQ(loop.variable, "i");
  const auto& assign = std::get<CheckedAssign>(loop.passes.at(1).body.at(0).node);
  EXPECT_EQ(assign.elements, (std::vector<uint32_t>{3}));
  const auto& product = std::get<CheckedBinary>(assign.value.node);
  EXPECT_EQ(std::get<Constant>(product.left->node).value, 2);
  EXPECT_EQ(std::get<Elements>(product.right->node).indices, (std::vector<uint32_t>{2}));
}

TEST(Loop, InALoopKnowsBothVariables) {
  const CheckedTask task = CheckTask(
      TaskText("memory touched: bool[link] = false",
               "for l in body, head { for k in {body, head} - l { touched[k] = contact[l] } }"));
  const auto& inner = std::get<CheckedFor>(LoopOf(task).passes.at(0).body.at(0).node);
  ASSERT_EQ(inner.passes.size(), 1u);
  EXPECT_EQ(inner.passes[0].value, "head");
}

TEST(Loop, SharesEndsAndRequirementsAmongItsPasses) {
  const CheckedTask task =
      CheckTask(TaskText("",
                         "for l in hands {\n  require not contact[l]\n"
                         "  if contact[l] { end_episode failure \"touches\" }\n}"));
  EXPECT_EQ(task.ends.size(), 1u);
  ASSERT_EQ(task.requirements.size(), 1u);
  EXPECT_EQ(task.requirements[0].reason, "not contact[l]");
}

TEST(Once, HasHiddenMemoryOfItsScope) {
  const CheckedTask task = CheckTask(TaskText("memory n: int = 0",
                                              "for l in feet { once per action if contact[l] { n "
                                              "+= 1 } }\nonce per run if n > 3 { n = 0 }"));
  ASSERT_EQ(task.memory.size(), 4u);
  EXPECT_EQ(task.memory[1].name, "once#1");
  EXPECT_EQ(task.memory[2].name, "once#2");
  EXPECT_EQ(task.memory[2].scope, MemoryScope::kPerAction);
  EXPECT_EQ(task.memory[3].scope, MemoryScope::kPerRun);
  EXPECT_TRUE(task.memory[0].is_declared);
  EXPECT_FALSE(task.memory[3].is_declared);
}

TEST(Once, IsAnIfThatRemembers) {
  const CheckedTask task =
      CheckTask(TaskText("", "once per action if contact[head] { reward fall = -1 }"));
  const auto& branch = std::get<CheckedIf>(BlockOf(task).at(0).node).branches.at(0);
  const auto& both = std::get<CheckedBinary>(branch.condition.node);
  EXPECT_EQ(both.op, BinaryOperator::kAnd);
  EXPECT_EQ(std::get<CheckedUnary>(both.left->node).op, UnaryOperator::kNot);
  ASSERT_EQ(branch.body.size(), 2u);
  EXPECT_EQ(std::get<CheckedAssign>(branch.body[0].node).memory, 0u);
  EXPECT_TRUE(std::holds_alternative<CheckedReward>(branch.body[1].node));
}

TEST(Log, HasTheUnitAndReductionOfItsStatements) {
  const CheckedTask task = CheckTask(
      TaskText("", "/// How fast.\nlog max speed = 0\nlog max speed = norm(base.velocity)"));
  ASSERT_EQ(task.logs.size(), 1u);
  EXPECT_EQ(task.logs[0].doc, "How fast.");
  EXPECT_EQ(ToString(task.logs[0].unit), "m/s");
  EXPECT_EQ(task.logs[0].reduction, Reduction::kMax);
}

}  // namespace
}  // namespace compiler
