#include "compiler/toolchain/plugin_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/seal/seal.h"
#include "compiler/source/diagnostic.h"
#include "compiler/toolchain/file_io.h"
#include "tests/compiler/temporary_folder.h"
#include "tests/scoped_environment.h"

namespace compiler {
namespace {

TEST(DefaultCacheFolder, FollowsTheEnvironment) {
  ScopedEnvironment home("HOME", "/home/ann");
  ScopedEnvironment xdg("XDG_CACHE_HOME", "/caches");
  ScopedEnvironment own("TASKC_CACHE", "/own");
  EXPECT_EQ(DefaultCacheFolder(), "/own");
  ScopedEnvironment no_own("TASKC_CACHE", "");
  EXPECT_EQ(DefaultCacheFolder(), "/caches/taskc");
  ScopedEnvironment no_xdg("XDG_CACHE_HOME", std::nullopt);
  EXPECT_EQ(DefaultCacheFolder(), "/home/ann/.cache/taskc");
  ScopedEnvironment no_home("HOME", std::nullopt);
  EXPECT_THROW(DefaultCacheFolder(), CallError);
}

TEST(PluginCache, TakesOnlyWholeSealedPluginsForIntact) {
  TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "plugin.so";
  const std::string sealed = seal::Seal("plugin");
  WriteWholeFile(file, sealed);
  EXPECT_TRUE(IsIntact(file));
  WriteWholeFile(file, sealed.substr(1));
  EXPECT_FALSE(IsIntact(file));
  WriteWholeFile(file, "plugin");
  EXPECT_FALSE(IsIntact(file));
  EXPECT_FALSE(IsIntact(folder.path() / "absent.so"));
  EXPECT_FALSE(IsIntact(folder.path()));
}

TEST(BuildFolder, GoesAwayUnlessItIsKept) {
  TemporaryFolder cache;
  std::filesystem::path kept = cache.path() / "kept";
  std::filesystem::path path;
  {
    BuildFolder folder(cache.path() / "new" / "cache", "build-XXXXXX");
    path = folder.path();
    WriteWholeFile(path / "file", "x");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  for (const char* text : {"first", "second"}) {
    BuildFolder folder(cache.path(), "build-XXXXXX");
    WriteWholeFile(folder.path() / "file", text);
    folder.KeepAs(kept);
  }
  EXPECT_EQ(ReadWholeFile(kept / "file"), "second");
}

TEST(RemoveEntry, EntersNoFolderInAFolderAndNoLink) {
  namespace fs = std::filesystem;
  TemporaryFolder cache;
  const fs::path entry = cache.path() / "entry";
  fs::create_directories(entry / "of-others");
  WriteWholeFile(entry / "of-others" / "file", "x");
  WriteWholeFile(entry / "file", "x");
  fs::create_directory(cache.path() / "elsewhere");
  WriteWholeFile(cache.path() / "elsewhere" / "file", "x");
  fs::create_symlink(cache.path() / "elsewhere", entry / "link");
  EXPECT_FALSE(RemoveEntry(entry));
  EXPECT_TRUE(fs::exists(entry / "of-others" / "file"));
  EXPECT_FALSE(fs::exists(entry / "file"));
  fs::remove_all(entry / "of-others");
  fs::create_symlink(cache.path() / "elsewhere", entry / "link");
  EXPECT_TRUE(RemoveEntry(entry));
  fs::create_symlink(cache.path() / "elsewhere", entry);
  EXPECT_TRUE(RemoveEntry(entry));
  EXPECT_TRUE(fs::exists(cache.path() / "elsewhere" / "file"));
}

TEST(BuildFolder, SaysWhyThereCanBeNone) {
  TemporaryFolder folder;
  WriteWholeFile(folder.path() / "file", "");
  try {
    BuildFolder impossible(folder.path() / "file" / "cache", "build-XXXXXX");
    FAIL();
  } catch (const CallError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("file/cache`: Not a directory"),
                                             testing::HasSubstr("--cache DIR")));
  }
}

}  // namespace
}  // namespace compiler
