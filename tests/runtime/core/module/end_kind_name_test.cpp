#include "runtime/core/module/end_kind_name.h"

#include <gtest/gtest.h>

namespace runtime {
namespace {

TEST(EndKindName, IsReadBack) {
  EXPECT_EQ(EndKindName(EndKind::kTruncated), "truncated");
  for (const EndKind kind : kEndKinds) EXPECT_EQ(EndKindCalled(EndKindName(kind)), kind);
  EXPECT_EQ(EndKindCalled("succes"), std::nullopt);
}

}  // namespace
}  // namespace runtime
