#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "compiler/syntax/words.h"
#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

template <typename Node>
Node ParseOne(const std::string& declaration) {
  SyntaxTree tree = ParseTask("task t\n" + declaration + "\n");
  EXPECT_EQ(tree.declarations.size(), 1u);
  return std::get<Node>(std::move(tree.declarations.at(0).node));
}

TEST(Header, TaskRobotAndStart) {
  const SyntaxTree tree = ParseTask("task crawling for humanoid\nstart standing\n");
  EXPECT_EQ(tree.task->text, "crawling");
  EXPECT_EQ(tree.task->span, (Span{5, 13}));
  EXPECT_EQ(tree.robot->text, "humanoid");
  ASSERT_EQ(tree.declarations.size(), 1u);
  EXPECT_EQ(std::get<StartDeclaration>(tree.declarations[0].node).poses[0].text, "standing");
}

TEST(Header, RobotAndStartMayBeAbsent) {
  const SyntaxTree tree = ParseTask("task t");
  EXPECT_FALSE(tree.robot.has_value());
  EXPECT_TRUE(tree.declarations.empty());
}

TEST(Sensor, NameMayBeDotted) {
  const auto sensor = ParseOne<SensorDeclaration>("sensor base.velocity: vec3 [m/s]");
  EXPECT_EQ(sensor.name.text, "base.velocity");
  EXPECT_EQ(sensor.name.span, (Span{14, 27}));
  EXPECT_EQ(ToText(sensor.type), "vec3");
  EXPECT_EQ(ToText(*sensor.unit), "[m s^-1]");
}

TEST(Sensor, ArrayOverAnEnumeration) {
  const auto sensor = ParseOne<SensorDeclaration>("sensor contact: bool[link]");
  EXPECT_EQ(ToText(sensor.type), "bool[link]");
  EXPECT_EQ(sensor.type.span, (Span{23, 33}));
  EXPECT_FALSE(sensor.unit.has_value());
}

TEST(Sensor, MayHaveARange) {
  const auto sensor =
      ParseOne<SensorDeclaration>("sensor pole.angle: real [rad] in -180 deg .. 180 deg");
  EXPECT_EQ(ToText(*sensor.minimum), "(- 180[deg])");
  EXPECT_EQ(ToText(*sensor.maximum), "180[deg]");
  EXPECT_FALSE(ParseOne<SensorDeclaration>("sensor a: real").minimum.has_value());
}

TEST(Observation, HasANameOrIsCalledByItsValue) {
  const auto named = ParseOne<ObserveDeclaration>("/// Of a step.\nobserve clock = sin(angle)");
  EXPECT_EQ(named.name.text, "clock");
  EXPECT_TRUE(named.has_name);
  EXPECT_EQ(named.doc, "Of a step.");
  EXPECT_EQ(ToText(named.value), "(sin angle)");
  const auto plain = ParseOne<ObserveDeclaration>("observe base.up");
  EXPECT_EQ(plain.name.text, "base.up");
  EXPECT_FALSE(plain.has_name);
  EXPECT_EQ(ParseOne<ObserveDeclaration>("observe base.up = x").name.text, "base.up");
  EXPECT_EQ(ParseOne<ObserveDeclaration>("observe (a)").name.text, "(a)");
  EXPECT_EQ(ParseOne<ObserveDeclaration>("observe -a").name.text, "-a");
}

TEST(Observation, IsCalledByItsTextAsTheFormatterSetsIt) {
  EXPECT_EQ(
      ParseOne<ObserveDeclaration>("observe x[ 1 ]*2 m/s-  // why\n  -f(a,b ) / 4/s").name.text,
      "x[1] * 2 m/s - -f(a, b) / 4 / s");
}

TEST(Observation, Onboard) {
  EXPECT_EQ(ParseOne<OnboardDeclaration>("observe onboard").word.text, "onboard");
  EXPECT_EQ(ParseOne<ObserveDeclaration>("observe it = onboard").name.text, "it");
}

