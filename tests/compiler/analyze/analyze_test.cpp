#include "compiler/analyze/analyze.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

#include "tests/compiler/compose/file_set.h"

namespace compiler {
namespace {

constexpr const char* kRobots = SOURCE_DIR "/plugins";

// A reader that knows one text only.
FileReader Only(const std::string& text) {
  return [text](const std::filesystem::path&) { return text; };
}

TEST(Analyze, GivesATaskWithItsRobot) {
  Analysis analysis =
      Analyze("t.task", Only("task t for humanoid\nmetric x = base.position.x\n"), kRobots);
  ASSERT_TRUE(analysis.task);
  EXPECT_EQ(analysis.task->name, "t");
  ASSERT_TRUE(analysis.robot);
  EXPECT_EQ(analysis.robot->name, "humanoid");
  EXPECT_TRUE(analysis.tree);
}

TEST(Analyze, KeepsTheTreeAndTheRobotOfAWrongTask) {
  Analysis analysis = Analyze("t.task", Only("task t for humanoid\nmetric x = nothing\n"), kRobots);
  EXPECT_FALSE(analysis.task);
  EXPECT_TRUE(analysis.tree);
  EXPECT_TRUE(analysis.robot);
  EXPECT_TRUE(analysis.diagnostics.has_errors());
}

TEST(Analyze, NamesARobotThatIsNowhere) {
  Analysis analysis = Analyze("t.task", Only("task t for nobody\n"), kRobots);
  EXPECT_FALSE(analysis.task);
  EXPECT_FALSE(analysis.robot);
  ASSERT_EQ(analysis.diagnostics.list().size(), 1u);
  EXPECT_EQ(analysis.diagnostics.list()[0].code, code::kUnknownRobot);
}

TEST(Analyze, KnowsWhatEveryRobotHas) {
  Analysis analysis =
      Analyze("t.task",
              Only("task t for nobody\nstart standing\nmemory touched: bool[link] = false\n"
                   "on end_of_time_step {\n"
                   "  if any(contact[head]) or any(touched[feet]) { reward a = 1 }\n"
                   "  for l in links - feet { reward b = -1 }\n"
                   "  reward rate c = norm(joint.angle) + base.velocity.x + 1\n}\n"),
              kRobots);
  ASSERT_EQ(analysis.diagnostics.list().size(), 1u);
  EXPECT_EQ(analysis.diagnostics.list()[0].code, code::kUnknownRobot);
  analysis = Analyze("t.task",
                     Only("task t for nobody\n"
                          "on end_of_time_step { reward rate c = base.velocity.x + 1 }\n"),
                     kRobots);
  ASSERT_EQ(analysis.diagnostics.list().size(), 2u);
  EXPECT_EQ(analysis.diagnostics.list()[1].code, code::kUnitMismatch);
}

TEST(Analyze, NamesTheEncodingOfAFile) {
  Analysis analysis = Analyze("t.task", Only(std::string("\xFF\xFEt\0a\0s\0k\0", 10)), kRobots);
  ASSERT_EQ(analysis.diagnostics.list().size(), 1u);
  EXPECT_EQ(analysis.diagnostics.list()[0].message, "the file is in UTF-16, not in UTF-8");
  analysis = Analyze("t.task", Only(std::string("t\0a\0s\0k\0 \0t\0", 12)), kRobots);
  ASSERT_EQ(analysis.diagnostics.list().size(), 1u);
}

TEST(Analyze, KnowsWhatABrokenTextHasLost) {
  Analysis analysis = Analyze("t.task", Only("task\n"), kRobots);
  ASSERT_TRUE(analysis.tree);
  EXPECT_TRUE(analysis.tree->lost.has_header);
  EXPECT_TRUE(analysis.diagnostics.has_errors());
}

TEST(Analyze, SaysOnceWhatIsWrongWithWhatReplacesSeveralStatements) {
  const FileReader reader = [](const std::filesystem::path& file) -> std::string {
    if (file.filename() != "base.task")
      return "task t extends \"base.task\"\noverride reward fall = -cost\n";
    return "task base for humanoid\n"
           "on end_of_time_step {\n  if any(contact) { reward fall = -4 }\n  reward fall = -2\n}\n";
  };
  const Analysis analysis = Analyze("t.task", reader, kRobots);
  EXPECT_FALSE(analysis.task);
  ASSERT_EQ(analysis.diagnostics.list().size(), 1u);
  EXPECT_EQ(analysis.diagnostics.list()[0].message, "there is nothing called `cost`");
}

TEST(Analyze, WarnsOfTheOwnFileOnly) {
  const std::map<std::string, std::string> files = {
      {"library.task", "fn unused(x: real) -> real = 1\n"},
      {"base.task",
       "task base for humanoid\nparam idle: real = 1\n"
       "on end_of_time_step { if time > 1 s { truncate_episode \"over\" } }\n"},
      {"t.task", "task t extends \"base.task\"\nimport \"library.task\"\nparam own: real = 1\n"}};
  const FileReader reader = [&](const std::filesystem::path& file) -> std::optional<std::string> {
    const auto found = files.find(file.filename().string());
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  const Analysis analysis = Analyze("t.task", reader, kRobots);
  ASSERT_EQ(analysis.diagnostics.list().size(), 1u);
  EXPECT_EQ(analysis.diagnostics.list()[0].message, "the param `own` is never used");
}

TEST(Analyze, SaysWhyAFileCannotBeRead) {
  try {
    Analyze("/absent/t.task", ReadFromDisk, kRobots);
    FAIL() << "read what is not there";
  } catch (const CallError& error) {
    EXPECT_STREQ(error.what(), "cannot read `/absent/t.task`: No such file or directory");
  }
}

const char* const kHills = "[ground]\nkind = \"heightmap\"\nfile = \"hills.csv\"\nsize = [4, 4]\n";
const char* const kBall =
    "[[things]]\nname = \"ball\"\nshape = \"sphere\"\nradius = 0.05\nmass = 0.05\nposition = [2, "
    "1]\n";

TEST(Analyze, KnowsWhatIsInTheWorldThatATaskNames) {
  const Analysis analysis =
      Analyze("main.task",
              ReaderOf({{"main.task",
                         "task kick for humanoid in \"worlds/yard.toml\"\n"
                         "observe ball.velocity\n"
                         "on end_of_time_step {\n"
                         "  if any(contact_with.ball[feet]) { reward a = ball.position.x / 1 m }\n"
                         "  if time > 1 s { truncate_episode \"late\" }\n}\n"},
                        {"worlds/yard.toml", std::string(kHills) + kBall},
                        {"worlds/hills.csv", "0,0\n0,1\n"}}),
              kRobots);
  ASSERT_TRUE(analysis.task) << Render(analysis.sources, analysis.diagnostics, false);
  ASSERT_TRUE(analysis.world);
  EXPECT_EQ(analysis.world->things.at(0).name, "ball");
  // All that the world is made of is part of the task, for its hash and for whoever runs it.
  ASSERT_EQ(analysis.sources.files().size(), 3u);
  EXPECT_EQ(analysis.sources.files()[1].path(), "worlds/yard.toml");
  EXPECT_EQ(analysis.sources.files()[2].path(), "worlds/hills.csv");
  for (const CheckedSensor& sensor : analysis.task->sensors) {
    if (sensor.name == "ball.position") {
      EXPECT_EQ(sensor.at_rest.size(), 3u);
    }
    if (sensor.name.starts_with("ball")) {
      EXPECT_FALSE(sensor.is_onboard);
    }
  }
}

TEST(Analyze, PutsATaskIntoTheWorldOfItsBaseUnlessItNamesItsOwn) {
  const auto things = [](const std::string& header) {
    const Analysis analysis =
        Analyze("main.task",
                ReaderOf({{"main.task", header + "\nmetric a = base.position.x\n"},
                          {"lib/base.task", "task base for humanoid in \"yard.toml\"\n"},
                          {"lib/yard.toml", kBall},
                          {"empty.toml", ""}}),
                kRobots);
    EXPECT_TRUE(analysis.task) << Render(analysis.sources, analysis.diagnostics, false);
    return analysis.world ? analysis.world->things.size() : 99;
  };
  EXPECT_EQ(things("task t extends \"lib/base.task\""), 1u);
  EXPECT_EQ(things("task t extends \"lib/base.task\" in \"empty.toml\""), 0u);
}

}  // namespace
}  // namespace compiler
