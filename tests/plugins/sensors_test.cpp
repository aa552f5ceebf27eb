#include "plugins/robot/sensors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

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
  const std::map<std::string_view, int> counts = {
      {"time", 1},           {"base.position", 3},          {"base.orientation", 4},
      {"base.rotation", 9},  {"base.forward", 3},           {"base.left", 3},
      {"base.up", 3},        {"base.velocity", 3},          {"base.angular_velocity", 3},
      {"joint.angle", 17},   {"joint.velocity", 17},        {"joint.torque", 17},
      {"contact", 18},       {"base.acceleration", 3},      {"joint.acceleration", 17},
      {"joint.target", 17},  {"link.position", 54},         {"link.orientation", 72},
      {"link.velocity", 54}, {"link.angular_velocity", 54}, {"contact_force", 54}};
  ASSERT_EQ(counts.size(), Sensors().size());
  for (const SensorDescription& sensor : Sensors()) {
    EXPECT_EQ(ElementCount(sensor, robot), counts.at(sensor.name)) << sensor.name;
  }
}

TEST(Sensors, RestWithTheBaseUpright) {
  const std::map<std::string_view, std::vector<double>> upright = {
      {"base.orientation", {1, 0, 0, 0}},
      {"base.rotation", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
      {"base.forward", {1, 0, 0}},
      {"base.left", {0, 1, 0}},
      {"base.up", {0, 0, 1}},
      {"base.acceleration", {0, 0, 9.8}},
      {"link.orientation", {1, 0, 0, 0}}};
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

}  // namespace
}  // namespace robot
