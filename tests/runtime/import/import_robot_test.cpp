#include "runtime/import/import_robot.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/robot/held_pose.h"
#include "runtime/base/user_error.h"
#include "runtime/core/shape/convex_hull.h"
#include "runtime/import/mesh_hull.h"
#include "tests/runtime/import/import_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::DoubleNear;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST_F(ImportRobotTest, UrdfBecomesLinksAndJoints) {
  const robot::RobotDescription robot =
      Read(TwoLinks("type=\"revolute\"><axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"2\" "
                    "effort=\"7\" velocity=\"5\"/><dynamics damping=\"0.1\" friction=\"0.2\"/>"));
  ASSERT_EQ(robot.links.size(), 2u);
  EXPECT_FALSE(robot.has_fixed_base);
  EXPECT_EQ(robot.links[0].shape.kind, robot::ShapeKind::kBox);
  EXPECT_EQ(robot.links[0].shape.size, (robot::Vector3{0.2, 0.3, 0.1}));
  EXPECT_NEAR(robot.links[0].inertia->yy, 0.012, 1e-9);
  EXPECT_EQ(robot.links[1].shape.kind, robot::ShapeKind::kCylinder);
  EXPECT_NEAR(robot.links[1].shape.length, 0.2, 1e-9);
  EXPECT_NEAR(robot.links[1].position[2], -0.15, 1e-9);
  const robot::Joint& hip = robot.joints[0];
  EXPECT_EQ(hip.axis, (robot::Vector3{0, -1, 0}));  // angles count the other way about
  EXPECT_NEAR(hip.low, -1, 1e-5);
  EXPECT_NEAR(hip.high, 2, 1e-5);
  EXPECT_NEAR(robot.GainsOf(hip).max_torque, 7, 1e-9);
  EXPECT_NEAR(robot.GainsOf(hip).max_speed, 5, 1e-9);
  EXPECT_NEAR(robot.GainsOf(hip).stiffness, 17.5, 0.1);
  EXPECT_NEAR(hip.passive.damper, 0.1, 1e-9);
  EXPECT_NEAR(hip.passive.friction, 0.2, 1e-9);
}

TEST_F(ImportRobotTest, EveryTypeOfJointHasOneHere) {
  EXPECT_EQ(Read(TwoLinks("type=\"continuous\"><axis xyz=\"1 0 0\"/>")).joints[0].kind,
            robot::JointKind::kContinuous);
  const robot::RobotDescription slider = Read(
      TwoLinks("type=\"prismatic\"><axis xyz=\"1 0 0\"/><limit lower=\"-0.1\" upper=\"0.2\"/>"));
  EXPECT_EQ(slider.joints[0].kind, robot::JointKind::kSlider);
  EXPECT_EQ(slider.joints[0].axis, (robot::Vector3{1, 0, 0}));
  EXPECT_NEAR(slider.joints[0].high, 0.2, 1e-9);
  const robot::RobotDescription fixed = Read(TwoLinks("type=\"fixed\">"));
  EXPECT_THAT(fixed.joints, IsEmpty());
  EXPECT_EQ(fixed.mounts.size(), 1u);
}

// A wedge: half of the box of 0.4 x 0.2 x 0.6 at the origin's side.
const std::string kWedge =
    "v 0 0 0\nv 0.4 0 0\nv 0 0.2 0\nv 0.4 0.2 0\nv 0 0 0.6\nv 0 0.2 0.6\n"
    "f 1 3 2\nf 2 3 4\nf 1 5 3\nf 3 5 6\nf 1 2 5\nf 3 6 4\nf 2 4 5\nf 4 6 5\n";

TEST_F(ImportRobotTest, AMeshBecomesItsHull) {
  std::ofstream(folder_.path() / "wedge.obj") << kWedge;
  const robot::RobotDescription robot =
      Read("<robot name=\"a\">" + Link("body", "<mesh filename=\"wedge.obj\"/>") + "</robot>");
  const robot::LinkShape& shape = robot.links[0].shape;
  ASSERT_EQ(shape.kind, robot::ShapeKind::kConvex);
  EXPECT_EQ(shape.points.size(), 6u);
  EXPECT_NEAR(MassOf(HullOf(shape.points)).volume, 0.5 * 0.4 * 0.2 * 0.6, 1e-6);
}

