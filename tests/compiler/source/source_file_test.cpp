#include "compiler/source/source_file.h"

#include <gtest/gtest.h>

#include <string>

namespace compiler {
namespace {

TEST(SourceFile, LinesAndColumnsCountFromOne) {
  const SourceFile file("a.task", "task t\n\nstart x");
  EXPECT_EQ(file.PositionOf(0), (Position{1, 1}));
  EXPECT_EQ(file.PositionOf(5), (Position{1, 6}));
  EXPECT_EQ(file.PositionOf(7), (Position{2, 1}));
  EXPECT_EQ(file.PositionOf(14), (Position{3, 7}));
}

TEST(SourceFile, AColumnIsACodePoint) {
  const SourceFile file("a.task", "\"\u00f6\u20ac\U0001F600\" x");  // 2, 3 and 4 bytes
  EXPECT_EQ(file.PositionOf(1), (Position{1, 2}));
  EXPECT_EQ(file.PositionOf(3), (Position{1, 3}));
  EXPECT_EQ(file.PositionOf(6), (Position{1, 4}));
  EXPECT_EQ(file.PositionOf(10), (Position{1, 5}));
  EXPECT_EQ(file.PositionOf(12), (Position{1, 7}));
}

TEST(SourceFile, AnOffsetInsideACodePointCountsAsThatCodePoint) {
  const SourceFile file("a.task", "\u20ac");
  EXPECT_EQ(file.PositionOf(1), (Position{1, 1}));
  EXPECT_EQ(file.PositionOf(2), (Position{1, 1}));
}

TEST(SourceFile, EveryBadByteIsAColumn) {
  const SourceFile file("a.task", "\xff\xfe x");
  EXPECT_EQ(file.PositionOf(3), (Position{1, 4}));
}

TEST(SourceFile, ColumnsOfALongLineAreCountedTheSame) {
  std::string text = "short\n";
  const uint32_t begin = 6;
  for (int i = 0; i < 1000; ++i) text += "a\u20ac\xff";  // 1, 3 and 1 bytes
  const SourceFile file("a.task", text + "\nshort");
  for (uint32_t i = 0; i < 1000; ++i) {
    const uint32_t column = 3 * i + 1;
    EXPECT_EQ(file.PositionOf(begin + 5 * i), (Position{2, column}));
    for (const uint32_t byte : {1, 2, 3}) {
      EXPECT_EQ(file.PositionOf(begin + 5 * i + byte), (Position{2, column + 1}));
    }
    EXPECT_EQ(file.PositionOf(begin + 5 * i + 4), (Position{2, column + 2}));
  }
  EXPECT_EQ(file.PositionOf(begin + 5000), (Position{2, 3001}));
  EXPECT_EQ(file.PositionOf(begin + 5001 + 2), (Position{3, 3}));
}

TEST(SourceFile, LinesEndWithLineFeedOrBoth) {
  const SourceFile file("a.task", "one\r\ntwo\nthree\r\n");
  ASSERT_EQ(file.line_count(), 4u);
  EXPECT_EQ(file.Line(1), "one");
  EXPECT_EQ(file.Line(2), "two");
  EXPECT_EQ(file.Line(3), "three");
  EXPECT_EQ(file.Line(4), "");
  EXPECT_EQ(file.PositionOf(4), (Position{1, 4})) << "inside the line's end";
  EXPECT_EQ(file.PositionOf(5), (Position{2, 1}));
}

TEST(SourceFile, AnOffsetBeyondTheEndIsTheEnd) {
  const SourceFile file("a.task", "ab\ncd");
  EXPECT_EQ(file.PositionOf(5), (Position{2, 3}));
  EXPECT_EQ(file.PositionOf(500), (Position{2, 3}));
}

TEST(SourceFile, AnEmptyFileHasOneEmptyLine) {
  const SourceFile file("a.task", "");
  EXPECT_EQ(file.line_count(), 1u);
  EXPECT_EQ(file.Line(1), "");
  EXPECT_EQ(file.PositionOf(0), (Position{1, 1}));
}

TEST(SourceFile, CoverSpansBoth) {
  EXPECT_EQ(Cover({3, 5}, {8, 9}), (Span{3, 9}));
  EXPECT_EQ(Cover({8, 9}, {3, 5}), (Span{3, 9}));
}

}  // namespace
}  // namespace compiler
