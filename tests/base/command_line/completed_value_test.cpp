#include "base/command_line/completed_value.h"

#include <gmock/gmock.h>

namespace command_line {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const ValueLists kLists = {
    .words = {{"CODE", {"E1", "E2"}}},
    .names = {{"ROBOT", [](const auto&) { return std::vector<std::string>(); }}}};

TEST(CompletedValue, IsWordsWhereTheHelpShowsThem) {
  EXPECT_THAT(ValueCalled("text|json", kLists).words, ElementsAre("text", "json"));
  EXPECT_THAT(ValueCalled("CODE", kLists).words, ElementsAre("E1", "E2"));
}

TEST(CompletedValue, IsFilesThatEndLikeTheName) {
  EXPECT_THAT(ValueCalled("FILE.stl|FILE.obj", kLists).suffixes, ElementsAre(".stl", ".obj"));
  EXPECT_THAT(ValueCalled("FIRST.task", kLists).suffixes, ElementsAre(".task"));
  EXPECT_THAT(ValueCalled("TASK", kLists).suffixes, ElementsAre(".task"));
  const CompletedValue any = ValueCalled("FILE", kLists);
  EXPECT_TRUE(any.has_files);
  EXPECT_THAT(any.suffixes, IsEmpty());
}

TEST(CompletedValue, IsFolders) {
  const CompletedValue value = ValueCalled("DIR", kLists);
  EXPECT_TRUE(value.has_folders);
  EXPECT_FALSE(value.has_files);
}

TEST(CompletedValue, MayBeANameOrAFile) {
  const CompletedValue value = ValueCalled("ROBOT|FILE.toml", kLists);
  EXPECT_EQ(value.names, "ROBOT");
  EXPECT_THAT(value.suffixes, ElementsAre(".toml"));
  EXPECT_THAT(value.words, IsEmpty());
}

TEST(CompletedValue, IsNothingWhereAnythingMayStand) {
  for (const char* name : {"", "TEXT", "NAME", "INT", "PARAMETER=VALUE", "as NAME"}) {
    const CompletedValue value = ValueCalled(name, kLists);
    EXPECT_FALSE(value.has_files || value.has_folders) << name;
    EXPECT_EQ(value.names, "") << name;
    EXPECT_THAT(value.words, IsEmpty()) << name;
  }
}

}  // namespace
}  // namespace command_line
