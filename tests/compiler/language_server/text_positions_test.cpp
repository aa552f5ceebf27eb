#include "compiler/language_server/text_positions.h"

#include <gtest/gtest.h>

#include <random>

namespace compiler {
namespace {

// One byte, two bytes, three, four (two units of UTF-16).
constexpr std::string_view kText = "aä€😀b\nzwei\r\ndrei\rvier";

TEST(TextPositions, CountInUnitsOfUtf16) {
  const TextPositions positions(kText, PositionEncoding::kUtf16);
  EXPECT_EQ(positions.PositionOf(0), (TextPosition{0, 0}));
  EXPECT_EQ(positions.PositionOf(3), (TextPosition{0, 2}));
  EXPECT_EQ(positions.PositionOf(6), (TextPosition{0, 3}));
  EXPECT_EQ(positions.PositionOf(10), (TextPosition{0, 5}));
  EXPECT_EQ(positions.OffsetOf({0, 5}), 10u);
}

TEST(TextPositions, CountInBytesWhereThatWasAgreed) {
  const TextPositions positions(kText, PositionEncoding::kUtf8);
  EXPECT_EQ(positions.PositionOf(10), (TextPosition{0, 10}));
  EXPECT_EQ(positions.OffsetOf({0, 10}), 10u);
}

TEST(TextPositions, KnowThreeKindsOfLineEnds) {
  const TextPositions positions(kText, PositionEncoding::kUtf16);
  EXPECT_EQ(positions.OffsetOf({1, 0}), 12u);
  EXPECT_EQ(positions.OffsetOf({2, 0}), 18u);
  EXPECT_EQ(positions.OffsetOf({3, 0}), 23u);
  EXPECT_EQ(positions.PositionOf(24), (TextPosition{3, 1}));
}

TEST(TextPositions, StayInsideTheText) {
  const TextPositions positions(kText, PositionEncoding::kUtf16);
  EXPECT_EQ(positions.OffsetOf({1, 99}), 16u) << "the end of the line";
  EXPECT_EQ(positions.OffsetOf({99, 0}), kText.size());
  EXPECT_EQ(positions.PositionOf(999), (TextPosition{3, 4}));
  EXPECT_EQ(positions.OffsetOf({0, 4}), 6u) << "inside of a pair";
  EXPECT_EQ(positions.PositionOf(8), (TextPosition{0, 3})) << "inside of a character";
}

TEST(TextPositions, GoBothWays) {
  std::mt19937 random(3);
  const std::string pieces[] = {"a", "ä", "€", "😀", "\n", "\r\n", "\t"};
  for (const auto encoding : {PositionEncoding::kUtf8, PositionEncoding::kUtf16}) {
    std::string text;
    for (int i = 0; i < 200; ++i) {
      const TextPositions positions(text, encoding);
      const auto end = static_cast<uint32_t>(text.size());
      EXPECT_EQ(positions.OffsetOf(positions.PositionOf(end)), end);
      text += pieces[random() % std::size(pieces)];
    }
  }
}

}  // namespace
}  // namespace compiler
