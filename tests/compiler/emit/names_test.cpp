#include <gtest/gtest.h>

#include "compiler/emit/unique_names.h"

namespace compiler {
namespace {

TEST(UniqueNames, KeepsANameThatIsFree) {
  UniqueNames names;
  EXPECT_EQ(names.Add("fall_penalty"), "fall_penalty");
  EXPECT_EQ(names.Add("x1"), "x1");
}

TEST(UniqueNames, JoinsTheWordsOfADottedName) {
  UniqueNames names;
  EXPECT_EQ(names.Add("base.angular_velocity"), "base_angular_velocity");
}

TEST(UniqueNames, NumbersNamesThatWouldBeEqual) {
  UniqueNames names;
  EXPECT_EQ(names.Add("base_velocity"), "base_velocity");
  EXPECT_EQ(names.Add("base.velocity"), "base_velocity_2");
  EXPECT_EQ(names.Add("base_velocity"), "base_velocity_3");
}

TEST(UniqueNames, NeverGivesAKeywordNorANameOfTheEmittedText) {
  UniqueNames names;
  EXPECT_EQ(names.Add("new"), "new_");
  EXPECT_EQ(names.Add("xor"), "xor_");
  EXPECT_EQ(names.Add("new"), "new_2");
  EXPECT_EQ(names.Add("frame"), "frame_");
  EXPECT_EQ(names.Add("TASKC_BOOL"), "TASKC_BOOL_");
}

TEST(UniqueNames, LeavesTheNamesOfTheCompilerAlone) {
  UniqueNames names;
  EXPECT_EQ(names.Add("_Bool"), "x_Bool");
  EXPECT_EQ(names.Add("__LINE__"), "x_LINE_");
  EXPECT_EQ(names.Add("a__b"), "a_b");
}

TEST(UniqueNames, AnInnerScopeHidesNothing) {
  UniqueNames outer;
  outer.Reserve("Min");
  UniqueNames inner(&outer);
  EXPECT_EQ(inner.Add("Min"), "Min_2");
  EXPECT_EQ(inner.Add("x"), "x");
  EXPECT_EQ(outer.Add("x"), "x");
}

TEST(UniqueNames, ABlockGivesItsNamesBack) {
  UniqueNames names;
  names.Add("x");
  const size_t block = names.Mark();
  EXPECT_EQ(names.Add("x"), "x_2");
  EXPECT_EQ(names.Add("y"), "y");
  names.GiveBackTo(block);
  EXPECT_EQ(names.Add("y"), "y");
  EXPECT_EQ(names.Add("x"), "x_2");
  EXPECT_EQ(names.Add("x"), "x_3");
}

}  // namespace
}  // namespace compiler
