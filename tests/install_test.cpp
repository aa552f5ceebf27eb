// The programs where an installation puts them, for somebody who has never seen the source tree.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace {

using runtime::ProgramResult;
using runtime::RunProgram;

constexpr unsigned kNobody = 65534;

std::string Contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class InstallTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
    std::filesystem::create_directory(work_);
    if (is_root_) {
      ASSERT_EQ(chown(work_.c_str(), kNobody, kNobody), 0);
    }
    ASSERT_NO_FATAL_FAILURE(ConfigureLikeTheQuickstart());
    const ProgramResult installed =
        RunProgram({CMAKE, "--install", build_.string(), "--prefix", prefix_.string()});
    ASSERT_EQ(installed.exit_status, 0) << installed.errors;
  }

  // A build tree in which nothing but the target `programs` was built.
  void ConfigureLikeTheQuickstart() const {
    const ProgramResult configured = RunProgram({CMAKE, "-S", SOURCE_DIR, "-B", build_.string(),
                                                 "-G", "Ninja", "-DCMAKE_BUILD_TYPE=" BUILD_TYPE,
                                                 HAS_PAGES ? "-DTASKC_WEB=ON" : "-DTASKC_WEB=OFF"});
    ASSERT_EQ(configured.exit_status, 0) << configured.errors;
    for (const char* part : {"bin/taskc", "bin/trainer", "share/taskc/report", "share/taskc/study",
                             "share/taskc/document", "share/taskc/probe"}) {
      if (!std::filesystem::exists(std::filesystem::path(BUILD_DIR) / part)) continue;
      std::filesystem::create_directories((build_ / part).parent_path());
      std::filesystem::copy(std::filesystem::path(BUILD_DIR) / part, build_ / part,
                            std::filesystem::copy_options::recursive |
                                std::filesystem::copy_options::overwrite_existing);
    }
  }

  // Calls an installed program from the user's own folder, with next to no environment.
  void Call(std::vector<std::string> words) const {
    words.front() = (prefix_ / "bin" / words.front()).string();
    words.insert(words.begin(), {"/usr/bin/env", "-i", "-C", work_.string(), "PATH=/usr/bin:/bin",
                                 "HOME=" + work_.string()});
    if (is_root_) {
      const std::string nobody = std::to_string(kNobody);
      words.insert(words.begin(), {"/usr/bin/setpriv", "--reuid=" + nobody, "--regid=" + nobody,
                                   "--clear-groups"});
    }
    const ProgramResult result = RunProgram(words);
    EXPECT_EQ(result.exit_status, 0) << result.output << result.errors;
    ExpectKnowsNoSources(result.output + result.errors);
  }

  void Write(const std::string& file, const std::string& text) const {
    std::ofstream(work_ / file) << text;
  }

  void ExpectMade(const std::string& file) const {
    ASSERT_TRUE(std::filesystem::exists(work_ / file)) << file;
    ExpectKnowsNoSources(Contents(work_ / file));
  }

 private:
  static void ExpectKnowsNoSources(const std::string& text) {
    EXPECT_EQ(text.find(SOURCE_DIR "/"), std::string::npos);
    EXPECT_EQ(text.find(BUILD_DIR "/"), std::string::npos);
  }

  const bool is_root_ = geteuid() == 0;
  const runtime::TemporaryFolder folder_;
  const std::filesystem::path build_ = folder_.path() / "build";
  const std::filesystem::path prefix_ = folder_.path() / "prefix";
  const std::filesystem::path work_ = folder_.path() / "work";
};

TEST_F(InstallTest, WhatTheQuickstartBuildsIsAllThatAUserNeeds) {
  Call({"taskc", "new", "walking", "--for", "humanoid"});
  Call({"taskc", "check", "walking.task"});
  Call({"taskc", "build", "walking.task", "-o", "walking.so"});
  ExpectMade("walking.so");
  Call({"trainer", "train", "walking.task", "--profile", "fast-tree", "--episodes", "2", "--out",
        "run"});
  Call({"trainer", "show", "run"});
  Call({"taskc", "explain", "E0501"});
  Write("near.task",
        "task near for humanoid\nimport \"std/kernels\"\n"
        "metric near = squared_kernel(norm(base.position), 1 m)\n");
  Call({"taskc", "build", "near.task", "-o", "near.so"});
  if (!HAS_PAGES) return;
  Call({"trainer", "report", "run"});
  ExpectMade("run/report.html");
  Call({"taskc", "doc", "walking.task", "-o", "walking.html"});
  ExpectMade("walking.html");
}

}  // namespace
