#include "plugins/robot/sensors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace robot {
namespace {

TEST(Sensors, AreListedInTheOrderOfTheirIds) {
  ASSERT_EQ(Sensors().size(), static_cast<size_t>(SensorId::kCount));
  for (size_t i = 0; i < Sensors().size(); ++i) {
    EXPECT_EQ(Sensors()[i].id, static_cast<SensorId>(i));
  }
}

TEST(Sensors, HaveNamesOfTheirOwnAndADocumentation) {
  std::set<std::string_view> names;
  for (const SensorDescription& sensor : Sensors()) {
    EXPECT_TRUE(names.insert(sensor.name).second) << sensor.name;
    EXPECT_FALSE(sensor.doc.empty()) << sensor.name;
  }
}

TEST(Sensors, ElementCountFollowsTypeAndRobot) {
  RobotDescription robot;
  robot.links.resize(18);
  robot.joints.resize(17);
  robot.sites.resize(5);
  const std::map<std::string_view, int> counts = {{"time", 1},
                                                  {"base.position", 3},
                                                  {"base.orientation", 4},
                                                  {"base.rotation", 9},
                                                  {"base.forward", 3},
                                                  {"base.left", 3},
                                                  {"base.up", 3},
                                                  {"base.velocity", 3},
                                                  {"base.angular_velocity", 3},
                                                  {"joint.angle", 17},
                                                  {"joint.velocity", 17},
                                                  {"joint.torque", 17},
                                                  {"contact", 18},
                                                  {"base.acceleration", 3},
                                                  {"joint.acceleration", 17},
                                                  {"joint.target", 17},
                                                  {"link.position", 54},
                                                  {"link.orientation", 72},
                                                  {"link.velocity", 54},
                                                  {"link.angular_velocity", 54},
                                                  {"contact_force", 54},
                                                  {"site.position", 15},
                                                  {"site.orientation", 20},
                                                  {"site.velocity", 15},
                                                  {"site.angular_velocity", 15},
                                                  {"site.acceleration", 15}};
  ASSERT_EQ(counts.size(), Sensors().size());
  for (const SensorDescription& sensor : Sensors()) {
    EXPECT_EQ(ElementCount(sensor, robot), counts.at(sensor.name)) << sensor.name;
  }
}

TEST(Sensors, OfSitesAreOnlyThereWithSites) {
  RobotDescription robot;
  EXPECT_EQ(SensorsOf(robot).size(), Sensors().size() - 5);
  EXPECT_EQ(SensorsOf(robot).back().id, SensorId::kContactForce);
  robot.sites.resize(1);
  EXPECT_EQ(SensorsOf(robot).size(), Sensors().size());
}

TEST(Sensors, RestWithTheBaseUpright) {
  const std::map<std::string_view, std::vector<double>> upright = {
      {"base.orientation", {1, 0, 0, 0}},
      {"base.rotation", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
      {"base.forward", {1, 0, 0}},
      {"base.left", {0, 1, 0}},
      {"base.up", {0, 0, 1}},
      {"base.acceleration", {0, 0, 9.8}},
      {"link.orientation", {1, 0, 0, 0}},
      {"site.orientation", {1, 0, 0, 0}},
      {"site.acceleration", {0, 0, 9.8}}};
  for (const SensorDescription& sensor : Sensors()) {
    const auto known = upright.find(sensor.name);
    EXPECT_EQ(std::vector(sensor.at_rest.begin(), sensor.at_rest.end()),
              known == upright.end() ? std::vector<double>{} : known->second)
        << sensor.name;
  }
}

TEST(Constants, AreThoseOfTheDescription) {
  const RobotDescription robot = ReadRobot(ROBOTS "/hopper/robot.toml");
  std::map<std::string_view, std::vector<double>> values;
  for (const ConstantDescription& constant : Constants()) {
    values[constant.name] = ValuesOf(constant, robot);
    EXPECT_EQ(FindSensor(constant.name), nullptr);
  }
  EXPECT_EQ(values["joint.low"], (std::vector{robot.joints[0].low, robot.joints[1].low}));
  EXPECT_EQ(values["joint.high"], (std::vector{robot.joints[0].high, robot.joints[1].high}));
  EXPECT_EQ(values["joint.rest"], robot.poses[0].joint_angles);
  EXPECT_EQ(values["joint.max_torque"], std::vector(2, robot.controller.max_torque));
  EXPECT_EQ(values["link.mass"],
            (std::vector{robot.links[0].mass, robot.links[1].mass, robot.links[2].mass}));
}

TEST(Sensors, AreFoundByName) {
  ASSERT_NE(FindSensor("base.velocity"), nullptr);
  EXPECT_EQ(FindSensor("base.velocity")->id, SensorId::kBaseVelocity);
  EXPECT_EQ(FindSensor("base"), nullptr);
}

class RangesTest : public testing::Test {
 protected:
  // "-3 3, -1 1"
  std::string RangesText(SensorId id) const {
    std::string text;
    for (const Range& range : RangesOf(Sensors()[static_cast<size_t>(id)], robot_)) {
      if (!text.empty()) text += ", ";
      text += fmt::format("{:.3g} {:.3g}", range.low, range.high);
    }
    return text;
  }

  const RobotDescription robot_ = ReadRobot(ROBOTS "/hopper/robot.toml");
};

TEST_F(RangesTest, OfJointsAreTheirStopsAndTheirTorque) {
  EXPECT_EQ(RangesText(SensorId::kJointAngle), "-1.67 1.67, -2.19 0.109");
  EXPECT_EQ(RangesText(SensorId::kJointTorque), "-3 3, -3 3");
}

TEST_F(RangesTest, OfDirectionsTimeAndConditionsAreKnown) {
  EXPECT_EQ(RangesText(SensorId::kBaseUp), "-1 1, -1 1, -1 1");
  EXPECT_EQ(RangesText(SensorId::kBaseOrientation), "-1 1, -1 1, -1 1, -1 1");
  EXPECT_EQ(RangesText(SensorId::kTime), "0 inf");
  EXPECT_EQ(RangesText(SensorId::kContact), "0 1, 0 1, 0 1");
}

TEST_F(RangesTest, OfVelocitiesAreWhatTheDescriptionSays) {
  EXPECT_EQ(RangesText(SensorId::kBaseVelocity), "-3 3, -1 1, -5 5");
  EXPECT_EQ(RangesText(SensorId::kJointVelocity), "-50 50, -50 50");
  EXPECT_EQ(RangesText(SensorId::kBasePosition), "-inf inf, -inf inf, -inf inf");
}

TEST_F(RangesTest, OfWhatFollowsFromOthersFollow) {
  RobotDescription robot = robot_;
  const auto range = [&](SensorId id, size_t element) {
    return RangesOf(Sensors()[static_cast<size_t>(id)], robot)[element];
  };
  EXPECT_EQ(range(SensorId::kLinkPosition, 3).low, -std::numeric_limits<double>::infinity());
  robot.nominal_ranges.push_back({"base.position", {{-1, 2}, {-3, 4}, {0, 1}}});
  EXPECT_EQ(range(SensorId::kLinkPosition, 1).low, -3);  // of the base itself
  EXPECT_LT(range(SensorId::kLinkPosition, 4).low, -3);
  EXPECT_LT(range(SensorId::kLinkPosition, 7).low, range(SensorId::kLinkPosition, 4).low);
  EXPECT_EQ(range(SensorId::kLinkVelocity, 0).high, kFastest);
  EXPECT_EQ(range(SensorId::kJointAcceleration, 1).high, 100 / robot.controller.time_step);
  EXPECT_GT(range(SensorId::kBaseAcceleration, 0).high, 10 / robot.controller.time_step);
  robot.nominal_ranges.push_back({"link.velocity", {{-4, 4}}});
  EXPECT_EQ(range(SensorId::kLinkVelocity, 8).high, 4);
}

// Of a site at the end of an arm of 0.5 m on the shank.
TEST_F(RangesTest, OfSitesFollowFromTheirLinks) {
  RobotDescription robot = robot_;
  const Vector3 center = robot.links[2].position;
  robot.sites = {
      {.name = "tip", .link = 2, .position = {center[0] + 0.3, center[1], center[2] - 0.4}}};
  const auto range = [&](SensorId id, size_t element) {
    return RangesOf(Sensors()[static_cast<size_t>(id)], robot)[element];
  };
  robot.nominal_ranges.push_back({"base.position", {{-1, 2}, {-3, 4}, {0, 1}}});
  EXPECT_DOUBLE_EQ(range(SensorId::kSitePosition, 1).high,
                   range(SensorId::kLinkPosition, 7).high + 0.5);
  EXPECT_DOUBLE_EQ(range(SensorId::kSitePosition, 2).low,
                   range(SensorId::kLinkPosition, 8).low - 0.5);
  robot.nominal_ranges.push_back({"link.velocity", {{-4, 5}}});
  robot.nominal_ranges.push_back({"link.angular_velocity", {{-20, 10}}});
  const double turning = 0.5 * 20 * std::sqrt(3);
  EXPECT_DOUBLE_EQ(range(SensorId::kSiteVelocity, 0).low, -4 - turning);
  EXPECT_DOUBLE_EQ(range(SensorId::kSiteVelocity, 2).high, 5 + turning);
  EXPECT_EQ(range(SensorId::kSiteAngularVelocity, 0).low, -20);
  const double change = (9 + 2 * turning) / robot.controller.time_step;
  EXPECT_DOUBLE_EQ(range(SensorId::kSiteAcceleration, 1).high, std::sqrt(3) * change + kGravity);
  EXPECT_EQ(range(SensorId::kSiteOrientation, 3).low, -1);
  robot.nominal_ranges.push_back({"site.velocity", {{-2, 2}}});
  EXPECT_EQ(range(SensorId::kSiteVelocity, 1).high, 2);
}

}  // namespace
}  // namespace robot
