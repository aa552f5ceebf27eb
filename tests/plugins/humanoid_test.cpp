// The humanoid's description against the published tables of the model.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "plugins/robot/robot_description.h"

namespace robot {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

constexpr double kPi = std::numbers::pi;

const RobotDescription& Humanoid() {
  static const RobotDescription robot = ReadRobot(HUMANOID);
  return robot;
}

TEST(Humanoid, WeighsTwelveHundredGrams) {
  double total = 0;
  for (const Link& link : Humanoid().links) total += link.mass;
  EXPECT_NEAR(total, 1.2, 1e-9);
}

TEST(Humanoid, MassesAreThoseOfTheModelScaled) {
  const std::vector<double> grams = {219.6, 32.30, 5.44, 40.16, 37.40, 5.44,  40.16, 37.40, 8.95,
                                     67.84, 40.16, 8.95, 35.00, 8.95,  67.84, 40.16, 8.95,  35.00};
  const double sum = std::accumulate(grams.begin(), grams.end(), 0.0);
  ASSERT_EQ(Humanoid().links.size(), grams.size());
  for (size_t i = 0; i < grams.size(); ++i) {
    EXPECT_NEAR(Humanoid().links[i].mass, 1.2 * grams[i] / sum, 1e-12) << i;
  }
}

TEST(Humanoid, StandsWithItsSolesOnTheGround) {
  const Pose& standing = Humanoid().poses[0];
  EXPECT_EQ(standing.name, "standing");
  for (const char* foot : {"left_foot", "right_foot"}) {
    const Link& link = Humanoid().links[*Humanoid().FindLink(foot)];
    EXPECT_NEAR(standing.position[2] + link.position[2] - link.shape.size[2] / 2, 0, 1e-15);
  }
  const Link& head = Humanoid().links[1];
  EXPECT_NEAR(standing.position[2] + head.position[2] + head.shape.size[2] / 2, 0.32807, 1e-9);
}

TEST(Humanoid, LinksAndJointsHaveTheIndicesOfThePaper) {
  std::vector<std::string> links, joints;
  for (const Link& link : Humanoid().links) links.push_back(link.name);
  for (const Joint& joint : Humanoid().joints) joints.push_back(joint.name);
  EXPECT_THAT(links, ElementsAre("body", "head", "left_shoulder", "left_upper_arm", "left_hand",
                                 "right_shoulder", "right_upper_arm", "right_hand", "left_hip",
                                 "left_thigh", "left_shank", "left_ankle", "left_foot", "right_hip",
                                 "right_thigh", "right_shank", "right_ankle", "right_foot"));
  EXPECT_THAT(joints, ElementsAre("neck_yaw", "left_shoulder_pitch", "left_shoulder_roll",
                                  "left_elbow_pitch", "right_shoulder_pitch", "right_shoulder_roll",
                                  "right_elbow_pitch", "left_hip_roll", "left_hip_pitch",
                                  "left_knee_pitch", "left_ankle_pitch", "left_ankle_roll",
                                  "right_hip_roll", "right_hip_pitch", "right_knee_pitch",
                                  "right_ankle_pitch", "right_ankle_roll"));
}

TEST(Humanoid, StopsAreTheMultiplesOfPiOfTheModel) {
  const std::map<std::string, std::pair<double, double>> stops = {
      {"neck_yaw", {-kPi / 2, kPi / 2}},
      {"left_shoulder_pitch", {-kPi / 2, 0.99 * kPi}},
      {"left_shoulder_roll", {-0.99 * kPi, kPi / 12}},
      {"right_shoulder_roll", {-kPi / 12, 0.99 * kPi}},
      {"left_hip_roll", {-kPi / 2, kPi / 9}},
      {"right_hip_roll", {-kPi / 9, kPi / 2}},
      {"left_knee_pitch", {-0.78 * kPi, kPi / 18}},
      {"right_ankle_roll", {-kPi, kPi}}};
  for (const auto& [name, range] : stops) {
    const Joint& joint = Humanoid().joints[*Humanoid().FindJoint(name)];
    EXPECT_DOUBLE_EQ(joint.low, range.first) << name;
    EXPECT_DOUBLE_EQ(joint.high, range.second) << name;
  }
}

TEST(Humanoid, LeftAndRightMirrorEachOther) {
  const auto mirrored = [](const std::string& name) { return "right" + name.substr(4); };
  for (const Link& left : Humanoid().links) {
    if (!left.name.starts_with("left")) continue;
    const Link& right = Humanoid().links[*Humanoid().FindLink(mirrored(left.name))];
    EXPECT_EQ(left.mass, right.mass) << left.name;
    EXPECT_EQ(left.shape.kind, right.shape.kind) << left.name;
    EXPECT_EQ(left.shape.size, right.shape.size) << left.name;
    EXPECT_EQ(left.shape.radius, right.shape.radius) << left.name;
    EXPECT_EQ(left.shape.length, right.shape.length) << left.name;
    EXPECT_EQ(left.shape.axis, right.shape.axis) << left.name;
    EXPECT_THAT(right.position, ElementsAre(left.position[0], -left.position[1], left.position[2]));
  }
  for (const Joint& left : Humanoid().joints) {
    if (!left.name.starts_with("left")) continue;
    const Joint& right = Humanoid().joints[*Humanoid().FindJoint(mirrored(left.name))];
    const bool is_roll = left.name.ends_with("roll");
    EXPECT_EQ(right.low, is_roll ? -left.high : left.low) << left.name;
    EXPECT_EQ(right.high, is_roll ? -left.low : left.high) << left.name;
    EXPECT_EQ(right.axis, left.axis) << left.name;
    EXPECT_THAT(right.anchor, ElementsAre(left.anchor[0], -left.anchor[1], left.anchor[2]));
  }
}

TEST(Humanoid, GroupsAreTheIndexSetsOfTheTasks) {
  std::map<std::string, std::vector<int>> groups;
  for (const Group& group : Humanoid().link_groups) groups[group.name] = group.members;
  EXPECT_THAT(groups["hands"], ElementsAre(4, 7));
  EXPECT_THAT(groups["feet"], ElementsAre(12, 17));
  EXPECT_THAT(groups["arms"], ElementsAre(2, 3, 4, 5, 6, 7));
  EXPECT_THAT(groups["legs"], ElementsAre(8, 9, 10, 11, 12, 13, 14, 15, 16, 17));
  EXPECT_THAT(groups["left_leg"], ElementsAre(8, 9, 10, 11, 12));
  EXPECT_THAT(groups["right_leg"], ElementsAre(13, 14, 15, 16, 17));
  EXPECT_THAT(groups["left_arm"], ElementsAre(2, 3, 4));
  EXPECT_THAT(groups["right_arm"], ElementsAre(5, 6, 7));
}

// The joint targets that coordinates 1, 2, 3, ... lead to.
std::vector<double> Targets(const std::string& name) {
  std::vector<double> targets(Humanoid().joints.size(), 0.0);
  for (const Coupling& coupling : Humanoid().FindDof(name)->couplings) {
    targets[coupling.joint] += coupling.factor * (coupling.coordinate + 1);
  }
  return targets;
}

TEST(Humanoid, DofConfigurationsDriveTheJointsOfThePaper) {
  using V = std::vector<double>;
  EXPECT_EQ(Targets("3"), (V{0, 1, 0, 1, 1, 0, 1, 0, 2, 3, -3, 0, 0, 2, 3, -3, 0}));
  EXPECT_EQ(Targets("3d"), (V{0, 1, 0, 1, 1, 0, 1, 0, 2, 3, -1.5, 0, 0, 2, 3, -1.5, 0}));
  EXPECT_EQ(Targets("4asym"), (V{0, 1, 0, 1, 2, 0, 2, 0, 3, -3, 3, 0, 0, 4, -4, 4, 0}));
  EXPECT_EQ(Targets("5"), (V{0, 1, 0, 2, 1, 0, 2, 0, 3, 4, 5, 0, 0, 3, 4, 5, 0}));
  EXPECT_EQ(Targets("6"), (V{0, 1, 0, 2, 1, 0, 2, 3, 4, 5, 6, 0, -3, 4, 5, 6, 0}));
  EXPECT_EQ(Targets("7"), (V{0, 1, 2, 3, 1, -2, 3, 4, 5, 6, 7, 0, -4, 5, 6, 7, 0}));
}

TEST(Humanoid, DofConfigurationsAreReadAtTheJointsOfThePaper) {
  EXPECT_THAT(Humanoid().FindDof("3")->representatives, ElementsAre(1, 8, 9));
  EXPECT_THAT(Humanoid().FindDof("3d")->representatives, ElementsAre(1, 8, 9));
  EXPECT_THAT(Humanoid().FindDof("4asym")->representatives, ElementsAre(1, 4, 10, 15));
  EXPECT_THAT(Humanoid().FindDof("5")->representatives, ElementsAre(1, 3, 8, 9, 10));
  EXPECT_THAT(Humanoid().FindDof("6")->representatives, ElementsAre(1, 3, 7, 8, 9, 10));
  EXPECT_THAT(Humanoid().FindDof("7")->representatives, ElementsAre(1, 2, 3, 7, 8, 9, 10));
}

TEST(Humanoid, NetsHaveTheSizesOfThePaper) {
  const auto units = [](const char* name) {
    const NetDescription& net = *Humanoid().FindNet(name);
    if (net.kind == NetKind::kBubble) return net.units;
    return std::accumulate(net.counts.begin(), net.counts.end(), 1, std::multiplies<>());
  };
  EXPECT_EQ(units("bq01"), 300);
  EXPECT_EQ(units("q3"), 243);
  EXPECT_EQ(units("4asym_g4"), 256);
  EXPECT_EQ(units("4asym_g5"), 625);
  EXPECT_EQ(units("3_g5"), 125);
  EXPECT_EQ(units("3_g7"), 343);
  EXPECT_EQ(units("bq3dof60"), 60);
}

}  // namespace
}  // namespace robot
