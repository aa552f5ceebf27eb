#include "base/seal/seal.h"

#include <gtest/gtest.h>

namespace seal {
namespace {

// SHA-256 of "abc", from FIPS 180-2.
constexpr const char* kSealOfAbc =
    "\ntaskc sha-256 ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(Seal, IsTheHashBehindItsMark) { EXPECT_EQ(Seal("abc"), std::string("abc") + kSealOfAbc); }

TEST(Seal, FitsWhatItWasMadeFor) {
  EXPECT_EQ(StateOf(std::string("abc") + kSealOfAbc), State::kIntact);
  EXPECT_EQ(StateOf(Seal(std::string("plugin\0bytes", 12))), State::kIntact);
}

TEST(Seal, DoesNotFitAnythingElse) {
  EXPECT_EQ(StateOf(std::string("abd") + kSealOfAbc), State::kBroken);
  EXPECT_EQ(StateOf(std::string("abcc") + kSealOfAbc), State::kBroken);
  EXPECT_EQ(StateOf(kSealOfAbc), State::kBroken);
}

TEST(Seal, IsBrokenOrGoneAfterAnyChange) {
  const std::string sealed = Seal(std::string("plugin\0bytes", 12));
  for (size_t length = 0; length < sealed.size(); ++length) {
    EXPECT_NE(StateOf(sealed.substr(0, length)), State::kIntact) << length;
  }
  for (size_t i = 0; i < sealed.size(); ++i) {
    std::string changed = sealed;
    changed[i] ^= 1;
    EXPECT_NE(StateOf(changed), State::kIntact) << i;
  }
}

TEST(Seal, IsKnownByTheEndOfAFile) {
  const std::string sealed = Seal("abc");
  EXPECT_TRUE(IsSeal(sealed.substr(sealed.size() - kSize)));
  EXPECT_FALSE(IsSeal(sealed));
  EXPECT_FALSE(IsSeal(std::string(kSize, 'x')));
}

TEST(Seal, IsAbsentFromFilesMadeOtherwise) {
  EXPECT_EQ(StateOf(""), State::kAbsent);
  EXPECT_EQ(StateOf("abc"), State::kAbsent);
  EXPECT_EQ(StateOf(std::string(1000, 'x')), State::kAbsent);
}

}  // namespace
}  // namespace seal
