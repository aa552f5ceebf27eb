#include "tests/compiler/syntax/syntax_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <variant>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/parse.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

template <typename... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};

std::string List(const std::vector<ExpressionPtr>& items) {
  std::string text;
  for (const ExpressionPtr& item : items) text += ' ' + ToText(*item);
  return text;
}

constexpr std::array kBinaryOperators = {
    "+", "-", "*", "/", "<", "<=", ">", ">=", "==", "!=", "and", "or"};
constexpr std::array kAssignOperators = {"=", "+=", "-=", "*=", "/="};

std::string BracesText(const Block& block) { return fmt::format("{{{}}}", ToText(block)); }

}  // namespace

std::string ToText(const UnitExpression& unit) {
  std::string text = "[";
  for (const UnitFactor& factor : unit.factors) {
    if (text.size() > 1) text += ' ';
    text += factor.name.text;
    if (factor.power != 1) text += fmt::format("^{}", factor.power);
  }
  return text + "]";
}

std::string ToText(const TypeExpression& type) {
  return type.index ? fmt::format("{}[{}]", type.name.text, type.index->text) : type.name.text;
}

std::string ToText(const Expression& expression) {
  const Overload visitor = {
      [](const NumberLiteral& e) {
        return fmt::format("{:g}{}{}", e.value, e.is_integer ? "" : "r",
                           e.unit ? ToText(*e.unit) : "");
      },
      [](const BoolLiteral& e) { return std::string(e.value ? "true" : "false"); },
      [](const NameExpression& e) { return e.name.text; },
      [](const MemberExpression& e) {
        return fmt::format("{}.{}", ToText(*e.object), e.member.text);
      },
      [](const IndexExpression& e) {
        return fmt::format("(at {}{})", ToText(*e.object), List(e.items));
      },
      [](const RangeExpression& e) {
        return fmt::format("{}..{}", ToText(*e.first), ToText(*e.last));
      },
      [](const SetExpression& e) { return fmt::format("(set{})", List(e.items)); },
      [](const CallExpression& e) {
        return fmt::format("({}{})", e.function.text, List(e.arguments));
      },
      [](const UnaryExpression& e) {
        return fmt::format("({} {})", e.op == UnaryOperator::kNot ? "not" : "-",
                           ToText(*e.operand));
      },
      [](const BinaryExpression& e) {
        return fmt::format("({} {} {}{})", kBinaryOperators.at(static_cast<size_t>(e.op)),
                           ToText(*e.left), ToText(*e.right),
                           e.tolerance != nullptr ? " within " + ToText(*e.tolerance) : "");
      },
      [](const MethodExpression& e) {
        return fmt::format("(method {} {}{})", e.name.text, ToText(*e.object), List(e.arguments));
      },
      [](const LostExpression&) { return std::string("(lost)"); },
  };
  return std::visit(visitor, expression.node);
}

std::string ToText(const Target& target) {
  std::string text = target.name.text;
  if (target.member) text += fmt::format(" .{}", target.member->text);
  if (!target.items.empty()) text = fmt::format("(at {}{})", text, List(target.items));
  return target.indexed_member ? fmt::format("{} .{}", text, target.indexed_member->text) : text;
}

std::string ToText(const EndStatement& end) {
  const std::string_view kind = NameOf(end.kind, kOutcomeNames);
  return end.kind == EndKind::kTruncated ? fmt::format("truncate '{}'", end.reason)
                                         : fmt::format("end {} '{}'", kind, end.reason);
}

std::string ToText(const Statement& statement) {
  const Overload visitor = {
      [](const LetStatement& s) { return fmt::format("let {} {}", s.name.text, ToText(s.value)); },
      [](const AssignStatement& s) {
        return fmt::format("{} {} {}", ToText(s.target),
                           kAssignOperators.at(static_cast<size_t>(s.op)), ToText(s.value));
      },
      [](const IfStatement& s) {
        std::string text;
        for (const IfBranch& branch : s.branches) {
          text += text.empty() ? "if " : " else if ";
          text += fmt::format("{} {}", ToText(branch.condition), BracesText(branch.body));
        }
        return s.otherwise ? text + " else " + BracesText(*s.otherwise) : text;
      },
      [](const RewardStatement& s) {
        return fmt::format("{} {} {}", s.is_rate ? "reward rate" : "reward", s.name.text,
                           ToText(s.value));
      },
      [](const EndStatement& s) { return ToText(s); },
      [](const ForStatement& s) {
        return fmt::format("for {} in{} {}", s.variable.text, List(s.items), BracesText(s.body));
      },
      [](const OnceStatement& s) {
        std::string text = fmt::format("once {}", NameOf(s.scope, kScopeNames));
        for (const IfBranch& branch : s.branches)
          text += fmt::format("{} if {} {}", &branch == s.branches.data() ? "" : " else",
                              ToText(branch.condition), BracesText(branch.body));
        return text;
      },
      [](const LogStatement& s) {
        return fmt::format("log {} {} {}", NameOf(s.reduction, kReductionNames), s.name.text,
                           ToText(s.value));
      },
      [](const RequireStatement& s) {
        return fmt::format("require {} '{}'", ToText(s.condition), s.reason);
      },
      [](const RedrawStatement& s) { return "redraw " + s.goal.text; },
      [](const NextStatement& s) { return "next " + s.phase.text; },
  };
  return std::visit(visitor, statement.node);
}

std::string ToText(const Block& block) {
  std::string text;
  for (const Statement& statement : block) {
    if (!text.empty()) text += "; ";
    text += ToText(statement);
  }
  return text;
}

std::string ToText(const TestStatement& statement) {
  const Overload visitor = {
      [](const GivenStatement& s) {
        return fmt::format("given {} = {}", ToText(s.target), ToText(s.value));
      },
      [](const FireStatement& s) {
        std::string text = "fire";
        for (const FiredEvent& fired : s.events) {
          text += fmt::format(" {}*{}", fired.times, NameOf(fired.event, kEventNames));
        }
        return text;
      },
      [](const ExpectStatement& s) { return fmt::format("expect {}", ToText(s.condition)); },
      [](const ExpectEndStatement& s) { return fmt::format("expect {}", ToText(s.end)); },
  };
  return std::visit(visitor, statement.node);
}

SyntaxTree ParseTask(const std::string& text) {
  const Sources sources("test.task", text);
  Diagnostics diagnostics;
  auto tree = Parse(sources.main(), diagnostics);
  EXPECT_EQ(Render(sources, diagnostics, false), "");
  if (!tree) {
    ADD_FAILURE() << "not well-formed:\n" << text;
    return {};
  }
  return std::move(*tree);
}

Block ParseBlock(const std::string& statements) {
  SyntaxTree tree =
      ParseTask(fmt::format("task t for humanoid\non end_of_time_step {{\n{}\n}}\n", statements));
  if (tree.declarations.empty()) return {};
  return std::move(std::get<EventDeclaration>(tree.declarations.front().node).body);
}

std::string ParseExpression(const std::string& expression) {
  const Block block = ParseBlock("let x = " + expression);
  if (block.size() != 1) return ToText(block);
  return ToText(std::get<LetStatement>(block.front().node).value);
}

std::string Errors(const std::string& text) {
  const Sources sources("test.task", text);
  Diagnostics diagnostics;
  Parse(sources.main(), diagnostics);
  EXPECT_TRUE(diagnostics.has_errors()) << text;
  std::string errors;
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    const Position position = sources.PositionOf(diagnostic.span);
    errors += fmt::format("{} {}:{} {}\n", diagnostic.code, position.line, position.column,
                          diagnostic.message);
  }
  return errors;
}

}  // namespace compiler
