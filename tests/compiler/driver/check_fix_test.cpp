#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Json = nlohmann::json;

constexpr const char* kSlippedTask = R"(task slips for humanoid
on end_of_time_step {
  reward rate up = base.postion.z / 1 m;
  if tme > 2 s { truncate_episode "time is up" }
}
)";
constexpr const char* kMended = R"(task slips for humanoid
on end_of_time_step {
  reward rate up = base.position.z / 1 m
  if time > 2 s { truncate_episode "time is up" }
}
)";

TEST(CheckFix, MendsAndSaysWhatItHasChanged) {
  TaskcProcess taskc;
  taskc.Write("slips.task", kSlippedTask);
  const Outcome outcome = taskc.Run("check --fix slips.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("slips.task:3:40: removed `;` (E"),
                                 HasSubstr("slips.task:4:6: `tme` is now `time` (E0201)\n"),
                                 HasSubstr("slips.task: ok (2 sensors, 1 term, 1 end)\n")));
  EXPECT_EQ(ReadWholeFile(taskc.path("slips.task")), kMended);
}

TEST(CheckFix, LeavesAFileAsItIsWhereNothingIsToBeDone) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  const auto before = std::filesystem::last_write_time(taskc.path("good.task"));
  EXPECT_EQ(taskc.Run("check --fix good.task").out, taskc.Run("check good.task").out);
  EXPECT_EQ(std::filesystem::last_write_time(taskc.path("good.task")), before);
}

TEST(CheckFix, ReportsWhatIsLeft) {
  TaskcProcess taskc;
  taskc.Write("slips.task", std::string(kSlippedTask) + "metric far = nowhere_at_all\n");
  const Outcome outcome = taskc.Run("check --fix --json slips.task");
  EXPECT_EQ(outcome.status, 1);
  const Json report = Json::parse(outcome.out);
  EXPECT_EQ(report["errors"], 1);
  const Json& fixed = report["tasks"][0]["fixed"];
  ASSERT_EQ(fixed.size(), 3u);
  EXPECT_EQ(fixed[0]["file"], "slips.task");
  EXPECT_EQ(ReadWholeFile(taskc.path("slips.task")),
            std::string(kMended) + "metric far = nowhere_at_all\n");
}

TEST(CheckFix, KeepsPermissionsAndLinks) {
  TaskcProcess taskc;
  taskc.Write("slips.task", kSlippedTask);
  ASSERT_EQ(chmod(taskc.path("slips.task").c_str(), 0640), 0);
  std::filesystem::create_symlink("slips.task", taskc.path("link.task"));
  EXPECT_EQ(taskc.Run("check --fix link.task").status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(taskc.path("link.task")));
  EXPECT_EQ(ReadWholeFile(taskc.path("slips.task")), kMended);
  EXPECT_EQ(std::filesystem::status(taskc.path("slips.task")).permissions(),
            std::filesystem::perms(0640));
}

TEST(CheckFix, MendsImportedFilesButNotLibraries) {
  TaskcProcess taskc;
  constexpr const char* kWrong = "fn twice(x: real) -> real = 2 * X\n";
  constexpr const char* kTask =
      "on end_of_time_step {\n  reward up = twice(1)\n"
      "  if time > 2 s { truncate_episode \"time is up\" }\n}\n";
  taskc.Write("own.task", kWrong);
  std::filesystem::create_directory(taskc.path("libraries"));
  taskc.Write("libraries/theirs.task", kWrong);
  taskc.Write("a.task", std::string("task a for humanoid\nimport \"own.task\"\n") + kTask);
  taskc.Write("b.task", std::string("task b for humanoid\nimport \"theirs\"\n") + kTask);
  EXPECT_EQ(taskc.Run("check --fix a.task").status, 0);
  EXPECT_EQ(ReadWholeFile(taskc.path("own.task")), "fn twice(x: real) -> real = 2 * x\n");
  EXPECT_EQ(taskc.Run("check --fix b.task", "TASKC_LIBRARY_PATH=libraries").status, 1);
  EXPECT_EQ(ReadWholeFile(taskc.path("libraries/theirs.task")), kWrong);
}

// What `--fix` does, done by a program with the bytes that the report names.
TEST(CheckFix, DoesWhatTheReportSays) {
  TaskcProcess taskc;
  taskc.Write("slips.task", kSlippedTask);
  std::string text = kSlippedTask;
  const Json report = Json::parse(taskc.Run("check --json slips.task").out);
  const Json& diagnostics = report["diagnostics"];
  for (auto diagnostic = diagnostics.rbegin(); diagnostic != diagnostics.rend(); ++diagnostic) {
    const Json& fix = diagnostic->at("fixes").at(0);
    const auto begin = fix["offset"].get<size_t>();
    text.replace(begin, fix["end_offset"].get<size_t>() - begin, fix["text"].get<std::string>());
  }
  EXPECT_EQ(text, kMended);
}

}  // namespace
}  // namespace compiler
