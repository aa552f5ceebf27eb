#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <taskc/plugin.h>

#include <chrono>

#include "compiler/toolchain/file_io.h"
#include "tests/compiler/driver/taskc_process.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// The task's name as its plugin says it.
std::string NameIn(const std::filesystem::path& plugin) {
  void* library = dlopen(plugin.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return dlerror();
  auto entry = reinterpret_cast<taskc_plugin_entry>(dlsym(library, TASKC_PLUGIN_ENTRY));
  std::string name = entry()->name;
  dlclose(library);
  return name;
}

std::string WithoutEnd(std::string line) {
  if (line.ends_with('\n')) line.pop_back();
  return line;
}

TEST(Build, PrintsWhereThePluginIs) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("build good.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.error, "");
  std::filesystem::path plugin = WithoutEnd(outcome.out);
  EXPECT_EQ(plugin.parent_path(), taskc.path("cache"));
  EXPECT_EQ(NameIn(plugin), "good");
  EXPECT_EQ(taskc.Run("build good.task").out, outcome.out);
}

TEST(Build, WritesThePluginWhereItIsTold) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("build good.task -o out.so --cache elsewhere");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(NameIn(taskc.path("out.so")), "good");
  EXPECT_TRUE(std::filesystem::exists(taskc.path("elsewhere")));
  EXPECT_FALSE(std::filesystem::exists(taskc.path("cache")));
}

TEST(Build, ListsTheFilesThatAPluginIsMadeFrom) {
  TaskcProcess taskc;
  taskc.Write("a part.task", "fn twice(x: real) -> real = 2 * x\n");
  taskc.Write("whole.task",
              "task whole for humanoid\nimport \"a part.task\"\n"
              "metric high = twice(base.up.z)\n");
  EXPECT_EQ(taskc.Run("build whole.task -o out.so --depfile out.d").status, 0);
  const std::string rule = ReadWholeFile(taskc.path("out.d").string()).value();
  EXPECT_TRUE(rule.starts_with("out.so: \\\n  " + taskc.path("whole.task").string())) << rule;
  EXPECT_NE(rule.find("/a\\ part.task"), std::string::npos) << rule;
  EXPECT_NE(rule.find("/humanoid/robot.toml"), std::string::npos) << rule;
}

TEST(Build, AnUnnamedPluginHasNoRule) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  const Outcome outcome = taskc.Run("build good.task --depfile out.d");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.error.find("add `-o FILE.so`"), std::string::npos) << outcome.error;
}

// A cache may be any folder.
TEST(Build, RemovesNoFileOfOthersFromItsCache) {
  namespace fs = std::filesystem;
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  taskc.Write("project/libfoo.so.1.2", "x");
  taskc.Write("project/building-site/plan.txt", "x");
  taskc.Write("project/building-blocks/plan.txt", "x");
  fs::create_symlink(".", taskc.path("project/a"));
  fs::create_symlink(".", taskc.path("project/b"));
  for (const char* name : {"libfoo.so.1.2", "building-site/plan.txt", "building-site",
                           "building-blocks/plan.txt", "building-blocks"}) {
    fs::last_write_time(taskc.path("project") / name,
                        fs::file_time_type::clock::now() - std::chrono::hours(24));
  }
  EXPECT_EQ(taskc.Run("build good.task --cache project").status, 0);
  EXPECT_TRUE(fs::exists(taskc.path("project/libfoo.so.1.2")));
  EXPECT_TRUE(fs::exists(taskc.path("project/building-site/plan.txt")));
  EXPECT_TRUE(fs::exists(taskc.path("project/building-blocks/plan.txt")));
  EXPECT_TRUE(fs::is_symlink(taskc.path("project/a")));
}

// Nobody writes into these pipes: whoever opens one as a file waits forever.
TEST(Build, NoVerbWaitsForANamedPipe) {
  TaskcProcess taskc;
  ASSERT_EQ(mkfifo(taskc.path("pipe.task").c_str(), 0600), 0);
  taskc.Write("imports.task", std::string(kGoodTask) + "import \"pipe.task\"\n");
  taskc.Write("extends.task", "task b extends \"pipe.task\"\n");
  taskc.Write("reads.task", std::string(kGoodTask) + "table t: real = \"pipe.task\"\n");
  for (const std::string verb : {"build", "check", "test", "emit", "doc", "fmt"}) {
    const Outcome outcome = taskc.Run(verb + " pipe.task");
    EXPECT_EQ(outcome.status, 2) << verb;
    EXPECT_THAT(outcome.error,
                HasSubstr("cannot read `pipe.task`: it is a named pipe; name a regular file"));
    if (verb == "fmt") continue;
    for (const char* file : {" imports.task", " extends.task", " reads.task"}) {
      const Outcome importing = taskc.Run(verb + file);
      EXPECT_EQ(importing.status, 1) << verb << file;
      EXPECT_THAT(importing.error, AllOf(HasSubstr("error[E0630]: `pipe.task` cannot be read"),
                                         HasSubstr("it is a named pipe; name a regular file")));
    }
  }
  std::filesystem::create_directories(taskc.path("robots/humanoid"));
  ASSERT_EQ(mkfifo(taskc.path("robots/humanoid/robot.toml").c_str(), 0600), 0);
  taskc.Write("good.task", kGoodTask);
  const Outcome outcome = taskc.Run("check good.task --robots robots");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("it is a named pipe"));
}

TEST(Build, BuildsThePapersTasks) {
  TaskcProcess taskc;
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
    Outcome outcome = taskc.Run("build '" + file.string() + "'");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(NameIn(WithoutEnd(outcome.out)), file.stem());
  }
}

TEST(Build, MakesNothingOfAWrongTask) {
  TaskcProcess taskc;
  taskc.Write("bad.task", "task bad\nmetric x = nothing\n");
  Outcome outcome = taskc.Run("build bad.task -o bad.so");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_FALSE(std::filesystem::exists(taskc.path("bad.so")));
  EXPECT_FALSE(std::filesystem::exists(taskc.path("cache")));
}

TEST(Build, SaysWhyItCannotWrite) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("build good.task -o absent/out.so");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("`absent/out.so`"), HasSubstr("No such file")));
  outcome = taskc.Run("build good.task --cache good.task/cache");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("good.task/cache"), HasSubstr("TASKC_CACHE")));
}

TEST(Build, SaysThatThereIsNoCppCompiler) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("build good.task", "PATH=/nowhere");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("no C++ compiler found"));
}

// A C++ compiler that refuses everything stands for a mistake in the emitted text.
TEST(Build, ReportsARefusedTextAsOurMistake) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  taskc.Write("refuse", "#!/bin/sh\necho 'error: gibberish'\nexit 1\n");
  std::filesystem::permissions(taskc.path("refuse"), std::filesystem::perms::owner_all);
  Outcome outcome = taskc.Run("build good.task", "CXX='" + taskc.path("refuse").string() + "'");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("internal error"), HasSubstr("please report"),
                                   Not(HasSubstr("gibberish"))));
  size_t begin = outcome.error.find("folder ") + 7;
  std::filesystem::path folder = WithoutEnd(outcome.error.substr(begin));
  EXPECT_EQ(ReadWholeFile(folder / "good.task"), kGoodTask);
  EXPECT_EQ(ReadWholeFile(folder / "compiler-output.txt"), "error: gibberish\n");
  EXPECT_THAT(ReadWholeFile(folder / "plugin.cpp").value(), HasSubstr("taskc_plugin_get"));
}

}  // namespace
}  // namespace compiler