// Many files that others use with MuJoCo, too.
TEST_F(ImportRobotTest, AUrdfFileMayTellMujocoWhereItsMeshesAre) {
  std::filesystem::create_directory(folder_.path() / "parts");
  std::ofstream(folder_.path() / "parts" / "wedge.obj") << kWedge;
  const ImportedRobot imported = Import(
      "<robot name=\"a\">\n<mujoco><compiler meshdir=\"parts\" discardvisual=\"false\"/></mujoco>" +
      Link("body", "<mesh filename=\"wedge.obj\"/>") + "</robot>");
  EXPECT_EQ(robot::ReadRobot(imported.file).links[0].shape.points.size(), 6u);
}

TEST_F(ImportRobotTest, StlMayBeWrittenAsText) {
  constexpr const char* kCorners[] = {"0 0 0", "0.4 0 0", "0 0.2 0", "0 0 0.6"};
  constexpr int kFaces[][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string text = "solid pyramid\n";
  for (const auto& face : kFaces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : face) text += std::string("vertex ") + kCorners[corner] + "\n";
    text += "endloop\nendfacet\n";
  }
  std::ofstream(folder_.path() / "pyramid.stl") << text << "endsolid pyramid\n";
  const MeshHull hull = HullOfMesh({.file = folder_.path() / "pyramid.stl", .mass = 1});
  EXPECT_NEAR(hull.volume, 0.4 * 0.2 * 0.6 / 6, 1e-8);
}

TEST_F(ImportRobotTest, WithoutShapesForCollisionsThoseForTheEyeAreTaken) {
  std::string text = "<robot name=\"a\">" + Link("body", kBox) + "</robot>";
  for (const std::string word : {"<collision", "</collision"}) {
    text.replace(text.find(word + ">"), word.size(), word[1] == '/' ? "</visual" : "<visual");
  }
  const ImportedRobot imported = Import(text);
  EXPECT_THAT(imported.warnings, Contains(HasSubstr("no link has a shape for collisions")));
  EXPECT_EQ(robot::ReadRobot(imported.file).links[0].shape.size, (robot::Vector3{0.2, 0.3, 0.1}));
}

// V = 0.024; a wedge's center is a third of the way from the edge of its right angle.
TEST_F(ImportRobotTest, AMeshIsALinkOfUniformDensity) {
  std::ofstream(folder_.path() / "Wedge.OBJ") << kWedge;
  const MeshHull hull = HullOfMesh({.file = folder_.path() / "Wedge.OBJ", .scale = 0.5, .mass = 2});
  EXPECT_GE(hull.vertices, 6);
  EXPECT_NEAR(hull.volume, 0.024 / 8, 1e-8);
  EXPECT_NEAR(hull.link.position[0], 0.2 / 3, 1e-7);
  EXPECT_NEAR(hull.link.position[1], 0.05, 1e-7);
  EXPECT_NEAR(hull.link.position[2], 0.1, 1e-7);
  // About y the wedge's section is a right triangle of a = 0.2 by b = 0.3: m (a^2 + b^2) / 18.
  EXPECT_NEAR(hull.link.inertia->yy, 2 * (0.04 + 0.09) / 18, 1e-7);
  EXPECT_THAT(hull.text, AllOf(HasSubstr("shape = \"convex\""), HasSubstr("inertia = [")));
}