TEST(Potential, HasANameAndAValue) {
  const auto potential =
      ParseOne<PotentialDeclaration>("/// Nearer.\nreward potential near = -norm(base.position)");
  EXPECT_EQ(potential.name.text, "near");
  EXPECT_EQ(potential.doc, "Nearer.");
  // The word is a name where a name is needed.
  EXPECT_EQ(ParseOne<PotentialDeclaration>("reward potential potential = 1").name.text,
            "potential");
}

TEST(Goal, IsDrawnOncePerEpisodeOrInIntervals) {
  const auto goal = ParseOne<GoalDeclaration>("goal side: int = choose(0, 1)");
  EXPECT_EQ(goal.name.text, "side");
  EXPECT_EQ(ToText(goal.type), "int");
  EXPECT_EQ(ToText(goal.draw.value), "(choose 0 1)");
  EXPECT_FALSE(goal.draw.shortest);
  EXPECT_FALSE(ParseOne<GoalDeclaration>("goal side: int = 1 per episode").draw.shortest);
  const auto often =
      ParseOne<GoalDeclaration>("goal v: vec2 [m/s] = uniform(-1, 1)\n  per 3 s .. 8 s");
  EXPECT_EQ(ToText(*often.unit), "[m s^-1]");
  EXPECT_EQ(ToText(*often.draw.shortest), "3[s]");
  EXPECT_EQ(ToText(*often.draw.longest), "8[s]");
  EXPECT_FALSE(ParseOne<GoalDeclaration>("goal v: real = 1 per 2 s").draw.longest);
}

TEST(Phase, MayHaveALimit) {
  const auto phase = ParseOne<PhaseDeclaration>("/// Up.\nphase lift { n = 1 next done }");
  EXPECT_EQ(phase.doc, "Up.");
  EXPECT_EQ(phase.name.text, "lift");
  EXPECT_FALSE(phase.limit);
  EXPECT_EQ(ToText(phase.body), "n = 1; next done");
  for (const char* text : {"phase lift within 3 s else reach { }",
                           "phase lift\n    within 3 s\n    else reach\n{\n}"}) {
    const auto limited = ParseOne<PhaseDeclaration>(text);
    EXPECT_EQ(ToText(limited.limit->time), "3[s]");
    EXPECT_EQ(limited.limit->otherwise.text, "reach");
    EXPECT_TRUE(limited.body.empty());
  }
}

TEST(Param, DefaultAndRange) {
  const auto param = ParseOne<ParamDeclaration>("param gain: real [1/s] = 4 / s in 0 .. 20 / s");
  EXPECT_EQ(param.name.text, "gain");
  EXPECT_EQ(ToText(param.type), "real");
  EXPECT_EQ(ToText(*param.unit), "[s^-1]");
  EXPECT_EQ(ToText(param.initial), "4[s^-1]");
  EXPECT_EQ(ToText(*param.minimum), "0");
  EXPECT_EQ(ToText(*param.maximum), "20[s^-1]");
}

TEST(Param, RangeMayBeAbsentOrWithoutBlanks) {
  EXPECT_FALSE(ParseOne<ParamDeclaration>("param n: int = 4").minimum.has_value());
  const auto param = ParseOne<ParamDeclaration>("param n: int = 4 in -2..7");
  EXPECT_EQ(ToText(*param.minimum), "(- 2)");
  EXPECT_EQ(ToText(*param.maximum), "7");
}

TEST(Memory, EveryScope) {
  EXPECT_EQ(ParseOne<MemoryDeclaration>("memory a: real = 0").scope, MemoryScope::kPerEpisode);
  EXPECT_EQ(ParseOne<MemoryDeclaration>("memory a: real = 0 per episode").scope,
            MemoryScope::kPerEpisode);
  EXPECT_EQ(ParseOne<MemoryDeclaration>("memory a: real = 0 per action").scope,
            MemoryScope::kPerAction);
  EXPECT_EQ(ParseOne<MemoryDeclaration>("memory a: real = 0 per run").scope, MemoryScope::kPerRun);
}

