#include "compiler/language_server/cursor_place.h"

#include "tests/compiler/language_server/marked_text.h"

namespace compiler {
namespace {

CursorPlace PlaceIn(const std::string& marked) {
  const MarkedText at(marked);
  const TextTokens tokens(at.text);
  return FindCursorPlace(tokens, at.offset);
}

Expected ExpectedIn(const std::string& marked) { return PlaceIn(marked).expected; }

// Inside of an event's block.
Expected ExpectedInBlock(const std::string& marked) {
  return ExpectedIn("task t for humanoid\non end_of_action {\n" + marked + "\n}\n");
}

TEST(CursorPlace, KnowsDeclarations) {
  EXPECT_EQ(ExpectedIn("|"), Expected::kDeclaration);
  EXPECT_EQ(ExpectedIn("task t\n\npar|"), Expected::kDeclaration);
  EXPECT_EQ(ExpectedIn("task t\non end_of_action { }\n|"), Expected::kDeclaration);
  EXPECT_EQ(ExpectedIn("task |"), Expected::kAnyText);
  EXPECT_EQ(ExpectedIn("task t |"), Expected::kOperator);
  EXPECT_EQ(ExpectedIn("task t for |"), Expected::kRobot);
  EXPECT_EQ(ExpectedIn("task t\nstart s|"), Expected::kPose);
  EXPECT_EQ(ExpectedIn("task t\nstart a or |"), Expected::kPose);
  EXPECT_EQ(ExpectedIn("task t\nstart a or b {\n  |\n}\n"), Expected::kStartStatement);
  EXPECT_EQ(ExpectedIn("task t\nstart a {\n  if b { |"), Expected::kStartStatement);
  EXPECT_EQ(ExpectedIn("task t\nstart a {\n  base.yaw = |"), Expected::kGoalValue);
  EXPECT_EQ(ExpectedIn("task t\nreward |"), Expected::kPotential);
  EXPECT_EQ(ExpectedIn("task t\nreward potential a = |"), Expected::kValue);
  EXPECT_EQ(ExpectedIn("task t\nafter_end |"), Expected::kAfterEnd);
  EXPECT_EQ(ExpectedIn("task t\noverride after_end |"), Expected::kAfterEnd);
  EXPECT_EQ(ExpectedIn("task t\non |"), Expected::kEvent);
  EXPECT_EQ(ExpectedIn("task t\nmetric m|"), Expected::kReduction);
  EXPECT_EQ(ExpectedIn("task t\nobserve |"), Expected::kObserved);
  EXPECT_EQ(ExpectedIn("task t\nobserve base.|"), Expected::kMember);
  EXPECT_EQ(ExpectedIn("task t\nobserve a |"), Expected::kOperator);
  EXPECT_EQ(ExpectedIn("task t\nobserve a = 2 * |"), Expected::kValue);
  EXPECT_EQ(ExpectedIn("task t\noverride observe |"), Expected::kObservationName);
  EXPECT_EQ(ExpectedIn("task t\nmemory a: |"), Expected::kType);
  EXPECT_EQ(ExpectedIn("task t\nmemory a: bool[|"), Expected::kTypeIndex);
  EXPECT_EQ(ExpectedIn("task t\nmemory a: real[4] [|"), Expected::kUnit);
  EXPECT_EQ(ExpectedIn("task t\nmemory a: int = |"), Expected::kValue);
  EXPECT_EQ(ExpectedIn("task t\nmemory a: int = 0 per |"), Expected::kScope);
  EXPECT_EQ(ExpectedIn("task t\noverride |"), Expected::kOverridden);
  EXPECT_EQ(ExpectedIn("task t\noverride param |"), Expected::kParamName);
  EXPECT_EQ(ExpectedIn("task t\noverride const |"), Expected::kConstName);
  EXPECT_EQ(ExpectedIn("task t\noverride set |"), Expected::kSetName);
  EXPECT_EQ(ExpectedIn("task t\nconst |"), Expected::kAnyText);
  EXPECT_EQ(ExpectedIn("task t\nconst a: real = |"), Expected::kValue);
  EXPECT_EQ(ExpectedIn("task t\nset a = |"), Expected::kIndex);
  EXPECT_EQ(ExpectedIn("task t\nset a = {|"), Expected::kIndex);
  EXPECT_EQ(ExpectedIn("task t\noverride set a = feet - |"), Expected::kIndex);
  EXPECT_EQ(ExpectedIn("task t\nphase |"), Expected::kAnyText);
  EXPECT_EQ(ExpectedIn("task t\nphase a |"), Expected::kOperator);
  EXPECT_EQ(ExpectedIn("task t\nphase a within |"), Expected::kValue);
  EXPECT_EQ(ExpectedIn("task t\nphase a within 3 s else |"), Expected::kPhase);
  EXPECT_EQ(ExpectedIn("task t\noverride phase |"), Expected::kPhaseName);
  EXPECT_EQ(ExpectedIn("task t\nphase a within 3 s else b { |"), Expected::kStatement);
  EXPECT_EQ(ExpectedIn("allow W07|"), Expected::kWarningCode);
  EXPECT_EQ(ExpectedIn("import \"sh|"), Expected::kFile);
}

TEST(CursorPlace, KnowsStatements) {
  EXPECT_EQ(ExpectedInBlock("|"), Expected::kStatement);
  EXPECT_EQ(ExpectedInBlock("a = 1\nle|"), Expected::kStatement);
  EXPECT_EQ(ExpectedInBlock("if a { |"), Expected::kStatement);
  EXPECT_EQ(ExpectedInBlock("if a { b = 1 }\n|"), Expected::kStatement);
  EXPECT_EQ(ExpectedInBlock("let |"), Expected::kAnyText);
  EXPECT_EQ(ExpectedInBlock("reward |"), Expected::kTerm);
  EXPECT_EQ(ExpectedInBlock("let a = |"), Expected::kValue);
  EXPECT_EQ(ExpectedInBlock("let a = b +\n|"), Expected::kValue);
  EXPECT_EQ(ExpectedInBlock("let a = b |"), Expected::kOperator);
  EXPECT_EQ(ExpectedInBlock("next |"), Expected::kPhase);
  EXPECT_EQ(ExpectedInBlock("if a { next l|"), Expected::kPhase);
  EXPECT_EQ(ExpectedInBlock("if phase == |"), Expected::kPhase);
  EXPECT_EQ(ExpectedInBlock("let a = b and phase != |"), Expected::kPhase);
  EXPECT_EQ(ExpectedInBlock("if |"), Expected::kValue);
  EXPECT_EQ(ExpectedInBlock("reward |"), Expected::kTerm);
  EXPECT_EQ(ExpectedInBlock("end_episode |"), Expected::kOutcome);
  EXPECT_EQ(ExpectedInBlock("end_episode failure \"a |"), Expected::kAnyText);
  EXPECT_EQ(ExpectedInBlock("for |"), Expected::kAnyText);
  EXPECT_EQ(ExpectedInBlock("for l in |"), Expected::kIndex);
  EXPECT_EQ(ExpectedInBlock("for l in links - |"), Expected::kIndex);
  EXPECT_EQ(ExpectedInBlock("for l in links { |"), Expected::kStatement);
  EXPECT_EQ(ExpectedInBlock("once per |"), Expected::kScope);
  EXPECT_EQ(ExpectedInBlock("let a = 1 // |"), Expected::kAnyText);
  EXPECT_EQ(ExpectedInBlock("let a = 12|"), Expected::kAnyText);
}

TEST(CursorPlace, KnowsExpressions) {
  EXPECT_EQ(ExpectedInBlock("let a = 5 |"), Expected::kUnit);
  EXPECT_EQ(ExpectedInBlock("let a = 5 m|"), Expected::kUnit);
  EXPECT_EQ(ExpectedInBlock("let a = clamp(|"), Expected::kValue);
  EXPECT_EQ(ExpectedInBlock("let a = clamp(b, |"), Expected::kValue);
  const CursorPlace member = PlaceIn("task t\nmetric a = base.velocity.x|");
  EXPECT_EQ(member.expected, Expected::kMember);
  EXPECT_EQ(member.path, "base.velocity");
  const CursorPlace indexed = PlaceIn("task t\nmetric a = link.position[hands, head].|");
  EXPECT_EQ(indexed.expected, Expected::kMember);
  EXPECT_EQ(indexed.path, "link.position");
  const CursorPlace index = PlaceIn("task t\nmetric a = norm(joint.angle[legs - {h|");
  EXPECT_EQ(index.expected, Expected::kIndex);
  EXPECT_EQ(index.path, "joint.angle");
}

TEST(CursorPlace, KnowsTestsAndFunctions) {
  EXPECT_EQ(ExpectedIn("task t\ntest \"a\" {\n|"), Expected::kTestStatement);
  EXPECT_EQ(ExpectedIn("task t\ntest \"a\" {\ngiven |"), Expected::kTarget);
  EXPECT_EQ(ExpectedIn("task t\ntest \"a\" {\nfire |"), Expected::kEvent);
  EXPECT_EQ(ExpectedIn("task t\ntest \"a\" {\nfire a, |"), Expected::kEvent);
  EXPECT_EQ(ExpectedIn("task t\ntest \"a\" {\nexpect |"), Expected::kExpectation);
  EXPECT_EQ(ExpectedIn("fn f(|"), Expected::kAnyText);
  EXPECT_EQ(ExpectedIn("fn f(a: |"), Expected::kType);
  EXPECT_EQ(ExpectedIn("fn f(a: real) -> |"), Expected::kType);
  EXPECT_EQ(ExpectedIn("fn f(a: real) -> real {\n|"), Expected::kBodyStatement);
  EXPECT_EQ(ExpectedIn("fn f(a: real) -> real = |"), Expected::kValue);
}

// Whatever the text is, there is an answer.
TEST(CursorPlace, SurvivesEveryText) {
  const std::string text =
      "task t for humanoid\nfn f(a: real[4] [N m]) -> real { let b = {a, [ return a }\n"
      "on end_of_action { for l in {a} - b { reward rate x = contact[l].( - \"unclosed\n } ] ) }";
  for (uint32_t end = 0; end <= text.size(); ++end) {
    const TextTokens tokens(std::string_view(text).substr(0, end));
    for (uint32_t offset = 0; offset <= end; ++offset) {
      FindCursorPlace(tokens, offset);
      FindOpenCall(tokens, offset);
      FindPath(tokens, offset);
    }
  }
}

OpenCall CallIn(const std::string& marked) {
  const MarkedText at(marked);
  return FindOpenCall(TextTokens(at.text), at.offset);
}

TEST(OpenCall, IsTheInnermost) {
  EXPECT_EQ(CallIn("let a = clamp(|").function, "clamp");
  const OpenCall second = CallIn("let a = max(b, clamp(b[1, 2], (c), |");
  EXPECT_EQ(second.function, "clamp");
  EXPECT_EQ(second.argument, 2u);
  EXPECT_EQ(CallIn("let a = max(clamp(1, 2, 3), |").argument, 1u);
  EXPECT_EQ(CallIn("let a = contact[body, |").function, "");
  EXPECT_EQ(CallIn("let a = (b, |").function, "");
  EXPECT_EQ(CallIn("fn near(a|").function, "");
  EXPECT_EQ(CallIn("let a = f(1)\n|").function, "");
}

TEST(PathAtCursor, GoesBackThroughDots) {
  const MarkedText at("metric a = base.velo|city.xy");
  const PathAtCursor path = FindPath(TextTokens(at.text), at.offset);
  EXPECT_EQ(path.path, "base.velocity");
  EXPECT_EQ(path.span, (Span{11, 24}));
  EXPECT_EQ(path.last, (Span{16, 24}));
  EXPECT_EQ(FindPath(TextTokens("a + b"), 2).path, "");
}

}  // namespace
}  // namespace compiler
