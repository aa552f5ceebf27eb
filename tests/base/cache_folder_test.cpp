#include "base/cache/cache_folder.h"

#include <gtest/gtest.h>

#include "tests/scoped_environment.h"

namespace cache {
namespace {

TEST(DefaultFolder, FollowsTheEnvironment) {
  const ScopedEnvironment home("HOME", "/home/ann");
  const ScopedEnvironment caches("XDG_CACHE_HOME", "/caches");
  {
    const ScopedEnvironment own("TASKC_CACHE", "/own");
    EXPECT_EQ(DefaultFolder(), "/own");
  }
  const ScopedEnvironment none("TASKC_CACHE", std::nullopt);
  EXPECT_EQ(DefaultFolder(), "/caches/taskc");
  const ScopedEnvironment no_caches("XDG_CACHE_HOME", std::nullopt);
  EXPECT_EQ(DefaultFolder(), "/home/ann/.cache/taskc");
  const ScopedEnvironment no_home("HOME", std::nullopt);
  EXPECT_EQ(DefaultFolder(), std::nullopt);
}

}  // namespace
}  // namespace cache
