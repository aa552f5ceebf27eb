// What is wrong with files of other programs: each is said with its line and what to do.
#include <gmock/gmock.h>

#include <filesystem>
#include <vector>

#include "tests/runtime/import/import_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

// What a line of a URDF file with these elements between two links of 1 kg is said to be.
struct Mistake {
  std::string joint;  // behind the name of the joint `hip`
  std::string said;
};

TEST_F(ImportRobotTest, MistakesInAUrdfFileAreSaidWithTheirLinesAndRemedies) {
  const std::string limit = "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
  const std::vector<Mistake> mistakes = {
      {"type=\"revolt\">", "the type of joint `hip` is `revolt`: write revolute"},
      {"type=\"revolute\"><axis xyz=\"0 0 0\"/>" + limit,
       "the axis of joint `hip` has no direction: write"},
      {"type=\"revolute\"><limit lower=\"nan\" upper=\"1\"/>",
       "`lower` of joint `hip` is `nan`: write a number"},
      {"type=\"revolute\"><limit lower=\"-1\" upper=\"1 rad\"/>",
       "`upper` of joint `hip` is `1 rad`: write a number"},
  };
  for (const auto& [joint, said] : mistakes) {
    EXPECT_THAT(ErrorOf(TwoLinks(joint)), HasSubstr("model.urdf:4: " + said)) << joint;
  }
}

TEST_F(ImportRobotTest, WhatAUrdfFileSaysOddlyIsTakenOverWithAWarning) {
  const std::vector<Mistake> mistakes = {
      {"type=\"revolute\"><axis xyz=\"0 1 0\"/><limit lower=\"-90\" upper=\"120\"/>",
       "joint `hip` turns from -90 to 120 rad, which are 19 turns: are these degrees? write rad"},
      {"type=\"revolute\"><axis xyz=\"0 1 0\"/><limit lower=\"1\" upper=\"-1\"/>",
       "the lower stop of joint `hip` is above the upper one: it gets none; exchange"},
      {"type=\"revolute\"><axis xyz=\"0 1 0\"/>",
       "joint `hip` has no `limit`: it is without stops; add"},
  };
  for (const auto& [joint, said] : mistakes) {
    EXPECT_THAT(Import(TwoLinks(joint)).warnings, Contains(HasSubstr("model.urdf:4: " + said)))
        << joint;
  }
  EXPECT_THAT(Import("<robot name=\"a\">\n" + Link("b", "<box size=\"200 300 100\"/>") + "</robot>")
                  .warnings,
              Contains(HasSubstr("model.urdf:2: a shape of link `b` is 300 m large")));
  EXPECT_THAT(Import("<robot name=\"a\">\n" + Link("b", kBox, -2) + "</robot>").warnings,
              AllOf(Contains(HasSubstr("model.urdf:2: the mass of link `b` is below 0")),
                    Contains(HasSubstr("without a mass, and so given 1 g: `b`"))));
  std::string text = "<robot name=\"a\">\n" + Link("b", kBox) + "</robot>";
  text.replace(text.find("0.012"), 5, "0");
  EXPECT_THAT(Import(text).warnings,
              Contains(HasSubstr("a moment of inertia of link `b` is not above 0: it gets")));
}

TEST_F(ImportRobotTest, TheEndOfAJointThatHasNotBegunIsMujocosToRefuse) {
  EXPECT_THAT(
      ErrorOf("<robot name=\"a\">\n" + Link("b", kBox) + "<joi nt name=\"j\"></joint></robot>"),
      HasSubstr("model.urdf: MuJoCo cannot make a model of it"));
}

TEST_F(ImportRobotTest, WhatIsNoTreeIsRefusedWithTheJointsThatAreTooMany) {
  const auto joint = [](const std::string& name, const std::string& parent,
                        const std::string& child) {
    return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/></joint>\n";
  };
  const auto error = [&](const std::string& joints) {
    return ErrorOf("<robot name=\"a\">\n" + Link("b", kBox) + Link("c", kBox) + joints +
                   "</robot>");
  };
  EXPECT_THAT(
      error(joint("j", "b", "c") + joint("k", "c", "b")),
      HasSubstr("model.urdf:4: joint `j` closes a loop, and links form a tree: leave it out"));
  EXPECT_THAT(error(joint("j", "b", "c") + joint("k", "b", "c")),
              HasSubstr("model.urdf:5: link `c` hangs on joint `j` of line 4 already"));
  EXPECT_THAT(
      error(joint("j", "b", "nobody")),
      HasSubstr("model.urdf:4: joint `j` joins `nobody`, and no link is called so: add it"));
  EXPECT_THAT(error(Link("b", kBox)),
              HasSubstr("model.urdf:4: there is a link `b` in line 2 already: rename"));
  EXPECT_THAT(error("<xacro:include filename=\"leg.xacro\"/>"),
              HasSubstr("model.urdf:4: `xacro:include` is no URDF: write the file as URDF first"));
}

