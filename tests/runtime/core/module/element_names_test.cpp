#include "runtime/core/module/element_names.h"

#include <gmock/gmock.h>

namespace runtime {
namespace {

using testing::ElementsAre;

// One name for each number of a value of this name and type, of a robot with two links, a
// joint and a site.
std::vector<std::string> Names(const std::string& name, const std::string& type, size_t size = 1) {
  robot::RobotDescription robot;
  robot.links.resize(2);
  robot.links[0].name = "body";
  robot.links[1].name = "leg";
  robot.joints.resize(1);
  robot.joints[0].name = "hip";
  robot.sites.resize(1);
  robot.sites[0].name = "toe";
  return ElementNames({.name = name, .type = type, .unit = "", .size = size}, robot);
}

TEST(ElementNames, OfNumbersAndVectors) {
  EXPECT_THAT(Names("height", "real"), ElementsAre("height"));
  EXPECT_THAT(Names("a - b", "real"), ElementsAre("a - b"));
  EXPECT_THAT(Names("up", "vec3", 3), ElementsAre("up.x", "up.y", "up.z"));
  EXPECT_THAT(Names("base.orientation", "quat", 4),
              ElementsAre("base.orientation.w", "base.orientation.x", "base.orientation.y",
                          "base.orientation.z"));
  EXPECT_THAT(Names("turn", "mat2", 4),
              ElementsAre("turn[0, 0]", "turn[0, 1]", "turn[1, 0]", "turn[1, 1]"));
}

TEST(ElementNames, OfArraysByJointLinkSiteOrNumber) {
  EXPECT_THAT(Names("site.velocity", "vec3[site]", 3),
              ElementsAre("site.velocity[toe].x", "site.velocity[toe].y", "site.velocity[toe].z"));
  EXPECT_THAT(Names("joint.velocity", "real[joint]"), ElementsAre("joint.velocity[hip]"));
  EXPECT_THAT(Names("contact", "bool[link]", 2), ElementsAre("contact[body]", "contact[leg]"));
  EXPECT_THAT(Names("contact[feet]", "bool[2]", 2),
              ElementsAre("contact[feet][0]", "contact[feet][1]"));
  EXPECT_THAT(Names("steps", "vec2[2]", 4),
              ElementsAre("steps[0].x", "steps[0].y", "steps[1].x", "steps[1].y"));
}

TEST(ElementNames, AnExpressionIsPutInParenthesesWhereItHasToBe) {
  EXPECT_THAT(Names("joint.angle - joint.rest", "real[joint]"),
              ElementsAre("(joint.angle - joint.rest)[hip]"));
  EXPECT_THAT(Names("-velocity", "vec2", 2), ElementsAre("(-velocity).x", "(-velocity).y"));
  EXPECT_THAT(Names("rotate(q, v)", "vec2", 2), ElementsAre("rotate(q, v).x", "rotate(q, v).y"));
}

}  // namespace
}  // namespace runtime
