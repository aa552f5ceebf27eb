#include "compiler/language_server/uri.h"

#include <gtest/gtest.h>

namespace compiler {
namespace {

TEST(Uri, NamesAPath) {
  EXPECT_EQ(PathOfUri("file:///a/b.task"), "/a/b.task");
  EXPECT_EQ(PathOfUri("file://localhost/a/b.task"), "/a/b.task");
  EXPECT_EQ(PathOfUri("file:///a%20b/%C3%A4.task"), "/a b/ä.task");
  EXPECT_EQ(PathOfUri("file:///a/../b%2.task"), "/b%2.task");
}

TEST(Uri, OfAnotherKindHasNoPath) {
  EXPECT_EQ(PathOfUri("untitled:Untitled-1"), std::nullopt);
  EXPECT_EQ(PathOfUri("file://nothing"), std::nullopt);
}

TEST(Uri, IsMadeOfAPath) {
  EXPECT_EQ(UriOfPath("/a b/ä#1.task"), "file:///a%20b/%C3%A4%231.task");
  EXPECT_EQ(PathOfUri(UriOfPath("/a b/%ä.task")), "/a b/%ä.task");
}

}  // namespace
}  // namespace compiler
