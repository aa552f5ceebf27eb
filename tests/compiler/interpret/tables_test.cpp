// Tables against values computed by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "compiler/check/table_value.h"
#include "compiler/interpret/evaluator.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kForever = std::numeric_limits<double>::infinity();

// Of files in tests/compiler/check/tables.
CheckedTable Table(const std::string& type, const std::string& file) {
  const CheckedTask task =
      CheckTask("task tested for humanoid\ntable t: " + type + " = \"" + file + "\"\n");
  return task.tables.empty() ? CheckedTable{} : task.tables.front();
}

double At(const CheckedTable& table, double argument, bool repeats = false) {
  return ValueAt(table, argument, repeats).front();
}

// time [s], height [cm]: (0, 31), (0.25, 34), (0.5, 29.5), (1, 31)
TEST(Tables, GoStraightFromRowToRow) {
  const CheckedTable height = Table("real [m]", "height.csv");
  EXPECT_EQ(At(height, 0.25), 0.34);
  EXPECT_DOUBLE_EQ(At(height, 0.125), 0.325);
  EXPECT_DOUBLE_EQ(At(height, 0.75), 0.3025);
}

TEST(Tables, HoldTheirEnds) {
  const CheckedTable height = Table("real [m]", "height.csv");
  EXPECT_EQ(At(height, 0), 0.31);
  EXPECT_EQ(At(height, -3), 0.31);
  EXPECT_EQ(At(height, 1), 0.31);
  EXPECT_EQ(At(height, kForever), 0.31);
  EXPECT_EQ(At(height, -kForever), 0.31);
}

TEST(Tables, RepeatThemselvesInALoop) {
  const CheckedTable height = Table("real [m]", "height.csv");
  EXPECT_DOUBLE_EQ(At(height, 7.25, true), 0.34);
  EXPECT_DOUBLE_EQ(At(height, -0.75, true), 0.34);
  EXPECT_DOUBLE_EQ(At(height, 1.125, true), 0.325);
  // x, y: (-2, 1), (-1.5, 0.25), (0.1, 0.7), (0.3, -0.1), (1e3, 5)
  const CheckedTable curve = Table("real", "curve.csv");
  EXPECT_DOUBLE_EQ(At(curve, -1.5 + 2 * 1002, true), 0.25);
}

TEST(Tables, OfNoNumberAreNone) {
  const CheckedTable height = Table("real [m]", "height.csv");
  EXPECT_TRUE(std::isnan(At(height, kNone)));
  EXPECT_TRUE(std::isnan(At(height, kNone, true)));
  EXPECT_TRUE(std::isnan(At(height, kForever, true)));
}

TEST(Tables, FindTheirColumnsByName) {
  // time [ms], z [mm], x [mm], y [mm]
  const CheckedTable place = Table("vec3 [m]", "place.csv");
  EXPECT_THAT(place.arguments, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(ValueAt(place, 0.5, false), ElementsAre(0.12, 0.015, 0.312));
}

TEST(Tables, TakeTheShorterWayBetweenRotations) {
  // Of a half turn about z, written with both signs: w is the last column.
  const CheckedTable turn = Table("quat", "turn.csv");
  const double quarter = std::sqrt(0.5);
  EXPECT_THAT(ValueAt(turn, 1, false),
              ElementsAre(DoubleNear(quarter, 1e-12), 0, 0, DoubleNear(quarter, 1e-12)));
  EXPECT_THAT(ValueAt(turn, 2, false), ElementsAre(0, 0, 0, 1));
  const double eighth = std::acos(-1) / 8;
  EXPECT_THAT(ValueAt(turn, 0.5, false), ElementsAre(DoubleNear(std::cos(eighth), 1e-12), 0, 0,
                                                     DoubleNear(std::sin(eighth), 1e-12)));
}

TEST(Tables, OfJointsAreInTheRobotsOrder) {
  const CheckedTable gait = Table("real[joint] [rad]", "walk.csv");
  EXPECT_EQ(gait.type.size(), 17u);
  EXPECT_DOUBLE_EQ(gait.duration(), 0.8);
  EXPECT_DOUBLE_EQ(ValueAt(gait, 0, false)[1], 16.83 * std::acos(-1) / 180);
}

TEST(Tables, AreReadInEventsFunctionsAndConsts) {
  const CheckedTask task = CheckTask(
      "task tested\nsensor x: real [s]\ntable height: real [m] = \"height.csv\"\n"
      "const first: real [m] = height(0 s)\nconst period: real [s] = duration(height)\n"
      "fn lower(t: real [s]) -> real [m] = height(t, loop) - first\n"
      "on end_of_time_step {\n  reward a = height(x) / 1 m\n"
      "  reward b = lower(x + 2 * period) / 1 m\n"
      "  reward c = change(height(x)) / 1 m\n}\n");
  Evaluator evaluator(task);
  evaluator.frame().sensors[0] = Reals{0};
  evaluator.Fire(EventKind::kStartOfEpisode, 0);
  evaluator.frame().sensors[0] = Reals{0.25};
  evaluator.Fire(EventKind::kEndOfTimeStep, 0.25);
  EXPECT_DOUBLE_EQ(evaluator.frame().terms[0], 0.34);
  EXPECT_DOUBLE_EQ(evaluator.frame().terms[1], 0.34 - 0.31);
  EXPECT_DOUBLE_EQ(evaluator.frame().terms[2], 0.34 - 0.31);
}

TEST(Tables, AreConstantsWithConstantArguments) {
  EXPECT_TRUE(std::holds_alternative<Constant>(
      CheckText("height(250 ms)", "table height: real [m] = \"height.csv\"").node));
  EXPECT_EQ(TypeOf("gait(1 s, loop)", "table gait: real[joint] [rad] = \"walk.csv\""),
            "real[joint] [rad]");
}

}  // namespace
}  // namespace compiler