TEST(Memory, TypeUnitAndInitialValue) {
  const auto memory = ParseOne<MemoryDeclaration>("memory place: vec3 [m] = 0 m per action");
  EXPECT_EQ(memory.name.text, "place");
  EXPECT_EQ(ToText(memory.type), "vec3");
  EXPECT_EQ(ToText(*memory.unit), "[m]");
  EXPECT_EQ(ToText(memory.initial), "0[m]");
}

TEST(Metric, EveryReduction) {
  EXPECT_EQ(ParseOne<MetricDeclaration>("metric d = x").reduction, Reduction::kLast);
  EXPECT_EQ(ParseOne<MetricDeclaration>("metric last d = x").reduction, Reduction::kLast);
  EXPECT_EQ(ParseOne<MetricDeclaration>("metric sum d = x").reduction, Reduction::kSum);
  EXPECT_EQ(ParseOne<MetricDeclaration>("metric max d = x").reduction, Reduction::kMax);
  EXPECT_EQ(ParseOne<MetricDeclaration>("metric min d = x").reduction, Reduction::kMin);
  EXPECT_EQ(ParseOne<MetricDeclaration>("metric mean d = x").reduction, Reduction::kMean);
}

TEST(Metric, AReductionsNameIsStillAName) {
  const auto metric = ParseOne<MetricDeclaration>("metric max = base.position.z");
  EXPECT_EQ(metric.name.text, "max");
  EXPECT_EQ(metric.reduction, Reduction::kLast);
}

TEST(Event, EveryEvent) {
  for (const Word<EventKind>& word : kEventNames) {
    const auto event = ParseOne<EventDeclaration>("on " + std::string(word.text) + " { }");
    EXPECT_EQ(event.event, word.meaning);
    EXPECT_EQ(event.name.text, word.text);
    EXPECT_TRUE(event.body.empty());
  }
}

TEST(Declarations, KeepTheirOrderAndPlaces) {
  const std::string text =
      "task t\nmemory a: real = 0\nparam b: real = 1\n\non end_of_action {\n}\n";
  const SyntaxTree tree = ParseTask(text);
  ASSERT_EQ(tree.declarations.size(), 3u);
  std::vector<std::string> texts;
  for (const Declaration& declaration : tree.declarations) {
    texts.push_back(
        text.substr(declaration.span.begin, declaration.span.end - declaration.span.begin));
  }
  EXPECT_EQ(texts, (std::vector<std::string>{"memory a: real = 0", "param b: real = 1",
                                             "on end_of_action {\n}"}));
}

TEST(Documentation, ReachesWhatFollowsIt) {
  const SyntaxTree tree = ParseTask(
      "/// Crawl.\n///\n///  Fast.  \ntask t\n"
      "/// A sensor.\nsensor v: real\n"
      "/// A param.\n\nparam p: real = 1\n"
      "/// A memory.\r\nmemory m1: real = 0\n"
      "/// A metric.\nmetric q = x\n"
      "/// An event.\non end_of_action { }\n");
  EXPECT_EQ(tree.doc, "Crawl.\n\n Fast.");
  EXPECT_EQ(std::get<SensorDeclaration>(tree.declarations.at(0).node).doc, "A sensor.");
  EXPECT_EQ(std::get<ParamDeclaration>(tree.declarations.at(1).node).doc, "A param.");
  EXPECT_EQ(std::get<MemoryDeclaration>(tree.declarations.at(2).node).doc, "A memory.");
  EXPECT_EQ(std::get<MetricDeclaration>(tree.declarations.at(3).node).doc, "A metric.");
  EXPECT_EQ(std::get<EventDeclaration>(tree.declarations.at(4).node).doc, "An event.");
}

TEST(Documentation, OrdinaryCommentsAreNone) {
  const SyntaxTree tree = ParseTask(
      "// Not this.\n//// Nor this.\ntask t /// Nor this.\nmemory a: real = 0  /// Nor this.\n"
      "memory b: real = 0\n");
  EXPECT_EQ(tree.doc, "");
  EXPECT_EQ(std::get<MemoryDeclaration>(tree.declarations.at(0).node).doc, "");
  EXPECT_EQ(std::get<MemoryDeclaration>(tree.declarations.at(1).node).doc, "");
}

}  // namespace
}  // namespace compiler
