#include "runtime/analysis/picture/surface.h"

#include <gtest/gtest.h>

#include "tests/runtime/theme_color.h"

namespace runtime {
namespace {

using Eigen::Vector3d;

Light LightOfTheme(const std::string& name) { return LightOf(ThemeColor(name)); }

robot::Link LinkOf(const char* name, robot::ShapeKind kind) {
  robot::Link link;
  link.name = name;
  link.shape = {kind, {0.1, 0.2, 0.3}, 0.1, 0.3, 2};
  return link;
}

TEST(SideOf, TakesWholeWordsOfTheName) {
  EXPECT_EQ(SideOf("left_hand"), Side::kLeft);
  EXPECT_EQ(SideOf("front_right"), Side::kRight);
  EXPECT_EQ(SideOf("leg_left_2"), Side::kLeft);
  EXPECT_EQ(SideOf("bright_lamp"), Side::kTrunk);
  EXPECT_EQ(SideOf("body"), Side::kTrunk);
}

TEST(PaintsOf, AreThePagesColors) {
  using enum robot::ShapeKind;
  const std::vector<Paint> paints =
      PaintsOf({LinkOf("body", kBox), LinkOf("left_hand", kCapsule), LinkOf("right_hand", kBox),
                LinkOf("left_knee", kSphere)});
  EXPECT_EQ(paints[0].light, LightOfTheme("trunk"));
  EXPECT_EQ(paints[1].light, LightOfTheme("left"));
  EXPECT_EQ(paints[2].light, LightOfTheme("right"));
  EXPECT_EQ(paints[3].light, 0.55 * LightOfTheme("left"));
}

TEST(ColorAt, HasAPlateOnTheFrontOfBaseAndHead) {
  using enum robot::ShapeKind;
  const std::vector<robot::Link> links = {LinkOf("torso", kBox), LinkOf("head", kBox),
                                          LinkOf("tail", kBox), LinkOf("right_hand", kBox)};
  const std::vector<Paint> paints = PaintsOf(links);
  const auto color = [&](size_t link, const Vector3d& place) {
    return ColorAt(paints[link], links[link].shape, place);
  };
  const Vector3d front(0.05, 0, 0.05);
  EXPECT_EQ(color(0, front), LightOfTheme("plate"));
  EXPECT_EQ(color(1, front), LightOfTheme("plate"));
  EXPECT_EQ(color(2, front), LightOfTheme("trunk"));
  EXPECT_EQ(color(3, front), LightOfTheme("right"));
  EXPECT_EQ(color(0, {-0.05, 0, 0.05}), LightOfTheme("trunk"));  // behind
  EXPECT_EQ(color(0, {0.05, 0.07, 0.05}), LightOfTheme("trunk"));
  EXPECT_EQ(color(0, {0.05, 0, -0.05}), LightOfTheme("trunk"));
}

TEST(Shade, IsDarkerInTheShadowAndInCorners) {
  Illumination light{Vector3d::UnitZ(), -Vector3d::UnitY(), Vector3d::UnitX(), true, 1};
  const Light paint(0.5, 0.25, 0);
  const double lit = Shade(paint, Vector3d::UnitZ(), light)[0];
  light.is_lit = false;
  const Light shadow = Shade(paint, Vector3d::UnitZ(), light);
  EXPECT_LT(shadow[0], 0.6 * lit);
  EXPECT_DOUBLE_EQ(shadow[1], 0.5 * shadow[0]);  // no gloss
  light.openness = 0;
  EXPECT_EQ(Shade(paint, Vector3d::UnitZ(), light), Light::Zero());
}

}  // namespace
}  // namespace runtime
