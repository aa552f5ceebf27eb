#include "compiler/weights/weights.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

// `p` is never negative, `q` may be; `a` and `b` are terms.
constexpr const char* kDeclarations = R"(task tested
sensor x: real
sensor y: real
sensor v: vec3
sensor w: vec3
sensor hit: bool
sensor force: real[4] [N]
param p: real = 2 in 0 .. 10
param q: real = 1
)";

// "p scales a b, q ends": what each param is for; "ends" where it changes the course.
std::string UsesIn(const CheckedTask& task) {
  const Weights weights = FindWeights(task);
  std::string text;
  for (size_t i = 0; i < task.params.size(); ++i) {
    std::string use;
    for (const uint32_t term : weights.params[i].scales) use += " " + task.terms[term].name;
    if (!use.empty()) use = " scales" + use;
    if (weights.params[i].changes_course) use += " ends";
    if (!use.empty()) text += (text.empty() ? "" : ", ") + task.params[i].name + use;
  }
  return text;
}

struct Case {
  const char* block;  // of `end_of_time_step`
  const char* uses;
  const char* declarations = "";
};

void ExpectUses(std::initializer_list<Case> cases) {
  for (const Case& each : cases) {
    const CheckedTask task = CheckTask(fmt::format("{}{}\non end_of_time_step {{\n{}\n}}\n",
                                                   kDeclarations, each.declarations, each.block));
    EXPECT_EQ(UsesIn(task), each.uses) << each.declarations << "\n" << each.block;
  }
}

// All that a potential pays follows its value, also the part that was remembered.
TEST(Weights, ScalePotentials) {
  ExpectUses({
      {"", "p scales a", "reward potential a = -p * x"},
      {"", "", "reward potential a = -p * x + y"},
      {"reward b = p", "p scales b a", "reward potential a = p * abs(x)"},
  });
}

TEST(Weights, StandOnceInAProduct) {
  ExpectUses({
      {"reward a = p", "p scales a"},
      {"reward a = -p", "p scales a"},
      {"reward a = -(2 * x) * p / (y + 3)", "p scales a"},
      {"reward rate a = 0.25 / 5 ms * p * x", "p scales a"},
      {"reward a = x", ""},
      {"reward a = p * p", ""},
      {"reward a = x / p", ""},
      {"reward a = x / (y / p)", ""},
      {"reward a = p * x / p", ""},
  });
}

TEST(Weights, StandInEachPartOfASum) {
  ExpectUses({
      {"reward a = p * x - p * y", "p scales a"},
      {"reward a = p * (x + 1)", "p scales a"},
      {"reward a = p * x + 0", "p scales a"},
      {"reward a = p * x + y", ""},
      {"reward a = p + q", ""},
      {"reward a = x + (p - 1)", ""},
  });
}

TEST(Weights, StandInAllThatATermPays) {
  ExpectUses({
      {"reward a = p * x reward a = -p * y", "p scales a"},
      {"reward a = p * x reward a = 0", "p scales a"},
      {"reward a = p * x reward a = y", ""},
      {"reward a = y reward a = p * x", ""},
      {"if hit { reward a = p } else if x > 1 { reward a = 2 * p } else { reward a = 3 * p }",
       "p scales a"},
      {"if hit { reward a = p } else { reward a = 1 }", ""},
      {"for i in 0..3 { reward a = p * force[i] }", "p scales a"},
      {"for i in 0..3 { reward a = p * force[i] + i * 1 N }", ""},
      {"reward += p * x", "p scales reward"},
      {"reward -= p * x", "p scales reward"},
      {"reward += p * x reward += 1", ""},
  });
}

TEST(Weights, MayScaleSeveralTerms) {
  ExpectUses({
      {"reward a = p * x reward b = -p reward c = 1", "p scales a b"},
      {"reward a = p * x reward b = q * y", "p scales a, q scales b"},
      {"reward a = p * x reward b = p + y", ""},
      {"reward a = p * x reward b = exp(p)", ""},
      {"reward a = p * x if y > p { reward b = 1 }", ""},
      {"reward a = p * q * x", "p scales a, q scales a"},
  });
}

