#include "runtime/live/control/parameter_json.h"

#include <gtest/gtest.h>

#include "runtime/core/module/live_parameter.h"
#include "runtime/training/run/value_json.h"
#include "tests/runtime/live/control/small_agent.h"
#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

using nlohmann::json;

class ParameterJsonTest : public testing::Test {
 protected:
  // What becomes of `parameter` where a client writes `value`.
  ParameterValue Read(const char* parameter, const json& value) {
    const std::string name = std::string("mind.") + parameter;
    return FitTo(mind_.FindParameter(parameter), ValueFromJson(value, name), name);
  }
  std::string Refusal(const char* parameter, const json& value) {
    return ErrorOf([&] { mind_.Set(parameter, Read(parameter, value)); });
  }

  Mind mind_{"mind", {}};
};

TEST_F(ParameterJsonTest, EachTypeHasItsJson) {
  EXPECT_EQ(Read("strict", true), ParameterValue(true));
  EXPECT_EQ(Read("steps", 7), ParameterValue(int64_t{7}));
  EXPECT_EQ(Read("pace", 0.25), ParameterValue(0.25));
  EXPECT_EQ(Read("mood", "wild"), ParameterValue(std::string("wild")));
  EXPECT_EQ(Read("weights", json({0.5, -1})), ParameterValue(std::vector{0.5, -1.0}));
  for (const char* name : {"strict", "steps", "pace", "mood", "weights"}) {
    EXPECT_EQ(Read(name, ToJson(mind_.Get(name))), mind_.Get(name));
  }
}

TEST_F(ParameterJsonTest, ANumberMayCarryItsUnit) {
  EXPECT_EQ(Read("pace", "20 m/s"), ParameterValue(20.0));
  EXPECT_EQ(Read("pace", "20m/s"), ParameterValue(20.0));
  EXPECT_EQ(Read("pace", "2e-3"), ParameterValue(0.002));
  EXPECT_EQ(Read("steps", "20"), ParameterValue(int64_t{20}));
  EXPECT_EQ(Refusal("pace", "20 s"), "`mind.pace` is a number in m/s, and `20 s` is not one");
  EXPECT_EQ(Refusal("pace", "20 m/s."), "`mind.pace` is a number in m/s, and `20 m/s.` is not one");
  EXPECT_EQ(Refusal("pace", "fast"), "`mind.pace` is a number in m/s, and `fast` is not one");
  EXPECT_EQ(Refusal("pace", ""), "`mind.pace` is a number in m/s, and `` is not one");
  EXPECT_EQ(Refusal("steps", "20 m"), "`mind.steps` is a number, and `20 m` is not one");
}

TEST_F(ParameterJsonTest, WholeNumbersMayBeWrittenAsReals) {
  EXPECT_EQ(Read("steps", 3.0), ParameterValue(int64_t{3}));
  EXPECT_EQ(Read("steps", "3.0"), ParameterValue(int64_t{3}));
  EXPECT_EQ(Refusal("steps", 3.5), "`mind.steps` is an integer, and 3.5 is not one");
  EXPECT_EQ(Refusal("steps", "3.5"), "`mind.steps` is an integer, and 3.5 is not one");
}

TEST_F(ParameterJsonTest, HugeNumbersAreNotMistakenForOthers) {
  EXPECT_EQ(Refusal("steps", 3'000'000'000),
            "`mind.steps` does not hold a number as large as 3000000000");
  EXPECT_EQ(Refusal("steps", 18446744073709551615u),
            "`mind.steps` is an integer, and 1.8446744073709552e+19 is not one");
  EXPECT_EQ(Refusal("steps", "1e300"), "`mind.steps` is an integer, and 1e+300 is not one");
  EXPECT_EQ(Read("pace", 18446744073709551615u), ParameterValue(18446744073709551616.0));
  EXPECT_EQ(Refusal("pace", "1e999"), "`mind.pace` is a number in m/s, and `1e999` is not one");
  EXPECT_EQ(Refusal("pace", "inf"), "`mind.pace` must be finite, and inf is not");
}

TEST_F(ParameterJsonTest, WhatNoParameterCanBeIsRefused) {
  EXPECT_EQ(Refusal("pace", nullptr), "`mind.pace` cannot be null");
  EXPECT_EQ(Refusal("pace", json::object()), "`mind.pace` cannot be {}");
  EXPECT_EQ(Refusal("weights", json({0.5, "1"})),
            "`mind.weights`: a list holds numbers only, and \"1\" is not one");
}

TEST_F(ParameterJsonTest, AnotherTypeIsRefused) {
  EXPECT_EQ(Refusal("mood", 3), "`mind.mood` cannot be \"3\"; there are `calm`, `wild`");
  EXPECT_EQ(Refusal("mood", "wlid"), "`mind.mood` cannot be \"wlid\": did you mean `wild`?");
  EXPECT_EQ(Refusal("strict", "true"), "`mind.strict` is true or false, and \"true\" is not one");
  EXPECT_EQ(Refusal("strict", 1), "`mind.strict` is true or false, and 1 is not one");
  EXPECT_EQ(Refusal("weights", "1, 2"),
            "`mind.weights` is a list of numbers, and `1, 2` is not one");
  EXPECT_EQ(Refusal("weights", json({0.5, 2})),
            "`mind.weights` must lie in -inf .. 1, and 2 does not");
}

TEST_F(ParameterJsonTest, AParameterTellsWhatBelongsToIt) {
  EXPECT_EQ(ParameterJson(mind_, mind_.FindParameter("steps")), json({{"name", "steps"},
                                                                      {"value", 4},
                                                                      {"unit", ""},
                                                                      {"doc", "of an action"},
                                                                      {"minimum", 1}}));
  EXPECT_EQ(ParameterJson(mind_, mind_.FindParameter("mood"))["choices"], json({"calm", "wild"}));
  EXPECT_EQ(ParameterJson(mind_, mind_.FindParameter("size"))["live"], false);
  EXPECT_EQ(ParameterJson(mind_, mind_.FindParameter("pace"))["unit"], "m/s");
}

}  // namespace
}  // namespace runtime
