#include "compiler/toolchain/build_plugin.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/toolchain/file_io.h"
#include "compiler/toolchain/internal_error.h"
#include "compiler/toolchain/plugin_cache.h"
#include "tests/compiler/temporary_folder.h"
#include "tests/scoped_environment.h"

namespace compiler {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

std::string CppThatAnswers(int answer) {
  return "#include <taskc/plugin.h>\n"
         "extern \"C\" __attribute__((visibility(\"default\"))) taskc_int32 answer() { return " +
         std::to_string(answer) + "; }\n";
}

int AnswerOf(const fs::path& plugin) {
  void* library = dlopen(plugin.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(dlerror());
  int answer = reinterpret_cast<int (*)()>(dlsym(library, "answer"))();
  dlclose(library);
  return answer;
}

std::vector<std::string> NamesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename());
  }
  return names;
}

class BuildPluginTest : public testing::Test {
 protected:
  BuildResult Build(const std::string& cpp) { return BuildPlugin("task", cpp, cache_.path()); }

  // A C++ compiler that does what the lines of shell say.
  std::string FakeCompiler(const std::string& shell) {
    fs::path program = tools_.path() / "fake-c++";
    WriteWholeFile(program, "#!/bin/sh\n" + shell + "\n");
    fs::permissions(program, fs::perms::owner_all);
    return program.string();
  }

  std::string CallErrorOfBuild() {
    try {
      Build(CppThatAnswers(1));
    } catch (const CallError& error) {
      return error.what();
    }
    return "no error";
  }

  TemporaryFolder cache_;
  TemporaryFolder tools_;
};

TEST_F(BuildPluginTest, RemovesWhatAKilledBuildLeftBehind) {
  const fs::path left = cache_.path() / ("building-task-" + std::string(32, '0') + "-x7Qp2a");
  fs::create_directory(left);
  fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(2));
  Build(CppThatAnswers(1));
  EXPECT_FALSE(fs::exists(left));
}

TEST_F(BuildPluginTest, MakesALibraryThatLoads) {
  BuildResult built = Build(CppThatAnswers(42));
  EXPECT_FALSE(built.from_cache);
  EXPECT_TRUE(built.plugin.is_absolute());
  EXPECT_EQ(AnswerOf(built.plugin), 42);
  EXPECT_THAT(NamesIn(cache_.path()), testing::ElementsAre(built.plugin.filename()));
}

TEST_F(BuildPluginTest, CompilesTheSameTextOnce) {
  BuildResult first = Build(CppThatAnswers(42));
  auto now = fs::file_time_type::clock::now();
  fs::last_write_time(first.plugin, now - std::chrono::hours(1));
  BuildResult second = Build(CppThatAnswers(42));
  EXPECT_TRUE(second.from_cache);
  EXPECT_EQ(second.plugin, first.plugin);
  EXPECT_GE(fs::last_write_time(second.plugin), now);  // its last use
}

TEST_F(BuildPluginTest, GivesAnotherTextAnotherFile) {
  BuildResult one = Build(CppThatAnswers(1));
  BuildResult two = Build(CppThatAnswers(2));
  EXPECT_NE(one.plugin, two.plugin);
  EXPECT_EQ(AnswerOf(one.plugin), 1);
  EXPECT_EQ(AnswerOf(two.plugin), 2);
}

TEST_F(BuildPluginTest, GivesAnotherCompilerAnotherFile) {
  BuildResult usual = Build(CppThatAnswers(1));
  ScopedEnvironment cxx("CXX", FakeCompiler("exec g++ \"$@\""));
  BuildResult other = Build(CppThatAnswers(1));
  EXPECT_FALSE(other.from_cache);
  EXPECT_NE(usual.plugin, other.plugin);
}

TEST_F(BuildPluginTest, BuildsADamagedEntryAnew) {
  fs::path plugin = Build(CppThatAnswers(42)).plugin;
  std::string intact = ReadWholeFile(plugin).value();
  std::string changed = intact;
  changed[changed.size() / 2] ^= 1;
  for (const std::string& damaged : {std::string(), intact.substr(0, intact.size() / 2), changed}) {
    WriteWholeFile(plugin, damaged);
    BuildResult again = Build(CppThatAnswers(42));
    EXPECT_FALSE(again.from_cache);
    EXPECT_EQ(again.plugin, plugin);
    EXPECT_TRUE(IsIntact(plugin));
    EXPECT_EQ(AnswerOf(plugin), 42);
  }
}

TEST_F(BuildPluginTest, CanRunManyTimesAtOnce) {
  std::vector<std::thread> threads;
  std::vector<fs::path> plugins(6);
  for (int i = 0; i < 6; ++i) {
    auto number = static_cast<size_t>(i);
    threads.emplace_back([&, i, number] { plugins[number] = Build(CppThatAnswers(i / 2)).plugin; });
  }
  for (std::thread& thread : threads) thread.join();
  for (size_t i = 0; i < 6; ++i) EXPECT_EQ(AnswerOf(plugins[i]), static_cast<int>(i / 2));
  EXPECT_EQ(NamesIn(cache_.path()).size(), 3u) << "one file for each text and nothing else";
}

TEST_F(BuildPluginTest, PutsNoNameOfAPassingFileIntoThePlugin) {
  std::string bytes = ReadWholeFile(Build(CppThatAnswers(42)).plugin).value();
  EXPECT_EQ(bytes.find("building-"), std::string::npos);
}

TEST_F(BuildPluginTest, TakesARefusalAsOurMistake) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  try {
    Build("this is no C++\n");
    ADD_FAILURE() << "no error";
  } catch (const InternalError& error) {
    EXPECT_THAT(error.what(), HasSubstr("`task`"));
    EXPECT_EQ(ReadWholeFile(error.evidence() / "plugin.cpp"), "this is no C++\n");
    EXPECT_THAT(ReadWholeFile(error.evidence() / "compiler-output.txt").value(),
                HasSubstr("error:"));
    EXPECT_THAT(ReadWholeFile(error.evidence() / "command.txt").value(), HasSubstr("-O2"));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(BuildPluginTest, TakesTroubleOfTheMachineForWhatItIs) {
  {
    ScopedEnvironment cxx("CXX", FakeCompiler("echo 'x.s: No space left on device' >&2; exit 1"));
    EXPECT_THAT(CallErrorOfBuild(), HasSubstr("the disk is full"));
  }
  {
    ScopedEnvironment cxx("CXX", FakeCompiler("kill -TERM $$"));
    EXPECT_THAT(CallErrorOfBuild(), HasSubstr("terminated by signal 15"));
  }
  {
    ScopedEnvironment cxx("CXX", FakeCompiler("echo \"g++: fatal error: cannot execute 'cc1plus'\";"
                                              "exit 1"));
    EXPECT_THAT(CallErrorOfBuild(), HasSubstr("reinstall it"));
  }
  EXPECT_TRUE(NamesIn(cache_.path()).empty());
}

TEST_F(BuildPluginTest, NeedsNoWritableCacheForWhatIsThere) {
  BuildResult built = Build(CppThatAnswers(42));
  fs::permissions(cache_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_TRUE(Build(CppThatAnswers(42)).from_cache);
  fs::permissions(cache_.path(), fs::perms::owner_all);
}

}  // namespace
}  // namespace compiler
