// Imports, libraries, and tasks that extend others.
#include <gtest/gtest.h>

#include <string>

#include "tests/compiler/syntax/syntax_text.h"

namespace compiler {
namespace {

template <typename Node>
const Node& DeclarationOf(const SyntaxTree& tree, size_t index = 0) {
  return std::get<Node>(tree.declarations.at(index).node);
}

TEST(Imports, HaveAPath) {
  const SyntaxTree tree = ParseTask("task t\nimport \"lib/shaping.task\"\n");
  EXPECT_EQ(DeclarationOf<ImportDeclaration>(tree).path, "lib/shaping.task");
  EXPECT_EQ(DeclarationOf<ImportDeclaration>(tree).path_span, (Span{14, 32}));
}

TEST(Libraries, HaveNoHeader) {
  const SyntaxTree tree =
      ParseTask("import \"more.task\"\n\n/// Twice.\nfn f(a: real) -> real = 2 * a\n");
  EXPECT_FALSE(tree.task.has_value());
  ASSERT_EQ(tree.declarations.size(), 2u);
  EXPECT_EQ(DeclarationOf<FunctionDeclaration>(tree, 1).doc, "Twice.");
}

TEST(Extends, NamesTheBaseAndPerhapsARobot) {
  const SyntaxTree tree = ParseTask("task back extends \"forward.task\"\n");
  EXPECT_EQ(tree.task->text, "back");
  EXPECT_EQ(tree.base->path, "forward.task");
  EXPECT_FALSE(tree.robot.has_value());
  EXPECT_EQ(ParseTask("task back extends \"forward.task\" for dog\n").robot->text, "dog");
}

TEST(Overrides, EveryKind) {
  const SyntaxTree tree = ParseTask(
      "task back extends \"forward.task\"\n"
      "override start lying\n"
      "override param direction = -1\n"
      "override param gain = 2 in 0 .. 5\n"
      "override metric max height = z\n"
      "/// Why.\n"
      "override reward rate roll = 3\n"
      "override reward fall = -1\n"
      "override on end_of_action { n = 1 }\n"
      "override fn f() -> int = 3\n"
      "override after_end stop\n");
  ASSERT_EQ(tree.declarations.size(), 9u);
  for (const Declaration& declaration : tree.declarations) {
    ASSERT_TRUE(declaration.override_span.has_value());
    EXPECT_EQ(declaration.override_span->end - declaration.override_span->begin, 8u);
  }
  EXPECT_EQ(DeclarationOf<StartDeclaration>(tree, 0).poses[0].text, "lying");
  EXPECT_EQ(DeclarationOf<ParamOverride>(tree, 1).name.text, "direction");
  EXPECT_EQ(ToText(DeclarationOf<ParamOverride>(tree, 1).initial), "(- 1)");
  EXPECT_FALSE(DeclarationOf<ParamOverride>(tree, 1).minimum.has_value());
  EXPECT_EQ(ToText(*DeclarationOf<ParamOverride>(tree, 2).maximum), "5");
  EXPECT_EQ(DeclarationOf<MetricDeclaration>(tree, 3).reduction, Reduction::kMax);
  EXPECT_TRUE(DeclarationOf<RewardOverride>(tree, 4).reward.is_rate);
  EXPECT_EQ(DeclarationOf<RewardOverride>(tree, 4).reward.doc, "Why.");
  EXPECT_FALSE(DeclarationOf<RewardOverride>(tree, 5).reward.is_rate);
  EXPECT_EQ(ToText(DeclarationOf<EventDeclaration>(tree, 6).body), "n = 1");
  EXPECT_EQ(DeclarationOf<FunctionDeclaration>(tree, 7).name.text, "f");
  EXPECT_EQ(DeclarationOf<AfterEndDeclaration>(tree, 8).behavior, AfterEnd::kStop);
}

TEST(Overrides, BelongToThePlaceOfTheDeclaration) {
  const std::string text = "task a extends \"b.task\"\noverride start lying\n";
  const SyntaxTree tree = ParseTask(text);
  const Span span = tree.declarations.at(0).span;
  EXPECT_EQ(text.substr(span.begin, span.end - span.begin), "override start lying");
}

}  // namespace
}  // namespace compiler
