#include "plugins/world/heightmap.h"

#include <gtest/gtest.h>

namespace world {
namespace {

using Values = std::vector<double>;

TEST(Heights, AreRowsOfNumbersTheLastOfWhichHasTheLeastY) {
  const HeightGrid grid = ParseHeights("0, 1, 2\n\n3,4,5.5\n");
  EXPECT_EQ(grid.problem, "");
  EXPECT_EQ(grid.columns, 3);
  EXPECT_EQ(grid.rows, 2);
  EXPECT_EQ(grid.white, 0);
  EXPECT_EQ(grid.values, (Values{3, 4, 5.5, 0, 1, 2}));
}

TEST(Heights, AreThoseOfAPicture) {
  const HeightGrid text = ParseHeights("P2\n# drawn by hand\n2 2\n4\n0 1\n2 4\n");
  EXPECT_EQ(text.problem, "");
  EXPECT_EQ(text.values, (Values{0.5, 1, 0, 0.25}));
  const HeightGrid bytes = ParseHeights(std::string("P5 2 2 255\n\x00\xff\x33\x00", 15));
  EXPECT_EQ(bytes.problem, "");
  EXPECT_EQ(bytes.values, (Values{0.2, 0, 0, 1}));
}

TEST(Heights, OfAPictureInBytesStayTheSameAsText) {
  const std::string picture("P5 2 2 1023\n\x00\x01\x02\x03\x01\xff\x03\xff", 20);
  const std::string text = TextOfHeights(picture);
  EXPECT_EQ(text, "P2\n2 2\n1023\n1 515\n511 1023\n");
  EXPECT_EQ(ParseHeights(text).values, ParseHeights(picture).values);
  EXPECT_EQ(TextOfHeights("1,2\n3,4\n"), "1,2\n3,4\n");
}

TEST(Heights, SayWhatIsWrong) {
  const auto problem = [](const std::string& bytes) { return ParseHeights(bytes).problem; };
  EXPECT_EQ(problem(""), "it needs at least 2 rows of 2 heights");
  EXPECT_EQ(problem("1,2\n"), "it needs at least 2 rows of 2 heights");
  EXPECT_EQ(problem("1,2\n3,x\n"), "line 2: `x` is not a number");
  EXPECT_EQ(problem("1,2\n\n3,\n"), "line 3: `` is not a number");
  EXPECT_EQ(problem("1,2\n3\n"), "line 2 has 1 heights, and the lines above have 2");
  EXPECT_EQ(problem("1,-2\n3,4\n"), "line 1: the height -2 is not between 0 and 1000 m");
  EXPECT_EQ(problem("1,nan\n3,4\n"), "line 1: the height nan is not between 0 and 1000 m");
  EXPECT_EQ(problem("P2\n2 2\n"), "the head of the picture is damaged");
  EXPECT_EQ(problem("P2\n2 2\n9\n1 2 3"), "the picture is cut off");
  EXPECT_EQ(problem("P2\n2 2\n9\n1 2 3 10"), "the picture has a pixel that is brighter than white");
  EXPECT_EQ(problem("P5 2 2 255\nabc"), "the picture is cut off");
  EXPECT_EQ(problem("P2 3000 2 1"), "it has 3000 x 2 heights, and 256 x 256 are the most");
}

}  // namespace
}  // namespace world
