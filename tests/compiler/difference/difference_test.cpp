#include "compiler/difference/difference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/golden.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TaskOutline OutlineOfText(const std::string& text) {
  const auto read = [&](const std::filesystem::path& file) {
    return file == "main.task" ? std::optional(text) : ReadFromDisk(file);
  };
  const Analysis analysis = Analyze("main.task", read, SOURCE_DIR "/plugins");
  EXPECT_TRUE(analysis.task) << Render(analysis.sources, analysis.diagnostics, false);
  return OutlineOf(analysis);
}

std::string Difference(const std::string& first, const std::string& second) {
  return ToText(Compare(OutlineOfText(first), OutlineOfText(second)));
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

constexpr const char* kTask = R"(task walking for humanoid
start standing
param penalty: real = 2 in 0 .. 20
goal speed: real [m/s] = uniform(0 m/s, 1 m/s)
observe base.up
observe speed
memory highest: real [m] = 0 m per episode
metric max height = base.position.z
on end_of_time_step {
  highest = max(highest, base.position.z)
  reward rate forward = 10 * base.velocity.x / 1 m
  if any(contact[feet]) and base.up.z < 0.5 {
    reward fall = -penalty
    end_episode failure "falls"
  }
  log max jump = highest
  if time > 20 s { truncate_episode "time is up" }
}
)";

void ExpectChange(const std::string& from, const std::string& to, const std::string& text) {
  EXPECT_EQ(Difference(kTask, Replaced(kTask, from, to)), text);
}

TEST(Difference, IsNoneWhereOnlyTheTextDiffers) {
  EXPECT_EQ(Difference(kTask, kTask), "");
  ExpectChange("task walking", "/// Another name, with a comment.\ntask strolling", "");
  ExpectChange("  reward rate forward = 10 * base.velocity.x / 1 m",
               "  let ahead = base.velocity.x  // as a local value\n\n"
               "  reward rate forward = (10 * ahead) / 1 m",
               "");
  ExpectChange("contact[feet]", "contact[{left_foot, right_foot}]", "");
  ExpectChange("20 s", "20000 ms", "");
  const std::string with_function =
      std::string(kTask) +
      "const ten: real = 10\n"
      "fn forward_of(v: vec3 [m/s], factor: real) -> real [1/s] = factor * v.x / 1 m\n";
  EXPECT_EQ(Difference(kTask, Replaced(with_function, "10 * base.velocity.x / 1 m",
                                       "forward_of(base.velocity, ten)")),
            "");
}

TEST(Difference, IsOfParams) {
  ExpectChange("= 2 in 0 .. 20", "= 3 in 0 .. 20", "param penalty: default: 2 -> 3\n");
  EXPECT_THAT(Difference(kTask, Replaced(kTask, "0 .. 20", "1 .. 30")),
              AllOf(HasSubstr("param penalty: range: 0 .. 20 -> 1 .. 30\n"),
                    HasSubstr("term fall: bounds each time: -20 .. 0 -> -30 .. -1\n")));
}

TEST(Difference, IsOfTerms) {
  EXPECT_EQ(Difference(kTask, Replaced(kTask, "= -penalty", "= -penalty * 1.5")),
            R"(term fall: pays
  - end_of_time_step: if any(contact[feet]) and base.up.z < 0.5: -penalty
  + end_of_time_step: if any(contact[feet]) and base.up.z < 0.5: -penalty * 1.5
term fall: bounds each time: -20 .. 0 -> -30 .. 0
)");
}

TEST(Difference, IsOfEnds) {
  ExpectChange("time > 20 s", "time > 10 s", R"(end truncation "time is up": when
  - end_of_time_step: if time > 20 s: ends
  + end_of_time_step: if time > 10 s: ends
)");
  EXPECT_THAT(Difference(kTask, Replaced(kTask,
                                         "  if time > 20 s { truncate_episode "
                                         "\"time is up\" }\n",
                                         "")),
              HasSubstr("end truncation \"time is up\": removed\n  - when: end_of_time_step"));
}

