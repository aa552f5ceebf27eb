#pragma once

#include <gtest/gtest.h>

#include "compiler/bounds/interval.h"

namespace compiler {

inline void ExpectEnds(const Interval& x, double low, double high) {
  EXPECT_DOUBLE_EQ(x.low, low);
  EXPECT_DOUBLE_EQ(x.high, high);
  EXPECT_FALSE(x.may_be_nan);
}

}  // namespace compiler
