#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/runtime/trainer/child_process.h"

namespace {

using runtime::ProgramResult;
using runtime::RunProgram;

const std::filesystem::path kPages = std::filesystem::path(PAGES) / "man1";

// "taskc-build.1.gz" as a reader sees it, with what `man` finds wrong in it.
ProgramResult Shown(const std::string& page) {
  return RunProgram({"/usr/bin/env", "MANWIDTH=80", "LC_ALL=C.UTF-8", "man", "--warnings", "-l",
                     (kPages / page).string()});
}

bool HasMan() { return RunProgram({"/bin/sh", "-c", "command -v man"}).exit_status == 0; }

TEST(ManualPages, AreWithoutWarnings) {
  if (!HasMan()) GTEST_SKIP() << "there is no `man`";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kPages)) {
    const ProgramResult shown = Shown(entry.path().filename().string());
    EXPECT_EQ(shown.exit_status, 0) << entry.path();
    EXPECT_EQ(shown.errors, "") << entry.path();
    EXPECT_THAT(shown.output, testing::HasSubstr("SYNOPSIS")) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 50);
}

TEST(ManualPages, AreThereForEachCommandOfTheHelp) {
  for (const char* line :
       {"taskc", "trainer", "trainer ctl", "trainer ctl module", "trainer robot"}) {
    std::istringstream words(line);
    std::vector<std::string> call;
    for (std::string word; words >> word;) call.push_back(word);
    std::string page = call.front();
    for (size_t i = 1; i < call.size(); ++i) page += "-" + call[i];
    call.front() = std::string(PROGRAMS) + "/" + call.front();
    call.emplace_back("--help");
    std::istringstream help(RunProgram(call).output);
    int count = 0;
    bool is_command = false;
    for (std::string text; std::getline(help, text);) {
      if (!text.starts_with(" ")) is_command = text.starts_with("Subc") || text.starts_with("Comm");
      if (!is_command || !text.starts_with("  ") || text[2] == ' ') continue;
      const std::string name = text.substr(2, text.find(' ', 2) - 2);
      EXPECT_TRUE(std::filesystem::exists(kPages / (page + "-" + name + ".1.gz"))) << page << name;
      ++count;
    }
    EXPECT_GE(count, 2) << line;
  }
}

TEST(ManualPages, ShowOptionsThatCanBeCopied) {
  if (!HasMan()) GTEST_SKIP() << "there is no `man`";
  const std::string shown = Shown("trainer-train.1.gz").output;
  EXPECT_THAT(shown, testing::HasSubstr("--record-every INT"));
  EXPECT_THAT(shown, testing::HasSubstr("trainer-train - Starts one run or many"));
}

}  // namespace