TEST(Weights, AreNoThresholds) {
  ExpectUses({
      {"if x > 1 { reward a = p }", "p scales a"},
      {"if x > p { reward a = x } reward b = p", ""},
      {"if x > 1 { reward a = x } reward b = p", "p scales b"},
      {"if x > p { reward a = p }", ""},
      {"if x > 1 { reward a = p } else if x > p { reward b = 1 }", ""},
      {"if x > p { if hit { reward a = p } }", ""},
      {"if x > p { log far = x } else { reward a = 1 } reward b = p", ""},
      {"if x > p { log far = x } reward a = p", "p scales a"},
      {"once per action if hit { reward a = -p }", "p scales a"},
      {"once per action if x > p { reward a = -p }", ""},
      {"if strict { reward a = 1 }", "", "param strict: bool = true"},
  });
}

TEST(Weights, GoThroughLocalValues) {
  ExpectUses({
      {"let cost = p * x let more = 2 * cost reward a = -more", "p scales a"},
      {"let cost = p * x reward a = cost * cost", ""},
      {"let far = x > p if far { reward a = 1 } reward b = p", ""},
      {"let far = x > p reward a = p", "p scales a"},
  });
}

TEST(Weights, GoThroughFunctions) {
  constexpr const char* kWeighed = "fn weighed(k: real, z: real) -> real = k * z";
  constexpr const char* kBent = "fn bent(k: real, z: real) -> real = k + z";
  constexpr const char* kDeep =
      "fn twice(z: real) -> real { let both = z + z return both }\n"
      "fn deep(k: real, z: real) -> real { let one = twice(k) return twice(one) * z }";
  ExpectUses({
      {"reward a = weighed(p, x)", "p scales a", kWeighed},
      {"reward a = weighed(x, p)", "p scales a", kWeighed},
      {"reward a = weighed(p, x) + weighed(y, p)", "p scales a", kWeighed},
      {"reward a = weighed(p, p)", "", kWeighed},
      {"reward a = weighed(p * p, x)", "", kWeighed},
      {"reward a = bent(p, p)", "p scales a", kBent},
      {"reward a = bent(p, x)", "", kBent},
      {"reward a = bent(1, x) * p", "p scales a", kBent},
      {"reward a = deep(p, x)", "p scales a", kDeep},
      {"reward a = deep(x, p)", "p scales a", kDeep},
      {"reward a = constant() * p", "p scales a", "fn constant() -> real = 2"},
  });
}

TEST(Weights, GoThroughVectors) {
  ExpectUses({
      {"reward a = dot(p * v, w)", "p scales a"},
      {"reward a = (v / 2 * p).x", "p scales a"},
      {"let u = vec3(p * x, 0, -p) reward a = u.z", "p scales a"},
      {"reward a = sum(p * cross(v, w))", "p scales a"},
      {"reward a = mean(p * force)", "p scales a"},
      {"reward a = dot(p * v, p * w)", ""},
      {"let u = vec3(p * x, 1, 2) reward a = u.x", ""},
      {"reward a = normalize(p * v).x", ""},
  });
}

TEST(Weights, GoThroughFunctionsOfTheLanguage) {
  ExpectUses({
      {"reward a = select(hit, p * x, 0)", "p scales a"},
      {"reward a = select(hit, p * x, 1)", ""},
      {"reward a = select(x > p, p * x, p * y)", ""},
      {"reward a = p * sqrt(x)", "p scales a"},
      {"reward a = sqrt(p)", ""},
      {"reward a = exp(p) * x", ""},
      {"reward a = pow(x, p)", ""},
      {"reward a = pow(p, 1)", ""},
      {"reward a = tolerance(x, 0, 1, p)", ""},
      {"reward a = sign(p * x)", ""},
  });
}

// With a negative param these would turn round.
TEST(Weights, StandInMagnitudesAndExtremesWhereTheyAreNeverNegative) {
  ExpectUses({
      {"reward a = abs(p * x)", "p scales a"},
      {"reward a = norm(p * v)", "p scales a"},
      {"reward a = max(p * x, 0)", "p scales a"},
      {"reward a = min(p * x, p * y, p)", "p scales a"},
      {"reward a = clamp(p * x, -p, p)", "p scales a"},
      {"reward a = max(p * x, y)", ""},
      {"reward a = clamp(p * x, 0, 1)", ""},
      {"reward a = abs(q * x)", ""},
      {"reward a = norm(q * v)", ""},
      {"reward a = max(q * x, 0)", ""},
      {"reward a = q * abs(x)", "q scales a"},
  });
}

