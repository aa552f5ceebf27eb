#include "runtime/core/module/module.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

namespace runtime {
namespace {

class Settings : public Module {
 public:
  Settings() : Module("learner") {
    AddParameter({"active", "", &active});
    AddParameter({"units", "", &units, {}, 1, 500});
    AddParameter({"discount", "", &discount, {}, 0, 1});
    AddParameter({.name = "episode_end",
                  .doc = "",
                  .target = &episode_end,
                  .choices = {"after_action", "immediate"},
                  .former_choices = {{"clean", "immediate"}}});
    AddParameter({"intervals", "", &intervals, {}, 0.01, 1});
  }

  bool active = false;
  int units = 10;
  double discount = 0.9;
  std::string episode_end = "after_action";
  std::vector<double> intervals{0.1};
};

std::string MessageOfSetting(const std::string& parameter, const ParameterValue& value) {
  Settings settings;
  try {
    settings.Set(parameter, value);
  } catch (const UserError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ModuleSet, AssignsEachTypeOfParameter) {
  Settings settings;
  settings.Set("active", true);
  settings.Set("units", int64_t{20});
  settings.Set("discount", 0.5);
  settings.Set("episode_end", "immediate");
  settings.Set("intervals", std::vector<double>{0.075, 0.1});
  EXPECT_TRUE(settings.active);
  EXPECT_EQ(settings.units, 20);
  EXPECT_EQ(settings.discount, 0.5);
  EXPECT_EQ(settings.episode_end, "immediate");
  EXPECT_THAT(settings.intervals, testing::ElementsAre(0.075, 0.1));
}

TEST(ModuleSet, ReadsTheFormerNameOfAChoice) {
  Settings settings;
  settings.Set("episode_end", "clean");
  EXPECT_EQ(settings.episode_end, "immediate");
}

TEST(ModuleSet, AcceptsAnIntegerForAReal) {
  Settings settings;
  settings.Set("discount", int64_t{1});
  EXPECT_EQ(settings.discount, 1.0);
}

TEST(ModuleSet, RefusesAnUnknownName) {
  EXPECT_EQ(MessageOfSetting("discuont", 0.5),
            "the module `learner` has no parameter `discuont`: did you mean `discount`?");
}

TEST(ModuleSet, RefusesAnotherType) {
  EXPECT_EQ(MessageOfSetting("active", 1.5),
            "`learner.active` is true or false, and 1.5 is not one");
  EXPECT_EQ(MessageOfSetting("units", 1.5), "`learner.units` is an integer, and 1.5 is not one");
  EXPECT_EQ(MessageOfSetting("discount", true),
            "`learner.discount` is a number, and true is not one");
  EXPECT_EQ(MessageOfSetting("episode_end", int64_t{3}),
            "`learner.episode_end` cannot be \"3\"; there are `after_action`, `immediate`");
  EXPECT_EQ(MessageOfSetting("intervals", "wide"),
            "`learner.intervals` is a list of numbers, and \"wide\" is not one");
}

TEST(ModuleSet, RefusesANumberOutOfRange) {
  EXPECT_EQ(MessageOfSetting("units", int64_t{0}),
            "`learner.units` must lie in 1 .. 500, and 0 does not");
  EXPECT_EQ(MessageOfSetting("discount", 1.25),
            "`learner.discount` must lie in 0 .. 1, and 1.25 does not");
  EXPECT_EQ(MessageOfSetting("intervals", std::vector<double>{0.1, 2}),
            "`learner.intervals` must lie in 0.01 .. 1, and 2 does not");
}

TEST(ModuleSet, RefusesANumberThatIsNotFinite) {
  EXPECT_EQ(MessageOfSetting("discount", std::nan("")),
            "`learner.discount` must be finite, and nan is not");
}

TEST(ModuleSet, RefusesATextThatIsNoChoice) {
  EXPECT_EQ(MessageOfSetting("episode_end", "imediate"),
            "`learner.episode_end` cannot be \"imediate\": did you mean `immediate`?");
  EXPECT_EQ(MessageOfSetting("episode_end", "never"),
            "`learner.episode_end` cannot be \"never\"; there are `after_action`, `immediate`");
}

TEST(ModuleSet, KeepsTheOldValueWhereItRefusesTheNewOne) {
  Settings settings;
  EXPECT_THROW(settings.Set("intervals", std::vector<double>{0.1, 2}), UserError);
  EXPECT_THAT(settings.intervals, testing::ElementsAre(0.1));
}

TEST(ModuleGet, GivesWhatWasSet) {
  Settings settings;
  settings.Set("units", int64_t{7});
  EXPECT_EQ(settings.Get("units"), ParameterValue(int64_t{7}));
  EXPECT_EQ(settings.Get("active"), ParameterValue(false));
  EXPECT_THROW(settings.Get("unit_s"), UserError);
}

TEST(ParameterValueText, IsToml) {
  EXPECT_EQ(ToText(ParameterValue(true)), "true");
  EXPECT_EQ(ToText(ParameterValue(int64_t{-3})), "-3");
  EXPECT_EQ(ToText(ParameterValue(2.0)), "2.0");
  EXPECT_EQ(ToText(ParameterValue(0.1)), "0.1");
  EXPECT_EQ(ToText(ParameterValue(1e300)), "1e+300");
  EXPECT_EQ(ToText(ParameterValue("a \"b\"\\\n")), "\"a \\\"b\\\"\\\\\\u000a\"");
  EXPECT_EQ(ToText(ParameterValue(std::vector<double>{1, 0.5})), "[1.0, 0.5]");
}

}  // namespace
}  // namespace runtime
