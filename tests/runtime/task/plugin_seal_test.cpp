#include "runtime/task/plugin_seal.h"

#include <gtest/gtest.h>

#include <string>

namespace runtime {
namespace {

// SHA-256 of "abc", from FIPS 180-2.
constexpr const char* kSealOfAbc =
    "\ntaskc sha-256 ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

bool IsBroken(const std::string& content) {
  return HasBrokenSeal(std::as_bytes(std::span(content)));
}

TEST(PluginSeal, FitsWhatItWasMadeFor) { EXPECT_FALSE(IsBroken(std::string("abc") + kSealOfAbc)); }

TEST(PluginSeal, DoesNotFitAnythingElse) {
  EXPECT_TRUE(IsBroken(std::string("abd") + kSealOfAbc));
  EXPECT_TRUE(IsBroken(std::string("abcc") + kSealOfAbc));
  EXPECT_TRUE(IsBroken(kSealOfAbc));
}

TEST(PluginSeal, NothingIsSaidAgainstAFileWithoutOne) {
  EXPECT_FALSE(IsBroken(""));
  EXPECT_FALSE(IsBroken("abc"));
  EXPECT_FALSE(IsBroken(std::string(1000, 'x')));
}

}  // namespace
}  // namespace runtime
