#include "compiler/toolchain/cxx_compiler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/source/diagnostic.h"
#include "compiler/toolchain/file_io.h"
#include "tests/compiler/temporary_folder.h"
#include "tests/scoped_environment.h"

namespace compiler {
namespace {

namespace fs = std::filesystem;

// A program of this name in the folder.
fs::path MakeProgram(const fs::path& file) {
  WriteWholeFile(file, "#!/bin/sh\n");
  fs::permissions(file, fs::perms::owner_all);
  return file;
}

std::string SearchError() {
  try {
    FindCxxCompiler();
  } catch (const CallError& error) {
    return error.what();
  }
  return "no error";
}

TEST(FindCxxCompiler, PrefersWhatCxxSays) {
  TemporaryFolder folder;
  fs::path program = MakeProgram(folder.path() / "my-c++");
  ScopedEnvironment cxx("CXX", program.string() + "  --flag");
  EXPECT_THAT(FindCxxCompiler().command, testing::ElementsAre(program.string(), "--flag"));
}

TEST(FindCxxCompiler, SearchesThePath) {
  TemporaryFolder folder;
  MakeProgram(folder.path() / "c++");
  fs::create_directories(folder.path() / "first" / "g++");  // a folder is no program
  ScopedEnvironment cxx("CXX", "");
  ScopedEnvironment path("PATH",
                         (folder.path() / "first").string() + "::" + folder.path().string());
  EXPECT_THAT(FindCxxCompiler().command, testing::ElementsAre((folder.path() / "c++").string()));
  MakeProgram(folder.path() / "g++");
  EXPECT_THAT(FindCxxCompiler().command, testing::ElementsAre((folder.path() / "g++").string()));
}

TEST(FindCxxCompiler, SaysWhatToDoWhereThereIsNone) {
  TemporaryFolder folder;
  ScopedEnvironment path("PATH", folder.path().string());
  ScopedEnvironment cxx("CXX", std::nullopt);
  EXPECT_THAT(SearchError(), testing::HasSubstr("apt install g++"));
  ScopedEnvironment wrong("CXX", "clang++-99 -O1");
  EXPECT_THAT(SearchError(), testing::HasSubstr("CXX names `clang++-99`"));
}

TEST(FindCxxCompiler, TellsVersionsApart) {
  TemporaryFolder folder;
  fs::path program = MakeProgram(folder.path() / "my-c++");
  ScopedEnvironment cxx("CXX", program.string());
  std::string before = FindCxxCompiler().identity;
  EXPECT_EQ(FindCxxCompiler().identity, before);
  WriteWholeFile(program, "#!/bin/sh\n# newer\n");
  EXPECT_NE(FindCxxCompiler().identity, before);
}

}  // namespace
}  // namespace compiler
