#include "compiler/spec/spec.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "compiler/analyze/analyze.h"
#include "compiler/check/builtins.h"
#include "compiler/check/draws.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/unit.h"
#include "compiler/source/file_reader.h"
#include "compiler/spec/manual.h"
#include "compiler/syntax/words.h"
#include "plugins/robot/sensors.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

SpecSources Sources() {
  SpecSources sources{golden::ReadFile(SOURCE_DIR "/grammar/Task.g4"),
                      golden::ReadFile(SOURCE_DIR "/docs/language.md"),
                      {}};
  std::istringstream names(golden::ReadFile(SOURCE_DIR "/compiler/spec/examples.txt"));
  for (std::string name; std::getline(names, name);)
    sources.examples.push_back({name, golden::ReadFile(SOURCE_DIR "/" + name)});
  return sources;
}

robot::RobotDescription Robot(const std::string& name) {
  return robot::ReadRobot(SOURCE_DIR "/plugins/" + name + "/robot.toml");
}

std::vector<std::string> RobotNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/plugins"))
    if (std::filesystem::exists(entry.path() / "robot.toml"))
      names.push_back(entry.path().filename());
  return names;
}

// Not matched as a whole: a failure would print all of the page.
bool Has(const std::string& page, const std::string& part) {
  return page.find(part) != std::string::npos;
}

TEST(Spec, NamesAllThatARobotHas) {
  for (const std::string& name : RobotNames()) {
    const robot::RobotDescription robot = Robot(name);
    const std::string page = ToMarkdown(SpecOf(robot, Sources()));
    for (const auto& sensor : robot::SensorsOf(robot)) {
      EXPECT_TRUE(Has(page, fmt::format("| `{}` | `{}", sensor.name, sensor.type.substr(0, 3))));
      EXPECT_TRUE(Has(page, std::string(sensor.doc))) << sensor.name;
    }
    for (const auto& constant : robot::Constants())
      EXPECT_TRUE(Has(page, fmt::format("| `{}` |", constant.name)));
    for (const auto& link : robot.links) EXPECT_TRUE(Has(page, "`" + link.name + "`")) << name;
    for (const auto& site : robot.sites) EXPECT_TRUE(Has(page, "`" + site.name + "`")) << name;
    for (const auto& joint : robot.joints) EXPECT_TRUE(Has(page, "`" + joint.name + "`")) << name;
    for (const auto& set : robot.link_groups) EXPECT_TRUE(Has(page, "The set `" + set.name + "`"));
    for (const auto& set : robot.joint_groups) EXPECT_TRUE(Has(page, "The set `" + set.name + "`"));
    for (const auto& set : robot.site_groups) EXPECT_TRUE(Has(page, "The set `" + set.name + "`"));
    for (const auto& pose : robot.poses) EXPECT_TRUE(Has(page, "`" + pose.name + "`")) << name;
  }
}

TEST(Spec, NamesAllThatTheLanguageHas) {
  const Spec spec = SpecOf(std::nullopt, Sources());
  const std::string page = ToMarkdown(spec);
  std::set<std::string> functions;
  for (const SpecFunction& function : spec.functions) {
    functions.insert(function.name);
    EXPECT_THAT(function.doc, Not(IsEmpty())) << function.name;
    EXPECT_THAT(function.usages, Not(IsEmpty())) << function.name;
    for (const std::string& usage : function.usages) {
      EXPECT_THAT(usage, testing::MatchesRegex("[a-z0-9_]+\\(.*\\)"));
    }
    EXPECT_TRUE(Has(page, "`" + function.name + "(")) << function.name;
  }
  for (const std::string& name : BuiltinNames()) EXPECT_EQ(functions.count(name), 1u) << name;
  for (const auto& function : kTimeFunctions)
    EXPECT_EQ(functions.count(std::string(function.name)), 1u);
  for (const auto& draw : kDraws) EXPECT_EQ(functions.count(std::string(draw.name)), 1u);
  for (const std::string& unit : KnownUnits()) EXPECT_TRUE(Has(page, "`" + unit + "`")) << unit;
  for (const auto& event : kEventNames)
    EXPECT_TRUE(Has(page, "- `" + std::string(event.text) + "`: ")) << event.text;
}

TEST(Spec, SaysWhatUnitsAre) {
  const Spec spec = SpecOf(std::nullopt, Sources());
  const auto minute = std::ranges::find(spec.units, "min", &SpecUnit::name);
  ASSERT_NE(minute, spec.units.end());
  EXPECT_EQ(minute->factor, 60);
  EXPECT_EQ(minute->si, "s");
}

// What is imported can only be of a library: an example is one file.
Analysis AnalyzeText(const std::string& text) {
  const auto read = [&](const std::filesystem::path& file) {
    return file == "main.task" ? std::optional(text) : ReadFromDisk(file);
  };
  return Analyze("main.task", read, SOURCE_DIR "/plugins");
}

TEST(Spec, HasTenExamplesWithoutAMistakeThoseOfTheRobotFirst) {
  for (const std::string& name : RobotNames()) {
    const Spec spec = SpecOf(Robot(name), Sources());
    ASSERT_EQ(spec.examples.size(), kSpecExamples);
    EXPECT_EQ(spec.examples.front().robot, name);
    for (const SpecExample& example : spec.examples) {
      const Analysis analysis = AnalyzeText(example.text);
      EXPECT_TRUE(analysis.diagnostics.list().empty())
          << example.name << Render(analysis.sources, analysis.diagnostics, false);
    }
  }
}

TEST(Spec, IsForTasksOfNoRobotToo) {
  const Spec spec = SpecOf(std::nullopt, Sources());
  EXPECT_EQ(spec.examples.front().robot, "");
  const std::string page = ToMarkdown(spec);
  EXPECT_TRUE(page.starts_with("# How to write a task\n"));
  EXPECT_TRUE(Has(page, "The task declares its own"));
  EXPECT_TRUE(ToJson(spec)["robot"].is_null());
}

// So that it can be given to a language model with every request.
TEST(Spec, IsOfTheSizeOfAChapter) {
  EXPECT_LT(ToMarkdown(SpecOf(Robot("humanoid"), Sources())).size(), 100'000u);
}

TEST(Spec, IsDataToo) {
  const Json json = ToJson(SpecOf(Robot("humanoid"), Sources()));
  EXPECT_EQ(json["robot"]["name"], "humanoid");
  EXPECT_EQ(json["sensors"].size(), robot::Sensors().size() + robot::Constants().size());
  EXPECT_EQ(json["parts"][0]["type"], "link");
  EXPECT_EQ(json["parts"][0]["sets"]["feet"].size(), 2u);
  EXPECT_EQ(json["sensors"][0]["name"], "time");
  EXPECT_EQ(json["grammar"][0]["rule"], "file");
  EXPECT_EQ(json["examples"].size(), kSpecExamples);
}

TEST(Manual, IsReadByItsHeadingsAndTables) {
  constexpr const char* kManual =
      "# A\n\n## One\n\ntext\n\n### Two\n\n| f | |\n|---|---|\n| `a(x)` `b(x)` | does `this` |\n"
      "| `a(x, y)` | and that |\n";
  EXPECT_EQ(SectionOf(kManual, "One"), "text");
  EXPECT_EQ(SectionOf(kManual, "Three"), "");
  EXPECT_EQ(MeaningOf(kManual, "a"), "does this; and that");
  EXPECT_EQ(MeaningOf(kManual, "c"), "");
}

}  // namespace
}  // namespace compiler