TEST(Weights, DoNotGoThroughMemory) {
  constexpr const char* kSum = "memory kept: real = 0";
  ExpectUses({
      {"kept += x reward a = p * kept", "p scales a", kSum},
      {"kept = x reward a = kept reward b = p", "p scales b", kSum},
      {"if kept > 1 { reward a = p } kept += x", "p scales a", kSum},
      {"kept = p * x reward a = kept reward b = p", "", kSum},
      {"reward a = kept kept = p * x reward b = p", "", kSum},
      {"kept = p * x if kept > 1 { reward a = 1 } reward b = p", "", kSum},
      {"if x > p { kept = 1 } reward a = kept reward b = p", "", kSum},
      {"reward a = last last = kept kept = p * x reward b = p", "",
       "memory kept: real = 0 memory last: real = 0"},
      {"reward a = kept reward b = p", "", "memory kept: real = p"},
      {"reward a = p kept = p * x", "p scales a", kSum},
      {"reward a = p kept += reward reward b = kept", "", kSum},
      {"reward a = p reward b = reward", "", kSum},
      {"reward b = reward reward a = p", "p scales a", kSum},
      {"kept[0..1] = p reward a = kept[3] reward b = p", "", "memory kept: real[4] = 0"},
  });
}

TEST(Weights, GoFromOneEventToAnotherThroughMemoryOnly) {
  const auto uses = [](const std::string& events) {
    return UsesIn(CheckTask(kDeclarations + std::string("memory kept: real = 0\n") + events));
  };
  EXPECT_EQ(
      uses("on start_of_action { reward a = kept }\non end_of_action { kept = p reward b = p }"),
      "");
  EXPECT_EQ(uses("on start_of_action { reward a = p }\non end_of_action { reward b = reward }"),
            "p scales a");
  EXPECT_EQ(uses("on start_of_action { reward a = p * x }\non end_of_action { reward a = p * y }"),
            "p scales a");
  EXPECT_EQ(uses("on start_of_action { reward a = p * x }\non end_of_action { reward a = y }"), "");
}

TEST(Weights, MayDecideWhenAnEpisodeEnds) {
  constexpr const char* kSum = "memory kept: real = 0";
  constexpr const char* kSummed =
      "reward a = -p * x kept += reward if kept < -40 { end_episode failure \"too often\" }";
  ExpectUses({
      {kSummed, "p scales a ends", kSum},
      {"reward a = -p * x if reward < -4 { truncate_episode \"\" }", "p scales a ends"},
      {"if reward < -4 { truncate_episode \"\" } reward a = -p * x", "p scales a"},
      {"reward a = -p if p > 3 { end_episode success \"\" }", "p scales a ends"},
      {"reward a = x if x > p { end_episode success \"\" }", "p ends"},
      {"if x > p { reward a = 1 end_episode success \"\" }", "p ends"},
      {"reward a = -p kept += x if kept < -40 { end_episode failure \"\" }", "p scales a", kSum},
      {"reward a = -p kept += reward require kept > -1000", "p scales a ends", kSum},
      {"reward a = -p require x > p", "p scales a ends"},
      {"if limited and x > 2 { end_episode success \"\" }", "limited ends",
       "param limited: bool = true"},
  });
}

TEST(Weights, AreRealNumbersButNoAngles) {
  ExpectUses({
      {"reward a = n * x", "", "param n: int = 2"},
      {"reward a = -k * x", "k scales a", "param k: real [1/s] = 4 / s"},
      {"reward a = -k * x", "k scales a", "param k: real [1/rad] = 4 / rad"},
      {"reward a = -k * x", "", "param k: real [rad] = 4 deg"},
      {"reward a = p * n * x", "p scales a", "param n: int = 2"},
  });
}

TEST(Weights, MayBeReadByWhatNoRewardSees) {
  ExpectUses({
      {"reward a = p * x log curve = exp(p)", "p scales a"},
      {"reward a = p * x", "p scales a", "metric rest = x - p"},
      {"reward a = 1 log curve = p", ""},
  });
}

// `p` weighs the whole task, `q` this term alone.
TEST(Weights, AreForEachTermTheOneThatScalesTheFewest) {
  const auto weights_of = [](const std::string& rewards) {
    return FindWeights(CheckTask(kDeclarations + ("on end_of_time_step { " + rewards + " }")))
        .terms;
  };
  using Terms = std::vector<std::optional<uint32_t>>;
  EXPECT_EQ(weights_of("reward a = p * q * x reward b = p * y reward c = x"),
            (Terms{1, 0, std::nullopt}));
  EXPECT_EQ(weights_of("reward a = p * q * x"), Terms{0});
}

}  // namespace
}  // namespace compiler
