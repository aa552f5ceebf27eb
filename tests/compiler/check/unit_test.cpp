#include "compiler/check/unit.h"

#include <gtest/gtest.h>

#include <numbers>
#include <regex>
#include <set>

#include "tests/golden.h"

namespace compiler {
namespace {

constexpr Unit kMeter{.meter = 1};
constexpr Unit kSecond{.second = 1};
constexpr Unit kRadian{.radian = 1};
constexpr Unit kSpeed{.meter = 1, .second = -1};
constexpr Unit kForce{1, 1, -2, 0};

Unit Parsed(std::string_view text) {
  const auto unit = ParseUnit(text);
  EXPECT_TRUE(unit) << text;
  return unit ? unit->unit : Unit{};
}

double InSi(double value, std::string_view text) {
  const auto unit = ParseUnit(text);
  EXPECT_TRUE(unit) << text;
  return unit ? unit->ToSi(value) : 0;
}

TEST(Unit, ProductsAddPowers) {
  EXPECT_EQ(Multiply(kSpeed, kSecond), kMeter);
  EXPECT_EQ(Divide(kMeter, kSecond), kSpeed);
  EXPECT_EQ(Divide(kMeter, kMeter), Unit{});
  EXPECT_EQ(Multiply(kForce, kMeter), (Unit{2, 1, -2, 0}));
}

TEST(Unit, PowersBeyondTheRangeAreRefused) {
  const Unit large{.meter = 127};
  EXPECT_EQ(Multiply(large, kMeter), std::nullopt);
  EXPECT_EQ(Divide(large, kMeter), (Unit{.meter = 126}));
  EXPECT_EQ(Divide(Unit{.second = -128}, kSecond), std::nullopt);
}

TEST(Unit, SquareRootHalvesEvenPowers) {
  EXPECT_EQ(SquareRoot(Unit{.meter = 2, .second = -4}), (Unit{.meter = 1, .second = -2}));
  EXPECT_EQ(SquareRoot(Unit{}), Unit{});
  EXPECT_EQ(SquareRoot(kMeter), std::nullopt);
  EXPECT_EQ(SquareRoot(Unit{.second = -3}), std::nullopt);
}

TEST(Unit, AngleIsNoPlainNumber) {
  EXPECT_NE(kRadian, Unit{});
  EXPECT_TRUE(IsAngle(kRadian));
  EXPECT_FALSE(IsPlain(kRadian));
  EXPECT_NE(Parsed("rad/s"), Parsed("1/s"));
}

TEST(Unit, NamesHaveTheirSizeInSi) {
  EXPECT_EQ(InSi(5, "ms"), 0.005);
  EXPECT_EQ(InSi(5, "cm"), 0.05);
  EXPECT_EQ(InSi(7, "mm"), 0.007);
  EXPECT_EQ(InSi(2, "km"), 2000);
  EXPECT_EQ(InSi(3, "us"), 0.000003);
  EXPECT_EQ(InSi(2, "min"), 120);
  EXPECT_EQ(InSi(250, "g"), 0.25);
  EXPECT_EQ(InSi(50, "Hz"), 50);
  EXPECT_DOUBLE_EQ(InSi(180, "deg"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(InSi(36, "km/min"), 600);
  EXPECT_DOUBLE_EQ(InSi(10, "cm^2"), 0.001);
  EXPECT_DOUBLE_EQ(InSi(4, "1/ms"), 4000);
}

TEST(Unit, DerivedNamesHaveTheirDimensions) {
  EXPECT_EQ(Parsed("N"), Parsed("kg m/s^2"));
  EXPECT_EQ(Parsed("J"), Parsed("N m"));
  EXPECT_EQ(Parsed("W"), Parsed("J/s"));
  EXPECT_EQ(Parsed("Hz"), Parsed("1/s"));
  EXPECT_EQ(Parsed("m*s^-2"), Parsed("m/s/s"));
}

TEST(Unit, TextIsAsAReaderWritesIt) {
  EXPECT_EQ(ToString(Unit{}), "");
  EXPECT_EQ(ToString(kSpeed), "m/s");
  EXPECT_EQ(ToString(kForce), "N");
  EXPECT_EQ(ToString(Parsed("N m")), "N m");
  EXPECT_EQ(ToString(Parsed("N m/rad")), "N m/rad");
  EXPECT_EQ(ToString(Parsed("W")), "W");
  EXPECT_EQ(ToString(Parsed("1/s^2")), "1/s^2");
  EXPECT_EQ(ToString(Parsed("kg m/s")), "kg m/s");
  EXPECT_EQ(ToString(Parsed("rad/s")), "rad/s");
}

TEST(Unit, TextIsReadBackAsTheSameUnit) {
  for (int8_t meter = -3; meter <= 3; ++meter)
    for (int8_t kilogram = -2; kilogram <= 2; ++kilogram)
      for (int8_t second = -4; second <= 3; ++second)
        for (int8_t radian = -2; radian <= 2; ++radian) {
          const Unit unit{meter, kilogram, second, radian};
          EXPECT_EQ(Parsed(ToString(unit)), unit) << ToString(unit);
        }
}

TEST(Unit, TextThatIsNoUnitIsRefused) {
  for (const char* text : {"furlong", "m/", "/", "m//s", "m^", "m^x", "1", "m^200", "M", "km^127"})
    EXPECT_FALSE(ParseUnit(text)) << text;
}

// The grammar has to list the names of units itself, as words that are no names.
TEST(Unit, NamesAreThoseOfTheGrammar) {
  const std::string grammar = golden::ReadFile(SOURCE_DIR "/grammar/Task.g4");
  std::smatch rule;
  ASSERT_TRUE(std::regex_search(grammar, rule, std::regex("\nunitName\\s*:([^;]*);")));
  std::set<std::string> words;
  const std::string list = rule[1];
  const std::regex word("'(\\w+)'");
  for (std::sregex_iterator match(list.begin(), list.end(), word), end; match != end; ++match)
    words.insert((*match)[1]);
  const std::vector<std::string> names = KnownUnits();
  EXPECT_EQ(words, std::set<std::string>(names.begin(), names.end()));
}

}  // namespace
}  // namespace compiler
