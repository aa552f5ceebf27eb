// Every mistake in a world file, with the message that its author sees.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "plugins/world/world_description.h"

namespace world {
namespace {

// One edit of the yard and what reading it says, without the file's name.
struct Mistake {
  const char* name;
  const char* correct;
  const char* wrong;
  const char* message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

std::string MessageFor(const std::string& text) {
  const auto read = [](const std::filesystem::path& file) -> std::optional<std::string> {
    if (file == "worlds/hills.csv") return "0,1\n1,x\n";
    if (file == "worlds/flat.csv") return "0,0\n0,0\n";
    if (file == "worlds/picture.pgm") return "P2\n2 2\n1\n0 1 1 0\n";
    return std::nullopt;
  };
  try {
    ReadWorld(text, "worlds/yard.toml", read);
  } catch (const robot::DescriptionError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("worlds/yard.toml:")) << message;
    return message.substr(std::string("worlds/yard.toml:").size());
  }
  return "no error";
}

std::string YardText() {
  std::ostringstream text;
  text << std::ifstream(WORLDS "/yard.toml").rdbuf();
  return text.str();
}

class WorldErrorTest : public testing::TestWithParam<Mistake> {};

TEST_P(WorldErrorTest, NamesPlaceAndRemedy) {
  const Mistake& mistake = GetParam();
  std::string text = YardText();
  const size_t place = text.find(mistake.correct);
  ASSERT_NE(place, std::string::npos);
  text.replace(place, std::string(mistake.correct).size(), mistake.wrong);
  EXPECT_EQ(MessageFor(text), mistake.message);
}

constexpr const char* kSlope =
    "kind = \"slope\"\nangle_deg = 10\ndirection_deg = 90\nfriction = 0.8\n";

INSTANTIATE_TEST_SUITE_P(
    , WorldErrorTest,
    testing::Values(
        Mistake{"NoToml", "[ground]", "[ground",
                "3:8: error: Error while parsing table header: expected ']', saw '\\n'\n"
                "  help: the file is written in TOML 1.0, see https://toml.io"},
        Mistake{"UnknownPart", "[ground]", "[grounds]",
                "3:2: error: unknown key `grounds` in the world\n  help: did you mean `ground`?"},
        Mistake{"UnknownGround", "\"slope\"", "\"slop\"",
                "4:8: error: there is no kind of ground `slop`\n  help: did you mean `slope`?"},
        Mistake{"KeyOfOtherGround", "angle_deg = 10", "depth = 10",
                "5:1: error: unknown key `depth` in `ground`\n  help: choose from `kind`, "
                "`friction`, `angle_deg` and `direction_deg`"},
        Mistake{"TooSteep", "= 10", "= 90",
                "5:13: error: a slope of 90 degrees\n  help: give 0 to 80; which way it rises is "
                "`direction_deg`"},
        Mistake{"NegativeFriction", "= 0.8", "= -1",
                "7:12: error: `friction` of `ground` is negative\n  help: give 0 or more"},
        Mistake{"NoSteps", kSlope, "kind = \"steps\"\nstart = 1\nheight = 0.1\ncount = 2\n",
                "3:1: error: `ground` has no `depth`\n  help: add `depth`"},
        Mistake{"ManySteps", kSlope,
                "kind = \"steps\"\nstart = 1\ndepth = 1\nheight = 0.1\ncount = 200\n",
                "8:9: error: 200 steps\n  help: give at most 100; the last step has no end"},
        Mistake{"NoMap", kSlope, "kind = \"heightmap\"\nfile = \"none.csv\"\nsize = [1, 1]\n",
                "5:8: error: there is no file `worlds/none.csv`\n  help: a path is relative to the "
                "folder of the world's file"},
        Mistake{"BadMap", kSlope, "kind = \"heightmap\"\nfile = \"hills.csv\"\nsize = [1, 1]\n",
                "5:8: error: `hills.csv` is no height map: line 2: `x` is not a number\n  help: it "
                "is a CSV file of heights in meters, or a PGM picture"},
        Mistake{"HeightOfNumbers", kSlope,
                "kind = \"heightmap\"\nfile = \"flat.csv\"\nsize = [1, 1]\nheight = 1\n",
                "7:10: error: a file of numbers says its heights itself\n  help: leave out "
                "`height`"},
        Mistake{"NoHeightOfPicture", kSlope,
                "kind = \"heightmap\"\nfile = \"picture.pgm\"\nsize = [1, 1]\n",
                "3:1: error: the height of what is white is not known\n  help: add `height`, in "
                "meters"},
        Mistake{"MapWithoutSize", kSlope, "kind = \"heightmap\"\nfile = \"flat.csv\"\n",
                "3:1: error: `ground` has no `size`\n  help: add `size`"},
        Mistake{"SecondName", "name = \"post\"", "name = \"ball\"",
                "18:8: error: a second thing is called `ball`\n  help: rename one of the two"},
        Mistake{"NoName", "name = \"ball\"", "name = \"a ball\"",
                "10:8: error: `a ball` cannot be used as a name in a task\n  help: use letters, "
                "digits and underscores, and do not begin with a digit"},
        Mistake{"NameOfASensor", "name = \"ball\"", "name = \"base\"",
                "10:8: error: a thing cannot be called `base`: sensors of robots are\n  help: call "
                "it otherwise, for example `the_base`"},
        Mistake{"UnknownShape", "\"sphere\"", "\"spher\"",
                "11:9: error: there is no shape `spher`\n  help: did you mean `sphere`?"},
        Mistake{"UnknownKey", "mass = 0.4", "weight = 0.4",
                "13:1: error: unknown key `weight` in thing `ball`\n  help: choose from `name`, "
                "`shape`, `mass`, `fixed`, `friction`, `position`, `orientation` and `radius`"},
        Mistake{"NoMass", "mass = 0.4\n", "",
                "9:1: error: thing `ball` has no `mass`\n  help: add `mass`"},
        Mistake{"MassOfAFixedOne", "fixed = true", "fixed = true\nmass = 1",
                "24:8: error: thing `post` is fixed and has no mass\n  help: leave out `mass`, or "
                "`fixed`"},
        Mistake{"FixedIsAFlag", "fixed = true", "fixed = 1",
                "23:9: error: `fixed` of thing `post` is not true or false\n  help: write true or "
                "false"},
        Mistake{"OneNumber", "position = [1, 0]", "position = [1]",
                "15:12: error: `position` of thing `ball` has 1 numbers\n  help: give [x, y] for a "
                "thing that stands on the ground, or [x, y, z] of its center"},
        Mistake{"FarAway", "[1, 0]", "[1, 1e4]",
                "15:16: error: `position` of thing `ball` is far away\n  help: give meters from "
                "-100 to 100"},
        Mistake{"NoTurn", "[1, 0, 0, 0]", "[1, 1, 0, 0]",
                "25:15: error: `orientation` of thing `post` is not a unit quaternion\n  help: "
                "give w, x, y, z with a norm of 1"}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace world
