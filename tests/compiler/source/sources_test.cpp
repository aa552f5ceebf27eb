#include "compiler/source/sources.h"

#include <gtest/gtest.h>

#include <utility>

namespace compiler {
namespace {

TEST(Sources, CountThroughTheirFiles) {
  Sources sources;
  EXPECT_EQ(sources.Add("a.task", "one\n").first_offset(), 0u);
  EXPECT_EQ(sources.Add("b.task", "").first_offset(), 5u);
  EXPECT_EQ(sources.Add("c.task", "two").first_offset(), 6u);
  EXPECT_EQ(sources.main().path(), "a.task");
  EXPECT_EQ(sources.files().size(), 3u);
}

TEST(Sources, KnowTheFileOfASpan) {
  Sources sources("a.task", "one\n");
  sources.Add("b.task", "");
  sources.Add("c.task", "x\ntwo");
  EXPECT_EQ(sources.FileOf({0, 3}).path(), "a.task");
  EXPECT_EQ(sources.FileOf({4, 4}).path(), "a.task");
  EXPECT_EQ(sources.FileOf({5, 5}).path(), "b.task");
  EXPECT_EQ(sources.FileOf({6, 7}).path(), "c.task");
  EXPECT_EQ(sources.FileOf({100, 100}).path(), "c.task");
  EXPECT_EQ(sources.IndexOf({5, 5}), 1u);
}

TEST(Sources, KnowTheLineOfASpanInItsFile) {
  Sources sources("a.task", "one\ntwo\nthree");
  const SourceFile& second = sources.Add("b.task", "four\nfive\n");
  EXPECT_EQ(sources.PositionOf({9, 10}), (Position{3, 2}));
  EXPECT_EQ(sources.PositionOf({21, 23}), (Position{2, 3}));
  EXPECT_EQ(sources.LineOf({21, 23}), 2u);
  EXPECT_EQ(second.TextOf({21, 23}), "ve");
  EXPECT_EQ(second.LineStart(2), 19u);
  EXPECT_EQ(second.Line(2), "five");
  EXPECT_EQ(second.end_offset(), 24u);
}

TEST(Sources, KeepTheirFilesInPlace) {
  Sources sources("a.task", "one");
  const SourceFile& first = sources.main();
  for (int i = 0; i < 100; ++i) sources.Add("another.task", "text");
  EXPECT_EQ(&sources.main(), &first);
  const Sources moved = std::move(sources);
  EXPECT_EQ(&moved.main(), &first);
}

}  // namespace
}  // namespace compiler
