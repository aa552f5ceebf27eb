// Every mistake in a description, with the message that its author sees.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "plugins/robot/robot_description.h"

namespace robot {
namespace {

// One edit of the hopper's description and what reading it says, without the file's name.
struct Mistake {
  const char* name;
  const char* correct;
  const char* wrong;
  const char* message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

std::string HopperText() {
  std::ifstream file(ROBOTS "/hopper/robot.toml");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// What ReadRobot() says to a file with this text.
std::string MessageFor(const std::string& text) {
  // Tests run side by side.
  std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::replace(test.begin(), test.end(), '/', '_');
  const std::string file = testing::TempDir() + "description_error_" + test + ".toml";
  std::ofstream(file) << text;
  std::string message = "no error";
  try {
    ReadRobot(file);
  } catch (const DescriptionError& error) {
    message = error.what();
    EXPECT_TRUE(message.starts_with(file + ":")) << message;
    message = message.substr(file.size() + 1);
  }
  std::filesystem::remove(file);
  return message;
}

class DescriptionErrorTest : public testing::TestWithParam<Mistake> {};

TEST_P(DescriptionErrorTest, NamesPlaceAndRemedy) {
  const Mistake& mistake = GetParam();
  std::string text = HopperText();
  const size_t place = text.find(mistake.correct);
  ASSERT_NE(place, std::string::npos) << "the hopper's description has changed";
  text.replace(place, std::string(mistake.correct).size(), mistake.wrong);
  EXPECT_EQ(MessageFor(text), mistake.message);
}

const Mistake kMistakes[] = {
    {"NotToml", "name = \"hopper\"", "name = ",
     "3:8: error: Error while parsing key-value pair: expected value, saw '\\n"
     "'\n  help: the file is written in TOML 1.0, see https://toml.io"},
    {"UnknownPart", "[link_groups]", "[link_group]",
     "29:2: error: unknown key `link_group` in the robot\n"
     "  help: did you mean `link_groups`?"},
    {"MissingPart", "doc = \"A body on one leg with a hip and a knee.\"", "",
     "1:1: error: the robot has no `doc`\n"
     "  help: add `doc`"},
    {"WrongType", "name = \"hopper\"", "name = 3",
     "3:8: error: `name` of the robot is not a string in quotes\n"
     "  help: write a string in quotes"},
    {"UnusableName", "name = \"hopper\"", "name = \"the hopper\"",
     "3:8: error: `the hopper` cannot be used as a name in a task\n"
     "  help: use letters, digits and underscores, and do not begin with a digit"},
    {"NameOfTheLanguage", "name = \"trunk\"", "name = \"if\"",
     "7:12: error: `if` is a word of the task language and cannot be used as a name in a task\n"
     "  help: call it otherwise, for example `if_`"},
    {"LinksAreNoArray", "links = [\n", "links = \"none\"\nlonks = [\n",
     "7:1: error: unknown key `lonks` in the robot\n"
     "  help: did you mean `links`?"},
    {"UnknownKeyOfALink", "mass = 0.2", "masss = 0.2",
     "8:82: error: unknown key `masss` in link `thigh`\n"
     "  help: did you mean `mass`?"},
    {"KeyOfAnotherShape", "radius = 0.03", "radius = 0.03, size = [1, 1, 1]",
     "9:54: error: unknown key `size` in link `shank`\n"
     "  help: choose from `name`, `shape`, `mass`, `position`, `shape_position`, "
     "`shape_orientation`, `inertia`, `friction` and `radius`"},
    {"UnknownShape", "shape = \"box\"", "shape = \"cube\"",
     "7:29: error: there is no shape `cube`\n"
     "  help: choose from `box`, `capsule`, `cylinder`, `sphere` and `convex`"},
    {"ConvexWithoutInertia", "shape = \"box\", size = [0.1, 0.2, 0.1]",
     "shape = \"convex\", points = [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]",
     "7:3: error: link `trunk` is convex, and its inertia is missing\n"
     "  help: add `inertia`, about the center of mass; `trainer robot hull` computes it"},
    {"FlatConvex", "shape = \"box\", size = [0.1, 0.2, 0.1]",
     "shape = \"convex\", points = [[0,0,0], [1,0,0], [0,1,0], [1,1,0]]",
     "7:48: error: `points` of link `trunk` enclose no space\n"
     "  help: give the corners of a body, at least four that do not lie in one plane"},
    {"NoMass", "mass = 0.2, ", "",
     "8:3: error: link `thigh` has no `mass`\n"
     "  help: add `mass`"},
    {"MassIsZero", "mass = 0.2", "mass = 0",
     "8:89: error: `mass` of link `thigh` is not positive\n"
     "  help: give a number above 0"},
    {"MassIsNotFinite", "mass = 0.2", "mass = inf",
     "8:89: error: `mass` of link `thigh` is not finite\n"
     "  help: give a finite number"},
    {"MassIsText", "mass = 0.2", "mass = \"0.2\"",
     "8:89: error: `mass` of link `thigh` is not a number\n"
     "  help: write a number"},
    {"SizeOfABoxIsNegative", "size = [0.1, 0.2, 0.1]", "size = [0.1, -0.2, 0.1]",
     "7:49: error: item 2 of `size` of link `trunk` is not positive\n"
     "  help: give a number above 0"},
    {"WrongVectorLength", "position = [0, 0, -0.1]", "position = [0, -0.1]",
     "8:105: error: `position` of link `thigh` has 2 numbers instead of 3\n"
     "  help: give exactly 3"},
    {"CapsuleShorterThanItsCaps", "length = 0.14", "length = 0.04",
     "8:76: error: `length` of link `thigh` does not exceed its two caps\n"
     "  help: give the total length, more than twice the radius, or make it a sphere"},
    {"TwoLinksOfOneName", "name = \"shank\"", "name = \"thigh\"",
     "9:12: error: a second link is called `thigh`\n"
     "  help: rename one of the two"},
    {"BaseIsNotAtTheOrigin", "mass = 1, position = [0, 0, 0]", "mass = 1, position = [0, 0, 1]",
     "7:81: error: the base link `trunk` is not at the origin\n"
     "  help: give all positions relative to the center of the first link"},
    {"UnknownLinkInAJoint", "child = \"shank\"", "child = \"shanc\"",
     "14:46: error: there is no link `shanc`\n"
     "  help: did you mean `shank`?"},
    {"LowStopAboveHighStop", "[-90, 90]", "[90, -90]",
     "13:102: error: `stops_deg` of joint `hip`: the low stop is not below the high stop\n"
     "  help: write [low, high]"},
    {"UnknownTypeOfAJoint", "name = \"hip\"", "name = \"hip\", type = \"prismatic\"",
     "13:26: error: there is no type of joint `prismatic`\n"
     "  help: choose from `hinge`, `continuous`, `slider`, `fixed` and `ball`"},
    {"StopsOfAContinuousJoint", "name = \"hip\"", "name = \"hip\", type = \"continuous\"",
     "13:111: error: unknown key `stops_deg` in joint `hip`\n"
     "  help: choose from `name`, `type`, `parent`, `child`, `axis`, `stiffness`, `damping`, "
     "`max_torque`, `max_speed`, `passive`, `spring`, `spring_rest`, `damper`, `friction`, "
     "`armature` and `anchor`"},
    {"SliderWithoutTravel",
     "name = \"hip\", parent = \"trunk\", child = \"thigh\", axis = \"y\", "
     "anchor = [0, 0, -0.05], stops_deg = [-90, 90]",
     "name = \"hip\", parent = \"trunk\", child = \"thigh\", axis = \"y\", type = \"slider\"",
     "13:3: error: joint `hip` has no `travel`\n"
     "  help: add `travel`"},
    {"NegativeArmature", "name = \"hip\"", "name = \"hip\", armature = -1",
     "13:30: error: `armature` of joint `hip` is negative\n"
     "  help: give 0 or more"},
    {"MotorOfAPassiveJoint", "name = \"hip\"", "name = \"hip\", passive = true, stiffness = 1",
     "13:47: error: `stiffness` of joint `hip` is of a motor, and a passive joint has none\n"
     "  help: leave out `passive`, or this"},
    {"NegativeInertia", "mass = 1, position", "mass = 1, inertia = [1, 1, -1], position",
     "7:80: error: `inertia` of link `trunk` is that of no body\n"
     "  help: moments of inertia are positive, and none exceeds the other two together: write "
     "[xx, yy, zz] or [xx, yy, zz, xy, xz, yz] in kg m^2"},
    {"InertiaThatNoBodyHas", "mass = 1, position", "mass = 1, inertia = [1, 1, 2.1], position",
     "7:80: error: `inertia` of link `trunk` is that of no body\n"
     "  help: moments of inertia are positive, and none exceeds the other two together: write "
     "[xx, yy, zz] or [xx, yy, zz, xy, xz, yz] in kg m^2"},
    {"ShapeBesideTheCenterOfMass", "mass = 1, position",
     "mass = 1, shape_position = [1, 0, 0], position",
     "7:87: error: the shape of link `trunk` is not around its center of mass, so that its inertia "
     "is not known\n"
     "  help: add `inertia`, about the center of mass"},
    {"ExclusionOfNoLink", "name = \"hopper\"",
     "name = \"hopper\"\ncontact_exclusions = [[\"trunk\", \"foot\"]]",
     "4:33: error: there is no link `foot`\n"
     "  help: choose from `trunk`, `thigh` and `shank`"},
    {"UnknownBase", "name = \"hopper\"", "name = \"hopper\"\nbase = \"floating\"",
     "4:8: error: there is no kind of base `floating`\n"
     "  help: choose from `free` and `fixed`"},
    {"AxisWithoutDirection", "axis = [0, 2, 0]", "axis = [0, 0, 0]",
     "14:62: error: `axis` of joint `knee` has no direction\n"
     "  help: give \"x\", \"y\" or \"z\""},
    {"UnknownAxis", "\"hip\", parent = \"trunk\", child = \"thigh\", axis = \"y\"",
     "\"hip\", parent = \"trunk\", child = \"thigh\", axis = \"w\"",
     "13:61: error: there is no axis `w`\n"
     "  help: choose from `x`, `y` and `z`"},
    {"TwoJointsOfOneName", "name = \"knee\"", "name = \"hip\"",
     "14:12: error: a second joint is called `hip`\n"
     "  help: rename one of the two"},
    {"CyclicTree", "parent = \"trunk\", child = \"thigh\"", "parent = \"shank\", child = \"thigh\"",
     "13:3: error: joint `hip` hangs on `shank`, which no joint above attaches\n"
     "  help: the joints form a tree: list them from the base outward, without a cycle"},
    {"JointAboveTheBase", "parent = \"thigh\", child = \"shank\"",
     "parent = \"thigh\", child = \"trunk\"",
     "14:3: error: joint `knee` hangs the base link `trunk` on another link\n"
     "  help: swap `parent` and `child`, or list another link first"},
    {"LinkAttachedTwice", "parent = \"thigh\", child = \"shank\"",
     "parent = \"trunk\", child = \"thigh\"",
     "14:3: error: joint `knee` attaches `thigh`, which another joint already attaches\n"
     "  help: the joints form a tree: let each link be the child of one joint"},
    {"LooseLink", "links = [\n",
     "links = [\n  { name = \"base\", shape = \"sphere\", radius = 1, mass = 1, position = [0, 0, "
     "0] },\n",
     "14:3: error: joint `hip` hangs on `trunk`, which no joint above attaches\n"
     "  help: the joints form a tree: list them from the base outward, without a cycle"},
    {"LinkWithoutAJoint", "position = [0, 0, -0.2] },\n",
     "position = [0, 0, -0.2] },\n  { name = \"tail\", shape = \"sphere\", radius = 1, mass = 1, "
     "position = [0, 0, 0] },\n",
     "13:10: error: no joint attaches the link `tail`\n"
     "  help: add a joint with it as `child`"},
    {"ControllerWithoutDamping", "damping = 0.5, ", "",
     "17:14: error: `controller` has no `damping`\n"
     "  help: add `damping`"},
    {"NegativeStiffness", "stiffness = 20", "stiffness = -20",
     "17:28: error: `stiffness` of `controller` is not positive\n"
     "  help: give a number above 0"},
    {"UnknownJointInAPose", "knee = -1.5", "kneee = -1.5",
     "27:12: error: there is no joint `kneee`\n"
     "  help: did you mean `knee`?"},
    {"PoseBeyondAStop", "knee = -1.5", "knee = 1.5",
     "27:12: error: pose `bent` turns joint `knee` beyond its stops\n"
     "  help: give an angle in rad from -2.0944 to 0.0087"},
    {"NotAUnitQuaternion", "[0.5, 0.5, 0.5, 0.5]", "[1, 1, 0, 0]",
     "26:15: error: `orientation` of pose `bent` is not a unit quaternion\n"
     "  help: give w, x, y, z with a norm of 1"},
    {"TwoPosesOfOneName", "name = \"bent\"", "name = \"upright\"",
     "24:8: error: a second pose is called `upright`\n"
     "  help: rename one of the two"},
    {"UnknownMemberOfAGroup", "leg = [\"shank\"", "leg = [\"shenk\"",
     "30:8: error: there is no link `shenk`\n"
     "  help: did you mean `shank`?"},
    {"GroupNamedLikeALink", "leg = [", "shank = [",
     "30:1: error: group `shank` has the name of a link\n"
     "  help: rename the group"},
    {"GroupNamedLikeAllLinks", "leg = [", "links = [",
     "30:1: error: group `links` has the name of the group of all links\n"
     "  help: rename the group"},
    {"GroupNamesOneBelow", "leg = [\"shank\"", "leg = [\"all\"",
     "30:8: error: there is no link `all`\n"
     "  help: choose from `trunk`, `thigh` and `shank`"},
    {"EmptyGroup", "leg = [\"shank\", \"thigh\"]", "leg = []",
     "30:1: error: group `leg` is empty\n"
     "  help: add a member"},
    {"GroupWithAnUnusableName", "leg = [", "\"1st\" = [",
     "30:1: error: `1st` cannot be used as a name in a task\n"
     "  help: use letters, digits and underscores, and do not begin with a digit"},
    {"UnknownJointInACoordinate", "joint = \"hip\"", "joint = \"hop\"",
     "35:26: error: there is no joint `hop`\n"
     "  help: did you mean `hip`?"},
    {"UnknownFollower", "also = { knee", "also = { nee",
     "35:42: error: there is no joint `nee`\n"
     "  help: did you mean `knee`?"},
    {"JointDrivenTwice", "also = { knee", "also = { hip",
     "35:42: error: joint `hip` is driven twice in DoF configuration `1`\n"
     "  help: let each joint follow one coordinate"},
    {"FactorIsText", "knee = -2", "knee = \"-2\"",
     "35:42: error: `knee` of `also` of item 1 of `coordinates` of DoF configuration `1` is not a "
     "number\n"
     "  help: write a number"},
    {"NoCoordinates", "[{ joint = \"hip\", also = { knee = -2 } }]", "[]",
     "35:15: error: `coordinates` of DoF configuration `1` are missing\n"
     "  help: add at least one"},
    {"UnknownDofOfANet", "dof = \"1\"", "dof = \"one\"",
     "39:7: error: there is no DoF configuration `one`\n"
     "  help: choose from `1`"},
    {"UnknownKindOfNet", "kind = \"grid\"", "kind = \"gird\"",
     "40:8: error: there is no kind `gird`\n"
     "  help: did you mean `grid`?"},
    {"TooManyCounts", "counts = [3]", "counts = [3, 3]",
     "41:10: error: `counts` of net `g3` has 2 numbers instead of 1\n"
     "  help: give exactly 1"},
    {"CountIsZero", "counts = [3]", "counts = [0]",
     "41:11: error: item 1 of `counts` of net `g3` is out of range\n"
     "  help: give 1 to 1000000"},
    {"CountsAreHuge", "counts = [3]", "counts = [1000000]",
     "41:10: error: `counts` of net `g3` make 1000000 basis functions\n"
     "  help: a net has at most 100000"},
    {"UnitsAreHuge", "kind = \"grid\"\ncounts = [3]", "kind = \"bubble\"\nunits = 500000",
     "41:9: error: `units` of net `g3` make 500000 basis functions\n"
     "  help: a net has at most 100000"},
    {"CountIsFractional", "counts = [3]", "counts = [2.5]",
     "41:11: error: item 1 of `counts` of net `g3` is not an integer\n"
     "  help: write an integer"},
    {"GridWithUnits", "counts = [3]", "units = 3",
     "41:1: error: unknown key `units` in net `g3`\n"
     "  help: choose from `name`, `dof`, `kind`, `counts`, `low`, `high` and `deviations`"},
    {"DeviationIsZero", "counts = [3]", "counts = [3]\ndeviations = [0]",
     "42:15: error: item 1 of `deviations` of net `g3` is not positive\n"
     "  help: give a number above 0"},
    {"NetUpsideDown", "high = [1]", "high = [-1]",
     "43:9: error: `high` of net `g3` is not above its `low`\n"
     "  help: give one `low` and one greater `high` for each coordinate"},

    {"SiteOfNoLink", "controller =",
     "sites = [{ name = \"tip\", link = \"shnk\", position = [0, 0, 0] }]\ncontroller =",
     "17:33: error: there is no link `shnk`\n"
     "  help: did you mean `shank`?"},
    {"TwoSitesOfOneName", "controller =",
     "sites = [{ name = \"tip\", link = \"shank\", position = [0, 0, 0] }, { name = \"tip\", link "
     "= \"thigh\", position = [0, 0, 0] }]\ncontroller =",
     "17:75: error: a second site is called `tip`\n"
     "  help: rename one of the two"},
    {"SiteCalledAsAWord", "controller =",
     "sites = [{ name = \"task\", link = \"shank\", position = [0, 0, 0] }]\ncontroller =",
     "17:19: error: `task` is a word of the task language and cannot be used as a name in a task\n"
     "  help: call it otherwise, for example `task_`"},
    {"SiteWithoutAPlace",
     "controller =", "sites = [{ name = \"tip\", link = \"shank\" }]\ncontroller =",
     "17:10: error: site `tip` has no `position`\n"
     "  help: add `position`"},
    {"SiteTurnedByNoRotation", "controller =",
     "sites = [{ name = \"tip\", link = \"shank\", position = [0, 0, 0], orientation = [1, 1, 0, "
     "0] }]\ncontroller =",
     "17:78: error: `orientation` of site `tip` is not a unit quaternion\n"
     "  help: give w, x, y, z with a norm of 1"},
    {"UnknownKeyOfASite", "controller =",
     "sites = [{ name = \"tip\", link = \"shank\", positon = [0, 0, 0] }]\ncontroller =",
     "17:42: error: unknown key `positon` in item 1 of `sites` of the robot\n"
     "  help: did you mean `position`?"},

    {"NoSpeed", "max_torque = 3", "max_torque = 3, max_speed = 0",
     "17:75: error: `max_speed` of `controller` is not positive\n  help: give a number above 0"},
    {"RangeOfNoSensor", "\"joint.velocity\" =", "\"joint.velocty\" =",
     "47:1: error: `joint.velocty` is not a sensor whose range can be given\n"
     "  help: did you mean `joint.velocity`?"},
    {"RangeUpsideDown", "[-50, 50]", "[50, -50]",
     "47:1: error: the range of `joint.velocity`: the low end is not below the high end\n"
     "  help: write [low, high]"},
    {"TooFewRanges", "[-1, 1], [-5, 5]]", "[-5, 5]]",
     "46:1: error: the range of `base.velocity` has 2 pairs for 3 elements\n"
     "  help: write [low, high] once for all elements, or for each of them"},
    {"RangeWithoutHigh", "[-50, 50]", "[-50]",
     "47:1: error: the range of `joint.velocity` has 1 numbers instead of 2\n"
     "  help: give exactly 2"},
};

INSTANTIATE_TEST_SUITE_P(, DescriptionErrorTest, testing::ValuesIn(kMistakes),
                         [](const auto& instance) { return instance.param.name; });

TEST(DescriptionError, AFileThatIsNotThere) {
  try {
    ReadRobot("/nowhere/robot.toml");
    FAIL() << "no error";
  } catch (const DescriptionError& error) {
    EXPECT_STREQ(error.what(),
                 "/nowhere/robot.toml: error: cannot read the robot's description: No such file or "
                 "directory\n  help: check that the file is there and may be read");
  }
}

TEST(DescriptionError, ARobotWithAThousandLinks) {
  std::string text = "name = \"a\"\ndoc = \"b\"\nlinks = [\n";
  for (int i = 0; i < 1000; ++i) {
    text += "{ name = \"l" + std::to_string(i) +
            "\", shape = \"sphere\", radius = 1, mass = 1, position = [0, 0, 0] },\n";
  }
  EXPECT_EQ(MessageFor(text + "]\n"),
            "3:9: error: the robot has 1000 links, and 250 is the most\n"
            "  help: make one link of what does not move against each other");
}

TEST(DescriptionError, ARobotWithoutLinks) {
  EXPECT_EQ(MessageFor("name = \"a\"\ndoc = \"b\"\nlinks = []\n"),
            "3:9: error: the robot has no link\n  help: describe at least its base");
}

TEST(DescriptionError, ARobotWithoutPoses) {
  EXPECT_EQ(
      MessageFor("name = \"a\"\ndoc = \"b\"\n"
                 "links = [{ name = \"c\", shape = \"sphere\", radius = 1, mass = 1, "
                 "position = [0, 0, 0] }]\njoints = []\nposes = []\n"
                 "controller = { stiffness = 1, damping = 1, max_torque = 1, time_step = 1 }"),
      "5:9: error: the robot has no pose\n  help: describe the one that episodes start from");
}

}  // namespace
}  // namespace robot