TEST(Difference, IsOfGoalsObservationsMetricsAndMemory) {
  EXPECT_THAT(
      Difference(kTask, Replaced(kTask, "uniform(0 m/s, 1 m/s)", "uniform(0 m/s, 2 m/s) per 3 s")),
      AllOf(HasSubstr("goal speed: value: uniform(0 m/s, 1 m/s) -> uniform(0 m/s, 2 m/s)"),
            HasSubstr("goal speed: lasts: an episode -> 3 s")));
  EXPECT_THAT(Difference(kTask, Replaced(kTask, "observe base.up\n", "")),
              AllOf(HasSubstr("observation base.up: removed"),
                    HasSubstr("observation speed: elements: 3 .. 3 -> 0 .. 0")));
  ExpectChange("metric max height", "metric min height",
               "metric height: of an episode: max -> min\n");
  ExpectChange("0 m per episode", "0 m per run", "memory highest: per: episode -> run\n");
}

TEST(Difference, IsOfTheStart) {
  ExpectChange("start standing", "start lying", "start: poses: standing -> lying\n");
  EXPECT_THAT(
      Difference(kTask, Replaced(kTask, "start standing",
                                 "start standing { joint.angle += uniform(-0.1 rad, 0.1 rad) }")),
      HasSubstr("start: sets\n  + start: joint.angle += uniform(-0.1 rad, 0.1 rad)\n"));
}

TEST(Difference, TellsARenamedPartFromAnotherOne) {
  ExpectChange("metric max height", "metric max top", "metric height: renamed to top\n");
}

// The term is paid before the memory has grown.
TEST(Difference, IsOfTheOrderOfStatements) {
  EXPECT_THAT(Difference(kTask, Replaced(Replaced(kTask, "  log max jump = highest\n", ""),
                                         "  highest = max",
                                         "  log max jump = highest\n"
                                         "  highest = max")),
              HasSubstr("event end_of_time_step: order"));
}

// A local value is computed where it stands.
TEST(Difference, KnowsWhatALocalValueReads) {
  const std::string early =
      Replaced(Replaced(kTask, "  highest = max", "  let before = highest\n  highest = max"),
               "log max jump = highest", "log max jump = before");
  EXPECT_THAT(Difference(kTask, early), HasSubstr("log jump: value"));
}

TEST(Difference, IsOfPhasesAndFunctionsOfThePast) {
  constexpr const char* kPhases = R"(task two for humanoid
phase up within 2 s else down {
  reward rate high = base.position.z / 1 m
  if held(base.up.z < 0.5, 1 s) { next down }
}
phase down { reward rate low = -base.position.z / 1 m }
on end_of_time_step { if time > 20 s { truncate_episode "time is up" } }
)";
  EXPECT_EQ(Difference(kPhases, Replaced(kPhases, "1 s)", "2 s)")), R"(phases: change
  - end_of_time_step: if phase == up, and held(base.up.z < 0.5, 1 s): to down from phase == up
  + end_of_time_step: if phase == up, and held(base.up.z < 0.5, 2 s): to down from phase == up
)");
  EXPECT_THAT(Difference(kPhases, Replaced(kPhases, "within 2 s", "within 3 s")),
              HasSubstr("phase up: lasts at most: 2 s, then down -> 3 s, then down"));
}

TEST(Difference, IsNoneOfEachTaskToItself) {
  for (const char* folder : {"/tasks", "/examples/tasks"}) {
    for (const auto& file : golden::FilesIn(std::string(SOURCE_DIR) + folder, "", ".task")) {
      const auto outline = [&] {
        const Analysis analysis = Analyze(file, ReadFromDisk, SOURCE_DIR "/plugins");
        return analysis.task ? OutlineOf(analysis) : TaskOutline();
      };
      EXPECT_THAT(Compare(outline(), outline()), IsEmpty()) << file;
    }
  }
}

}  // namespace
}  // namespace compiler
