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
    for (const char* part :
         {"bin/taskc", "bin/trainer", "share/taskc/report", "share/taskc/study",
          "share/taskc/document", "share/taskc/probe", "share/taskc/live", "share/taskc/runs",
          "packaging/man1", "packaging/bash", "packaging/zsh", "packaging/fish", "lib"}) {
      if (!std::filesystem::exists(std::filesystem::path(BUILD_DIR) / part)) continue;
      std::filesystem::create_directories((build_ / part).parent_path());
      std::filesystem::copy(std::filesystem::path(BUILD_DIR) / part, build_ / part,
                            std::filesystem::copy_options::recursive |
                                std::filesystem::copy_options::copy_symlinks |
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

  // Runs any program in the user's folder, which knows where taskc was installed to.
  std::string Run(const std::string& command) const {
    const std::string prefix = prefix_.string();
    const ProgramResult result = RunProgram(
        {"/usr/bin/env", "-i", "-C", work_.string(), "PATH=" + prefix + "/bin:/usr/bin:/bin",
         "HOME=" + work_.string(), "PREFIX=" + prefix,
         "PKG_CONFIG_PATH=" + LibFolder() + "/pkgconfig", "LD_LIBRARY_PATH=" + LibFolder(),
         "PYTHONPATH=" + prefix + "/share/taskc/python", "/bin/sh", "-ec", command});
    EXPECT_EQ(result.exit_status, 0) << command << "\n" << result.output << result.errors;
    return result.output;
  }

  // Of a file or folder below the installation.
  bool IsInstalled(const std::string& path) const {
    return std::filesystem::exists(prefix_ / path);
  }

  // lib, or lib/x86_64-linux-gnu.
  std::string LibFolder() const { return (prefix_ / LIB_FOLDER).string(); }

  void CopyExample(const std::string& name) const {
    std::filesystem::copy(std::filesystem::path(SOURCE_DIR) / "examples" / name, work_ / name,
                          std::filesystem::copy_options::recursive);
  }

  // As a user builds a project of his own.
  void BuildExample(const std::string& name) const {
    CopyExample(name);
    Run("cmake -S " + name + " -B " + name + "/build -G Ninja -DCMAKE_PREFIX_PATH=\"$PREFIX\"");
    Run("cmake --build " + name + "/build");
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

TEST_F(InstallTest, ShellsAndManFindWhatTheyLookFor) {
  for (const char* file :
       {"share/man/man1/taskc-build.1.gz", "share/man/man1/trainer-ctl-swap.1.gz",
        "share/bash-completion/completions/trainer", "share/fish/vendor_completions.d/taskc.fish",
        "share/zsh/site-functions/_trainer", "share/doc/taskc/docs/hosts.md",
        "share/doc/taskc/tasks/crawling.task", "share/doc/taskc/copyright"}) {
    EXPECT_TRUE(IsInstalled(file)) << file;
  }
}

constexpr const char* kBalance =
    "1: 0.477668\n2: 0.162668\n3: -0.439195\n4: -0.568821, falls over\n"
    "upright: 1.382320\nnear: -0.750000\nheld: -1.000000\n";

// Of four steps of half a second, with the pole at 0.3, 0.6, 0.9 and 1.2 rad; from the second on
// the wish is 0.5 m away, from the third on something holds the pole.
TEST_F(InstallTest, AProgramInCFindsItByCMakeOrPkgConfig) {
  BuildExample("embed_c");
  EXPECT_EQ(Run("embed_c/build/balance embed_c/build/balance.so"), kBalance);
  Run("cd embed_c && cc -std=c11 -Wall -Wextra -pedantic -Werror balance.c -o balance "
      "$(pkg-config --cflags --libs taskc)");
  Run("cd embed_c && \"$(pkg-config --variable=taskc taskc)\" build balance.task -o balance.so");
  EXPECT_EQ(Run("embed_c/balance embed_c/balance.so"), kBalance);
}

TEST_F(InstallTest, AProgramInCppIsBuiltAgainWithItsTaskWhenAnImportChanges) {
  BuildExample("embed_cpp");
  const std::string judged = Run("embed_cpp/build/judge embed_cpp/build/docking.so");
  EXPECT_THAT(judged, testing::HasSubstr("episode 1: return 24.494 in 285 steps"));
  EXPECT_THAT(judged, testing::HasSubstr("episode 2: return 15.337 in 1000 steps"));
  EXPECT_THAT(judged, testing::HasSubstr("in 1 steps, 5.65 m from the dock: lost"));
  EXPECT_THAT(Run("cmake --build embed_cpp/build"), testing::HasSubstr("no work to do"));
  Write("embed_cpp/nearness.task",
        "fn nearness(distance: real [m], reach: real [m]) -> real = 0 * distance / reach\n");
  Run("cmake --build embed_cpp/build");
  EXPECT_THAT(Run("embed_cpp/build/judge embed_cpp/build/docking.so"),
              testing::HasSubstr("episode 1: return 19.86"));
}

#if HAS_MUJOCO
TEST_F(InstallTest, ATaskPaysForARobotThatMujocoSimulates) {
  CopyExample("tasks");
  BuildExample("mujoco_host");
  EXPECT_EQ(
      Run("mujoco_host/build/swing_up mujoco_host/build/swing_up.so mujoco_host/cart_pole.xml"),
      "paid 2.481 in 10.01 s\n");
}
#endif

TEST_F(InstallTest, PythonFindsWhatItWasInstalledWith) {
  const std::string python = PYTHON;
  if (python.empty()) GTEST_SKIP() << "there is no Python with NumPy";
  CopyExample("embed_cpp");
  CopyExample("python");
  Run("mkdir examples && mv embed_cpp python examples/");
  EXPECT_THAT(Run(python + " examples/python/judge.py picture.png"),
              testing::HasSubstr("damping 3: return 24.494, docked after 5.7 s"));
  EXPECT_THAT(Run(python + " examples/python/crawl.py 1 picture.png"),
              testing::HasSubstr("generation 0: mean return"));
}

}  // namespace