TEST_F(ImportRobotTest, AMeshThatIsNoneIsNamedByItsPlace) {
  std::ofstream(folder_.path() / "body.stl") << "version https://example.org/large-files\n";
  EXPECT_THAT(
      ErrorOf("<robot name=\"a\">" + Link("b", "<mesh filename=\"body.stl\"/>") + "</robot>"),
      HasSubstr((folder_.path() / "body.stl").string()));
}

TEST_F(ImportRobotTest, AFileThatIsIncludedAndNotThereIsNamedWithThePlace) {
  EXPECT_THAT(ErrorOf("<mujoco>\n<include file=\"gone.xml\"/></mujoco>", "model.xml"),
              AllOf(HasSubstr("model.xml:2: cannot read "),
                    HasSubstr("gone.xml, which it includes: No such file")));
}

// Links of transmissions and of other programs' elements are none.
TEST_F(ImportRobotTest, WhatIsNoLinkOrJointOfTheRobotIsNotLookedAt) {
  const ImportedRobot imported =
      Import("<robot name=\"a\">" + Link("b", kBox) +
             "<transmission name=\"t\"><joint name=\"j\"><limit lower=\"nan\"/></joint>"
             "</transmission><gazebo><link name=\"b\"/></gazebo></robot>");
  EXPECT_EQ(robot::ReadRobot(imported.file).links.size(), 1u);
}

TEST_F(ImportRobotTest, MoreLinksThanARobotHasAreRefused) {
  std::string text = "<robot name=\"a\">" + Link("l0", kBox);
  for (int i = 1; i <= 250; ++i) {
    text += Link("l" + std::to_string(i), kBox) + "<joint name=\"j" + std::to_string(i) +
            "\" type=\"continuous\"><parent link=\"l0\"/><child link=\"l" + std::to_string(i) +
            "\"/><origin xyz=\"" + std::to_string(i) + " 0 0\"/></joint>";
  }
  EXPECT_THAT(ErrorOf(text + "</robot>"),
              AllOf(HasSubstr("model.urdf: what it describes is no robot: the robot has 251 links"),
                    HasSubstr("make one link of what does not move")));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "robots" / "robot1"));
}

TEST_F(ImportRobotTest, WhatIsSaidOfManyPlacesIsSaidOnce) {
  std::string text = "<mujoco>\n<worldbody>\n<body name=\"b\"><freejoint/>\n";
  for (int i = 0; i < 3; ++i) text += "<geom type=\"box\" size=\".1 .1 .1\" shade=\"3\"/>\n";
  const ImportedRobot imported = Import(text + "</body></worldbody></mujoco>", "model.xml");
  EXPECT_THAT(imported.warnings,
              Contains(testing::EndsWith("model.xml:4: `shade` of `geom` is left out: MuJoCo 2.2 "
                                         "does not know it (in 3 places)")));
}

TEST_F(ImportRobotTest, AJointsForceRangeOfLaterVersionsIsItsLargestTorque) {
  const ImportedRobot imported = Import(
      "<mujoco><worldbody><body name=\"b\"><freejoint/><geom size=\".1\"/><body name=\"c\" pos=\"0 "
      "0 "
      "-.3\"><joint name=\"j\" range=\"-90 90\" actuatorfrcrange=\"-7 7\"/><geom "
      "size=\".1\"/></body></body></worldbody><actuator><motor joint=\"j\" ctrlrange=\"-9 9\"/>"
      "</actuator></mujoco>",
      "model.xml");
  const robot::RobotDescription robot = robot::ReadRobot(imported.file);
  EXPECT_EQ(robot.GainsOf(robot.joints[0]).max_torque, 7);
}

// Its stack alone is more memory than it may have.
TEST_F(ImportRobotTest, AModelThatIsTooLargeIsRefused) {
  const std::string error = ErrorOf(
      "<mujoco><size nuser_body=\"300000000\"/><worldbody><body name=\"b\"><freejoint/><geom "
      "size=\".1\"/></body></worldbody></mujoco>",
      "model.xml");
  EXPECT_THAT(error,
              HasSubstr("needs more than 30 s or 2 GB for it: see whether a count or a size"));
}

}  // namespace
}  // namespace runtime
