// Messages about names, operands and units.
#include <TaskParser.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "compiler/syntax/descriptions.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using grammar::TaskParser;

// Where the name itself is what the grammar fails at, or what tells its alternatives apart.
bool WantsName(const Failure& failure) {
  switch (failure.rule) {
    case TaskParser::RuleName:
    case TaskParser::RuleWord:
    case TaskParser::RuleMetric:
      return true;
    case TaskParser::RuleStatement:
    case TaskParser::RuleReward:
      return failure.last_type() == TaskParser::REWARD;
    case TaskParser::RuleBlock:  // `m = 4`
      return failure.next_type() == TaskParser::ASSIGN;
    default:
      return false;
  }
}

}  // namespace

Description ReservedName(const Failure& failure) {
  if (!WantsName(failure) || !IsReserved(failure.type()) || failure.is_behind_last()) {
    return std::nullopt;
  }
  const bool is_nameless_loop =
      failure.parent_rule == TaskParser::RuleLoop && failure.type() == TaskParser::IN;
  if (is_nameless_loop) return std::nullopt;
  const std::string word = failure.found.getText();
  const char* kind = IsUnit(failure.type()) ? "unit" : "reserved word";
  return WithHelp(MakeDiagnostic(code::kReservedName, SpanOf(failure.found),
                                 fmt::format("`{}` is a {} and cannot be a name", word, kind)),
                  fmt::format("choose another name, such as `my_{}`", word));
}

Description MisplacedSet(const Failure& failure) {
  if (failure.type() != TaskParser::LEFT_BRACE || !ExpectsOperand(failure.last_type())) {
    return std::nullopt;
  }
  return WithHelp(MakeDiagnostic(code::kMisplacedSet, SpanOf(failure.found),
                                 "a set in braces is allowed only inside an index"),
                  "pick elements with it: `contact[links - {body, head}]`");
}

Description ChainedComparison(const Failure& failure) {
  if (!IsComparison(failure.type()) || !EndsOperand(failure.last_type())) return std::nullopt;
  return WithHelp(MakeDiagnostic(code::kChainedComparison, SpanOf(failure.found),
                                 "comparisons cannot be chained"),
                  "combine two with `and`: `a < b and b < c`");
}

// `5.`
Description NumberWithoutDigits(const Failure& failure) {
  const bool is_number = failure.last_type() == TaskParser::DOT && failure.before_last != nullptr &&
                         failure.before_last->getType() == TaskParser::NUMBER;
  if (!is_number) return std::nullopt;
  const Span span = Cover(SpanOf(*failure.before_last), SpanOf(*failure.last));
  const std::string number = failure.before_last->getText();
  return WithHelp(
      MakeDiagnostic(code::kBadNumber, span, "a number ends with a digit"),
      {fmt::format("write `{0}.0` or `{0}`", number), {{span, number + ".0"}, {span, number}}});
}

Description MissingOperand(const Failure& failure) {
  const TokenType last = failure.last_type();
  const bool is_behind_operator = ExpectsOperand(last) || last == TaskParser::LEFT_PARENTHESIS ||
                                  last == TaskParser::LEFT_BRACKET || last == TaskParser::IF ||
                                  last == TaskParser::IN || last == TaskParser::REQUIRE ||
                                  last == TaskParser::EXPECT || last == TaskParser::RETURN;
  const bool wants_other =
      failure.rule == TaskParser::RuleStatement || failure.rule == TaskParser::RuleName;
  if (failure.rule != TaskParser::RulePrimary && (!is_behind_operator || wants_other)) {
    return std::nullopt;
  }
  const bool is_loop_set = last == TaskParser::IN && failure.statement_type() == TaskParser::FOR;
  Diagnostic diagnostic = Expected(failure, is_loop_set ? "a set" : "an expression");
  if (failure.is_behind_last()) return diagnostic;
  if (IsUnit(failure.type())) {
    diagnostic.help =
        fmt::format("`{0}` is a unit and comes after a number: `1 {0}`", failure.found.getText());
  } else if (failure.type() == TaskParser::NOT) {
    diagnostic.help = "put `not` and its operand in parentheses";
  } else if (failure.type() == TaskParser::PLUS) {
    diagnostic.help = {"there is no unary plus", {{SpanOf(failure.found), ""}}};
  }
  return diagnostic;
}

Diagnostic UnknownUnit(const antlr4::Token& token) {
  const std::string name = token.getText();
  Help help = Nearest(token, UnitNames());
  if (help.empty()) help = fmt::format("the units are {}", fmt::join(UnitNames(), ", "));
  return WithHelp(
      MakeDiagnostic(code::kUnknownUnit, SpanOf(token), fmt::format("there is no unit `{}`", name)),
      help);
}

// `20 sec`, wherever it stands.
Description NameBehindNumber(const Failure& failure) {
  const bool is_name = failure.type() == TaskParser::NAME &&
                       failure.last_type() == TaskParser::NUMBER && !failure.is_at_line_start();
  if (!is_name || failure.next_type() == TaskParser::LEFT_PARENTHESIS) return std::nullopt;
  return UnknownUnit(failure.found);
}

Description BadUnit(const Failure& failure) {
  switch (failure.rule) {
    case TaskParser::RuleUnit:
    case TaskParser::RuleUnitFactor:
    case TaskParser::RuleUnitName:
      break;
    default:
      return std::nullopt;
  }
  if (failure.last_type() == TaskParser::POWER) return Expected(failure, "an integer");
  if (failure.type() == TaskParser::NAME) return UnknownUnit(failure.found);
  return Expected(failure, "a unit");
}

Description BadType(const Failure& failure) {
  if (failure.rule != TaskParser::RuleType || failure.last_type() != TaskParser::LEFT_BRACKET) {
    return std::nullopt;
  }
  return Expected(failure, "a unit, an enumeration or a number");
}

}  // namespace compiler
