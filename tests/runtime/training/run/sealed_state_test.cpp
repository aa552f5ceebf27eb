#include "runtime/training/run/sealed_state.h"

#include <gtest/gtest.h>

#include <span>

#include "runtime/training/run/compression.h"
#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

std::string Compressed(const std::string& text) {
  return Compress(std::as_bytes(std::span(text.data(), text.size())));
}

TEST(SealedState, GivesBackTheState) {
  const std::string state = Compressed("what was learned");
  EXPECT_EQ(UnsealState(7, SealState(7, state)), state);
  EXPECT_EQ(UnsealState(1, SealState(1, "")), "");
}

TEST(SealedState, NoticesEveryByteThatWasChanged) {
  const std::string sealed = SealState(7, Compressed(std::string(300, 'x') + "what was learned"));
  ASSERT_TRUE(UnsealState(7, sealed));
  for (size_t i = 0; i < sealed.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = sealed;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      EXPECT_FALSE(UnsealState(7, damaged)) << "byte " << i << ", bit " << bit;
    }
    EXPECT_FALSE(UnsealState(7, sealed.substr(0, i))) << i;
  }
  EXPECT_FALSE(UnsealState(7, sealed + "x"));
}

TEST(SealedState, BelongsToItsEpisode) {
  EXPECT_FALSE(UnsealState(8, SealState(7, Compressed("state"))));
}

TEST(SealedState, TakesAStateFromBeforeThereWereHashes) {
  const std::string state = Compressed("state");
  EXPECT_EQ(UnsealState(7, state), state);
}

// Of all that is compressed, also of recordings.
TEST(Compression, AChangedByteIsNoticedOrChangesNothing) {
  const std::string text = "what was recorded, " + std::string(300, 'x');
  const std::string compressed = Compressed(text);
  for (size_t i = 0; i < compressed.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = compressed;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      std::string read = text;
      ErrorOf([&] { read = Decompress(damaged, "it"); });
      EXPECT_EQ(read, text) << "byte " << i << ", bit " << bit;
    }
    EXPECT_NE(ErrorOf([&] { Decompress(compressed.substr(0, i), "it"); }), "") << i;
  }
  EXPECT_NE(ErrorOf([&] { Decompress(compressed + "x", "it"); }), "");
}

}  // namespace
}  // namespace runtime
