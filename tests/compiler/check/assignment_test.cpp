// Assignments, as the checked statements that they become.
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

CheckedAssign CheckAssign(const std::string& declaration, const std::string& statement) {
  CheckedTask task = CheckTask(TaskText(declaration, statement));
  CheckedBlock& body = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)].body;
  EXPECT_EQ(body.size(), 1u);
  return std::move(std::get<CheckedAssign>(body.at(0).node));
}

TEST(Assignment, ConvertsIntsForRealMemory) {
  const CheckedAssign assign = CheckAssign("memory x: real = 0", "x = 2");
  EXPECT_EQ(assign.op, AssignOperator::kSet);
  EXPECT_EQ(ToString(assign.value.type), "real");
  EXPECT_EQ(std::get<Constant>(assign.value.node).value, 2);
}

TEST(Assignment, WithAnOperatorKeepsIt) {
  const CheckedAssign assign = CheckAssign("memory waited: real [s] = 0", "waited += time_step");
  EXPECT_EQ(assign.op, AssignOperator::kAdd);
  EXPECT_TRUE(std::holds_alternative<TimeStep>(assign.value.node));
  EXPECT_EQ(CheckAssign("memory n: int = 0", "n *= 2").op, AssignOperator::kMultiply);
  EXPECT_EQ(CheckAssign("memory x: real [m] = 0", "x /= 2").op, AssignOperator::kDivide);
  EXPECT_EQ(CheckAssign("memory v: vec3 [m] = 0", "v -= base.position").op,
            AssignOperator::kSubtract);
}

TEST(Assignment, OfAScalarToAShapedMemoryIsWrittenOut) {
  const CheckedAssign assign = CheckAssign("memory v: vec3 [m] = 0", "v *= 2");
  EXPECT_EQ(assign.op, AssignOperator::kSet);
  EXPECT_EQ(ToString(assign.value.type), "vec3");
  EXPECT_EQ(ToString(assign.value.unit), "m");
  const auto& product = std::get<CheckedBinary>(assign.value.node);
  EXPECT_EQ(product.op, BinaryOperator::kMultiply);
  EXPECT_TRUE(std::holds_alternative<MemoryRead>(product.left->node));
}

TEST(Assignment, TakesWholeArrays) {
  const CheckedAssign assign =
      CheckAssign("memory touched: bool[link] = false", "touched = contact");
  EXPECT_EQ(ToString(assign.value.type), "bool[link]");
}

}  // namespace
}  // namespace compiler
