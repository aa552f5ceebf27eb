// What lets are worth at a moment that a host tells of.
#include "compiler/interpret/lets_worth.h"

#include <gmock/gmock.h>

#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

constexpr const char* kHead =
    "task tested\n"
    "sensor x: real [m]\nsensor v: vec3\nsensor n: int\nsensor touch: bool[4]\n"
    "param weight: real = 2\n"
    "goal target: vec2 = uniform(-1, 1)\n"
    "memory best: real [m] = 0\n";

using Worth = std::vector<std::pair<std::string, Reals>>;

Worth WorthOf(const std::string& text, const KnownNumbers& known) {
  const CheckedTask task = CheckTask(kHead + text);
  Worth worth;
  for (const LetWorth& let : LetsWorth(task, known)) {
    worth.emplace_back(let.name, ToReals(let.value));
  }
  return worth;
}

Worth WorthIn(const std::string& statements, const KnownNumbers& known) {
  return WorthOf("on end_of_time_step { " + statements + " }\n", known);
}

TEST(LetsWorth, FollowsEquationsToWhatIsKnown) {
  const KnownNumbers known = {{"x", {0.5}}, {"v", {3, 4, 12}},       {"weight", {10}},
                              {"n", {7}},   {"touch", {0, 1, 1, 0}}, {"target", {1, 2}},
                              {"best", {2}}};
  EXPECT_THAT(WorthIn("let a = weight * x / 1 m\nlet b = a + norm(v)\nlet c = v.zx\n"
                      "let d = n / 2\nlet e = count(touch)\nlet f = any(touch)\n"
                      "let o = v.xy - target\nlet p = max(best, x)\n",
                      known),
              ElementsAre(Pair("a", ElementsAre(5)), Pair("b", ElementsAre(18)),
                          Pair("c", ElementsAre(12, 3)), Pair("d", ElementsAre(3.5)),
                          Pair("e", ElementsAre(2)), Pair("f", ElementsAre(1)),
                          Pair("o", ElementsAre(2, 2)), Pair("p", ElementsAre(2))));
}

TEST(LetsWorth, HasTypeAndUnit) {
  const CheckedTask task =
      CheckTask(kHead + std::string("on end_of_time_step { let twice = 2 * x }\n"));
  const std::vector<LetWorth> worth = LetsWorth(task, {{"x", {0.25}}});
  ASSERT_EQ(worth.size(), 1);
  EXPECT_EQ(ToString(worth[0].type), "real");
  EXPECT_EQ(ToString(worth[0].unit), "m");
  EXPECT_THAT(ToReals(worth[0].value), ElementsAre(0.5));
}

TEST(LetsWorth, LeavesOutWhatLeadsToTheUnknown) {
  EXPECT_THAT(WorthIn("let a = x\nlet b = a + best\nlet c = b\nlet d = 2 * a\n", {{"x", {1}}}),
              ElementsAre(Pair("a", ElementsAre(1)), Pair("d", ElementsAre(2))));
  EXPECT_THAT(WorthIn("let a = weight\n", {}), IsEmpty()) << "it may have been changed";
  EXPECT_THAT(WorthIn("reward r = x / 1 m\nlet a = reward\n", {{"x", {1}}}), IsEmpty());
  EXPECT_THAT(WorthIn("let a = time_step\n", {}), IsEmpty());
}

TEST(LetsWorth, TakesNothingThatDoesNotFit) {
  EXPECT_THAT(WorthIn("let a = v\n", {{"v", {1, 2}}}), IsEmpty());
  EXPECT_THAT(WorthIn("let a = n\n", {{"n", {0.5}}}), IsEmpty());
  EXPECT_THAT(WorthIn("let a = n\n", {{"n", {1e300}}}), IsEmpty());
  EXPECT_THAT(WorthIn("let a = x\n", {{"x", {1}}, {"y", {1}}}),
              ElementsAre(Pair("a", ElementsAre(1))));
}

TEST(LetsWorth, DoesNotAskWhetherTheEventComesToIt) {
  EXPECT_THAT(WorthIn("if x > 1 m { let a = 2 * x\n reward r = a / 1 m }\n", {{"x", {0.5}}}),
              ElementsAre(Pair("a", ElementsAre(1))));
}

TEST(LetsWorth, IsSilentWhereANameMeansSeveral) {
  EXPECT_THAT(WorthIn("for i in 0 .. 1 { let a = v[i]\n reward r = a }\n", {{"v", {1, 2, 3}}}),
              IsEmpty());
  EXPECT_THAT(WorthOf("on start_of_action { let a = x\n best = a }\n"
                      "on end_of_time_step { let a = 2 * x\n let b = x\n best = a }\n",
                      {{"x", {1}}}),
              ElementsAre(Pair("b", ElementsAre(1))));
}

TEST(LetsWorth, KnowsPhasesAndFunctions) {
  EXPECT_THAT(
      WorthOf("fn twice(y: real [m]) -> real [m] = y + y\n"
              "phase begin { let a = twice(x)\n if a > 1 m { next over } }\nphase over {}\n",
              {{"x", {3}}}),
      ElementsAre(Pair("a", ElementsAre(6))));
}

}  // namespace
}  // namespace compiler