TEST_F(ImportRobotTest, WhatIsNoMeshIsRefusedAsOne) {
  const auto error_of = [&](const std::string& name, const std::string& bytes) -> std::string {
    std::ofstream(folder_.path() / name) << bytes;
    try {
      HullOfMesh({.file = folder_.path() / name});
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(error_of("mesh.dae", "<COLLADA/>"), HasSubstr("neither STL nor OBJ"));
  EXPECT_THAT(error_of("mesh.stl", "solid nothing"), HasSubstr("mesh.stl: MuJoCo"));
  EXPECT_THAT(error_of("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"),
              HasSubstr("flat.obj"));
}

TEST_F(ImportRobotTest, TheBaseIsAsTheUserSays) {
  const std::string text = TwoLinks("type=\"fixed\">");
  const ImportedRobot free = Import(text);
  EXPECT_THAT(free.warnings, Contains(HasSubstr("`--base fixed` fixes it")));
  EXPECT_TRUE(robot::ReadRobot(Import(text, "model.urdf", true).file).has_fixed_base);
}

TEST_F(ImportRobotTest, WhatIsFixedToALinkCalledWorldIsFixed) {
  const ImportedRobot imported =
      Import("<robot name=\"a\"><link name=\"world\"/>" + Link("body", kBox) +
             "<joint name=\"mount\" type=\"fixed\"><parent link=\"world\"/>"
             "<child link=\"body\"/></joint></robot>");
  EXPECT_THAT(imported.warnings, Not(Contains(HasSubstr("--base fixed"))));
  EXPECT_TRUE(robot::ReadRobot(imported.file).has_fixed_base);
}

// Turned by a quarter about z, then seen from a frame that is fixed to it in turn.
TEST_F(ImportRobotTest, FramesWithoutAShapeBecomeSitesOfTheirLink) {
  const ImportedRobot imported =
      Import("<robot name=\"a\">" + Link("body", kBox) +
             "<link name=\"camera\"/><joint name=\"c\" type=\"fixed\"><parent link=\"body\"/>"
             "<child link=\"camera\"/><origin xyz=\"0.1 0 0.02\" rpy=\"0 0 1.570796327\"/></joint>"
             "<link name=\"lens\"/><joint name=\"l\" type=\"fixed\"><parent link=\"camera\"/>"
             "<child link=\"lens\"/><origin xyz=\"0.01 0 0\"/></joint></robot>");
  EXPECT_THAT(imported.warnings,
              Contains(HasSubstr("sites of the link they are fixed to: `camera`, `lens`")));
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  EXPECT_EQ(robot.links.size(), 1u);
  ASSERT_EQ(robot.sites.size(), 2u);
  EXPECT_EQ(robot.sites[0].name, "camera");
  EXPECT_EQ(robot.sites[0].link, 0);
  EXPECT_THAT(
      robot.sites[0].position,
      testing::ElementsAre(DoubleNear(0.1, 1e-6), DoubleNear(0, 1e-6), DoubleNear(0.02, 1e-6)));
  EXPECT_NEAR(robot.sites[0].orientation[0], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(robot.sites[0].orientation[3], std::sqrt(0.5), 1e-6);
  EXPECT_THAT(
      robot.sites[1].position,
      testing::ElementsAre(DoubleNear(0.1, 1e-6), DoubleNear(0.01, 1e-6), DoubleNear(0.02, 1e-6)));
}

// Where the base's center is not where its frame is, and a link hangs on it.
TEST_F(ImportRobotTest, SitesOfMjcfKeepTheirPlaces) {
  const ImportedRobot imported = Import(
      "<mujoco><worldbody><site name=\"mark\"/><body name=\"b\" pos=\"0 0 1\"><freejoint/>"
      "<geom type=\"sphere\" size=\".1\" pos=\"0.3 0 0\" mass=\"1\"/>"
      "<site name=\"imu\" pos=\"0.3 0 0.05\" quat=\"0 1 0 0\"/><site pos=\"0 0 0\"/>"
      "<body name=\"c\" pos=\"0.5 0 0\"><joint name=\"j\" axis=\"0 1 0\"/>"
      "<geom type=\"sphere\" size=\".1\" mass=\"1\"/><site name=\"task\" pos=\"0 0.2 0\"/>"
      "</body></body></worldbody></mujoco>",
      "model.xml");
  EXPECT_THAT(imported.warnings,
              AllOf(Contains(HasSubstr("sites of the world are left out")),
                    Contains(HasSubstr("sites whose names tasks cannot write have others: `task` "
                                       "as `task_`"))));
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  ASSERT_EQ(robot.sites.size(), 3u);
  EXPECT_EQ(robot.sites[0].name, "imu");
  EXPECT_EQ(robot.sites[0].position, (robot::Vector3{0, 0, 0.05}));
  EXPECT_EQ(robot.sites[0].orientation, (robot::Quaternion{0, 1, 0, 0}));
  EXPECT_EQ(robot.sites[1].name, "site");
  EXPECT_EQ(robot.sites[1].position, (robot::Vector3{-0.3, 0, 0}));
  EXPECT_EQ(robot.sites[2].name, "task_");
  EXPECT_EQ(robot.sites[2].link, robot.FindLink("c"));
  EXPECT_THAT(
      robot.ArmOf(robot.sites[2]),
      testing::ElementsAre(DoubleNear(0, 1e-9), DoubleNear(0.2, 1e-9), DoubleNear(0, 1e-9)));
}

TEST_F(ImportRobotTest, MoreSitesThanARobotHasAreLeftOut) {
  std::string text =
      "<mujoco><worldbody><body name=\"b\" pos=\"0 0 1\"><freejoint/>"
      "<geom type=\"sphere\" size=\".1\" mass=\"1\"/>";
  for (size_t i = 0; i <= robot::kMostSites; ++i)
    text += "<site name=\"s" + std::to_string(i) + "\"/>";
  const ImportedRobot imported = Import(text + "</body></worldbody></mujoco>", "model.xml");
  EXPECT_THAT(imported.warnings, Contains(HasSubstr("250 sites are the most: `s250`")));
  EXPECT_EQ(robot::ReadRobot(imported.file).sites.size(), robot::kMostSites);
}

// Some files give the base its shape, and its mass to a frame that is fixed to it.
TEST_F(ImportRobotTest, ShapesOfAUrdfFileWeighNothing) {
  const robot::RobotDescription robot = Read(
      "<robot name=\"a\"><link name=\"base\"><collision><geometry>" + kBox +
      "</geometry></collision></link><link name=\"load\"><inertial><mass value=\"3\"/><inertia "
      "ixx=\"0.01\" iyy=\"0.01\" izz=\"0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>"
      "</link><joint name=\"j\" type=\"fixed\"><parent link=\"base\"/><child "
      "link=\"load\"/></joint></robot>");
  ASSERT_EQ(robot.links.size(), 1u);
  EXPECT_NEAR(robot.links[0].mass, 3, 1e-6);
}

// Two links of 1 kg and 0.5 kg, the second 0.2 m below its joint.
std::string WithEffort(const std::string& effort) {
  std::string leg = Link("leg", kBox, 0.5);
  leg.insert(leg.find("<mass"), "<origin xyz=\"0 0 -0.2\"/>");
  return "<robot name=\"a\">" + Link("body", kBox) + leg +
         "<joint name=\"hip\" type=\"revolute\"><parent link=\"body\"/><child link=\"leg\"/>"
         "<origin xyz=\"0 0 -0.2\"/><axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\" "
         "velocity=\"9\" effort=\"" +
         effort + "\"/></joint></robot>";
}

double TorqueOf(const ImportedRobot& imported) {
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  return robot.GainsOf(robot.joints[0]).max_torque;
}

// It holds up 1000 N m / (1.5 kg * 9.8 m/s^2 * 0.2 m) = 340 such robots.
TEST_F(ImportRobotTest, ATorqueThatNoMotorHasIsReplaced) {
  const ImportedRobot imported = Import(WithEffort("1000"));
  const auto said = HasSubstr("as strong as the file has those of `hip`, which could hold up");
  EXPECT_THAT(imported.warnings, Contains(said));
  EXPECT_NEAR(TorqueOf(imported), 1.47, 1e-9);
  const ImportedRobot strong = Import(WithEffort("14"));  // 4.8 of them
  EXPECT_THAT(strong.warnings, Not(Contains(said)));
  EXPECT_EQ(TorqueOf(strong), 14);
}

TEST_F(ImportRobotTest, AMeshThatIsNotThereIsABoxWithTheLinksInertia) {
  const ImportedRobot imported =
      Import("<robot name=\"a\">\n" +
             Link("body", "<mesh filename=\"package://a/meshes/body.stl\"/>", 12) + "</robot>");
  EXPECT_THAT(imported.warnings,
              Contains(AllOf(HasSubstr("model.urdf:2: "),
                             HasSubstr("the mesh package://a/meshes/body.stl is not there"))));
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  const robot::Vector3& size = robot.links[0].shape.size;
  // m / 12 (b^2 + c^2) = 0.01, ...
  std::vector<double> squares = {size[0] * size[0], size[1] * size[1], size[2] * size[2]};
  std::ranges::sort(squares);
  EXPECT_NEAR(squares[0], 0.004, 1e-4);
  EXPECT_NEAR(squares[1], 0.006, 1e-4);
  EXPECT_NEAR(squares[2], 0.008, 1e-4);
}

TEST_F(ImportRobotTest, WhatMuJoCoDoesNotKnowIsLeftOutAndNamed) {
  const ImportedRobot imported = Import(
      "<mujoco>\n<option integrator=\"implicitfast\"/>\n<worldbody>\n<body name=\"b\" pos=\"0 0 "
      "1\">"
      "<freejoint/>\n<geom type=\"box\" size=\".1 .1 .1\" mass=\"1\" shade=\"3\"/>\n"
      "<flavor sweet=\"1\"><inner/></flavor></body></worldbody></mujoco>",
      "model.xml");
  EXPECT_THAT(imported.warnings,
              AllOf(Contains(HasSubstr("model.xml:2: `implicitfast` of `option` is left out")),
                    Contains(HasSubstr("model.xml:5: `shade` of `geom` is left out")),
                    Contains(HasSubstr("model.xml:6: `flavor` is left out"))));
  EXPECT_EQ(robot::ReadRobot(imported.file).links[0].mass, 1);
}

constexpr const char* kPlanar = R"(<mujoco>
<compiler angle="degree"/>
<default><geom friction="0.7"/></default>
<worldbody>
  <geom type="plane" size="1 1 1"/>
  <body name="torso" pos="0 0 1">
    <joint name="rootx" type="slide" axis="1 0 0"/>
    <joint name="rootz" type="slide" axis="0 0 1"/>
    <joint name="rooty" type="hinge" axis="0 1 0"/>
    <geom type="capsule" fromto="0 0 -.2 0 0 .2" size=".05" mass="2"/>
    <geom type="sphere" pos="0 0 .3" size=".04" mass="0.1"/>
    <body name="leg" pos="0 0 -.2">
      <joint name="knee" type="hinge" axis="0 -1 0" range="-90 10" armature="0.3" ref="0"/>
      <geom type="capsule" fromto="0 0 0 0 0 -.4" size=".04" mass="1"/>
    </body>
  </body>
</worldbody>
<actuator><motor joint="knee" gear="40" ctrlrange="-1 1"/></actuator>
<keyframe><key qpos="0 0.1 0 -0.5"/></keyframe>
</mujoco>)";

TEST_F(ImportRobotTest, SeveralJointsOfABodyAreAChainOfLinks) {
  const ImportedRobot imported = Import(kPlanar, "planar.xml");
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  EXPECT_TRUE(robot.has_fixed_base);
  EXPECT_EQ(robot.links[0].name, "world");
  ASSERT_EQ(robot.joints.size(), 4u);
  const int torso = *robot.FindLink("torso");
  EXPECT_EQ(robot.joints[0].parent, 0);
  EXPECT_EQ(robot.joints[1].parent, robot.joints[0].child);
  EXPECT_EQ(robot.joints[2].child, torso);
  EXPECT_EQ(robot.GainsOf(robot.joints[0]).max_torque, 0);
  const robot::Joint& knee = robot.joints[3];
  EXPECT_NEAR(knee.low, -std::numbers::pi / 2, 1e-5);
  EXPECT_EQ(knee.passive.armature, 0.3);
  EXPECT_NEAR(robot.GainsOf(knee).max_torque, 40, 1e-9);
  // All of the mass is there, and where it was.
  double mass = -1;  // of what stands for the world
  double height = 0;
  for (const robot::Link& link : robot.links) mass += link.mass;
  for (size_t i = 1; i < robot.links.size(); ++i)
    height += robot.links[i].mass * robot.links[i].position[2] / mass;
  EXPECT_NEAR(mass, 3.1, 1e-5);
  EXPECT_NEAR(height, (0.1 * 0.3 - 1 * 0.4) / 3.1, 1e-5);
  EXPECT_NEAR(robot.poses[0].joint_angles[3], -0.5, 1e-6);
  EXPECT_NEAR(robot.poses[0].joint_angles[1], 0.1, 1e-6);
  EXPECT_NEAR(robot.links[torso].friction, 0.7, 1e-9);
}

TEST_F(ImportRobotTest, ALeggedRobotStandsWhereItsFeetAre) {
  std::string text = "<robot name=\"table\">\n" + Link("top", "<box size=\"0.4 0.4 0.05\"/>", 4);
  for (const char* leg : {"fl", "fr", "rl", "rr"}) {
    const std::string name = leg;
    text += Link(name + "_leg", "<cylinder radius=\"0.02\" length=\"0.3\"/>", 0.5);
    text += "<joint name=\"" + name +
            "_hip\" type=\"revolute\"><axis xyz=\"1 0 0\"/><limit "
            "lower=\"-1\" upper=\"1\" effort=\"20\" velocity=\"10\"/><parent link=\"top\"/><child "
            "link=\"" +
            name + "_leg\"/><origin xyz=\"" + (name[0] == 'f' ? "0.15 " : "-0.15 ") +
            (name[1] == 'l' ? "0.15" : "-0.15") + " -0.18\"/></joint>\n";
  }
  const ImportedRobot imported = Import(text + "</robot>");
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  const robot::Pose& pose = robot.poses[0];
  EXPECT_NEAR(pose.position[2], 0.18 + 0.15, 1e-5);
  EXPECT_TRUE(HoldPose(robot, FindProfile("fast-tree"), pose).Stands());
  ASSERT_EQ(robot.link_groups.size(), 1u);
  EXPECT_EQ(robot.link_groups[0].members.size(), 4u);
  // Left and right turn about the same axis: a symmetric posture has opposite angles.
  const robot::DofConfiguration* symmetric = robot.FindDof("symmetric");
  ASSERT_NE(symmetric, nullptr);
  EXPECT_EQ(symmetric->dof(), 2);
  EXPECT_EQ(symmetric->couplings[1].factor, -1);
}

// Four legs of 0.3 m that lean so far back that the weight is in front of all feet.
std::string LeaningTable() {
  std::string trunk = Link("trunk", "<box size=\"0.4 0.2 0.1\"/>", 2);
  trunk.insert(trunk.find("<mass"), "<origin xyz=\"0.01 0.02 0\"/>");
  std::string text = "<robot name=\"table\">" + trunk;
  for (const std::string x : {"0.2", "-0.2"}) {
    for (const std::string y : {"0.1", "-0.1"}) {
      const std::string leg =
          (x[0] == '-' ? "rear_" : "front_") + std::string(y[0] == '-' ? "right" : "left");
      std::string link = Link(leg + "_leg", "<cylinder radius=\"0.02\" length=\"0.3\"/>", 0.2);
      for (const char* part : {"<mass", "<geometry"})
        link.insert(link.find(part), "<origin xyz=\"0 0 -0.15\"/>");
      text += link + "<joint name=\"" + leg + "_hip\" type=\"revolute\"><parent link=\"trunk\"/>" +
              "<child link=\"" + leg + "_leg\"/><origin xyz=\"" + x + " " + y +
              " -0.05\" rpy=\"0 0.8 0\"/><axis xyz=\"0 1 0\"/>" +
              "<limit lower=\"-1.2\" upper=\"1.2\" effort=\"10\" velocity=\"9\"/></joint>";
    }
  }
  return text + "</robot>";
}

TEST_F(ImportRobotTest, ARobotThatFallsGetsAPoseInWhichItStands) {
  const ImportedRobot imported = Import(LeaningTable());
  EXPECT_THAT(imported.warnings,
              Contains(HasSubstr("does not stand with the angles of the file: the start pose")));
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  const robot::Pose& pose = robot.poses.front();
  EXPECT_TRUE(HoldPose(robot, FindProfile("fast-tree"), pose).Stands());
  EXPECT_GT(pose.position[2], 0.3);  // on its legs
  EXPECT_EQ(pose.position[0], 0);
  EXPECT_EQ(pose.position[1], 0);
  const auto angle = [&](const char* joint) {
    return pose.joint_angles[static_cast<size_t>(robot.FindJoint(joint).value())];
  };
  EXPECT_EQ(angle("front_left_hip"), angle("front_right_hip"));
  EXPECT_EQ(angle("rear_left_hip"), angle("rear_right_hip"));
  const ImportedRobot again = Import(LeaningTable());
  EXPECT_EQ(robot::ReadRobot(again.file).poses.front().joint_angles, pose.joint_angles);
}

TEST_F(ImportRobotTest, IncludesAreRead) {
  std::ofstream(folder_.path() / "leg.xml") << "<mujocoinclude><body name=\"leg\"><joint "
                                               "name=\"j\" axis=\"0 1 0\"/><geom type=\"sphere\" "
                                               "size=\".1\" mass=\"1\"/></body></mujocoinclude>";
  const robot::RobotDescription robot = Read(
      "<mujoco><worldbody><body name=\"b\"><freejoint/><geom type=\"sphere\" size=\".2\" "
      "mass=\"1\"/><include file=\"leg.xml\"/></body></worldbody></mujoco>",
      "model.xml");
  EXPECT_TRUE(robot.FindLink("leg").has_value());
  EXPECT_THAT(ErrorOf("<mujoco><include file=\"self.xml\"/></mujoco>", "self.xml"),
              HasSubstr("does one include itself?"));
}

TEST_F(ImportRobotTest, SaysWhatIsWrongWithAFile) {
  EXPECT_THAT(ErrorOf("<sdf/>"), HasSubstr("its first element is `sdf`"));
  EXPECT_THAT(ErrorOf(""), HasSubstr("its first element is ``"));
  EXPECT_THAT(ErrorOf("<robot name=\"a\"></robot>"), HasSubstr("no body"));
  EXPECT_THAT(ErrorOf("<robot name=\"a\"><link name=\"b\">"),
              HasSubstr("MuJoCo cannot make a model"));
  const std::string two = Link("b", kBox) + Link("c", kBox);
  const std::string joint =
      "<joint name=\"j\" type=\"fixed\"><parent link=\"b\"/><child link=\"c\"/></joint>";
  const std::string back =
      "<joint name=\"k\" type=\"fixed\"><parent link=\"c\"/><child link=\"b\"/></joint>";
  EXPECT_NE(ErrorOf("<robot name=\"a\">" + two + joint + back + "</robot>"), "");  // a loop
  EXPECT_NE(ErrorOf("<robot name=\"a\">" + two +
                    "<joint name=\"j\" type=\"fixed\"><parent "
                    "link=\"nobody\"/><child link=\"c\"/></joint></robot>"),
            "");
  EXPECT_THROW(ImportRobot({.file = "/nowhere/robot.urdf", .folder = folder_.path()}), UserError);
}

TEST_F(ImportRobotTest, NumbersThatNoRobotHasAreRefused) {
  EXPECT_THAT(
      ErrorOf(TwoLinks("type=\"continuous\"><axis xyz=\"1 0 0\"/><dynamics damping=\"inf\"/>")),
      AllOf(HasSubstr("model.urdf: what it describes "), HasSubstr("not")));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "robots" / "robot1" / "robot.toml"));
}

TEST_F(ImportRobotTest, DoesNotWriteOverARobot) {
  const std::string text = "<robot name=\"a\">" + Link("b", kBox) + "</robot>";
  std::ofstream(folder_.path() / "a.urdf") << text;
  const ImportOptions options = {.file = folder_.path() / "a.urdf", .folder = folder_.path()};
  EXPECT_EQ(ImportRobot(options).name, "a");
  EXPECT_THROW(ImportRobot(options), UserError);
}

TEST_F(ImportRobotTest, NamesOfTheLanguageAndNegativeInertiasAreMadeUsable) {
  const ImportedRobot imported = Import(
      "<robot name=\"a\"><link name=\"if\"><inertial><mass value=\"1\"/><inertia ixx=\"0.01\" "
      "iyy=\"0.01\" izz=\"-0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial><collision><geometry>" +
      kBox + "</geometry></collision></link></robot>");
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  EXPECT_EQ(robot.links[0].name, "if_");
  EXPECT_THAT(
      imported.warnings,
      Contains(HasSubstr("links whose names tasks cannot write have others: `if` as `if_`")));
  EXPECT_GT(robot.links[0].inertia->zz, 0);
}

}  // namespace
}  // namespace runtime
