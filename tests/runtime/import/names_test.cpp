#include "runtime/import/names.h"

#include <gmock/gmock.h>

namespace runtime {
namespace {

TEST(Names, AreThoseOfTasks) {
  Names names;
  EXPECT_EQ(names.Take("base link/1", "link"), "base_link_1");
  EXPECT_EQ(names.Take("", "link"), "link");
  EXPECT_EQ(names.Take("", "link"), "link_2");
  EXPECT_EQ(names.Take("3rd", "link"), "_3rd");
  EXPECT_EQ(names.Take("if", "link"), "if_");
  EXPECT_EQ(names.Take("m", "link"), "m_");
}

TEST(Names, KnowTheOtherSide) {
  EXPECT_EQ(OnTheRight("left_knee"), "right_knee");
  EXPECT_EQ(OnTheRight("FL_hip_joint"), "FR_hip_joint");
  EXPECT_EQ(OnTheRight("l_sho_pitch"), "r_sho_pitch");
  EXPECT_EQ(OnTheRight("kneeLeft"), "kneeRight");
  EXPECT_EQ(OnTheRight("rl_hip"), "rr_hip");
  EXPECT_EQ(OnTheRight("right_knee"), "");
  EXPECT_EQ(OnTheRight("table"), "");
}

}  // namespace
}  // namespace runtime
