// Messages about names, operands and units.
#include <TaskParser.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>

#include "compiler/syntax/descriptions.h"
#include "compiler/syntax/foreign_words.h"
#include "compiler/syntax/power_help.h"
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
    case TaskParser::RuleObservation:  // `observe g = 1`
      return failure.next_type() == TaskParser::ASSIGN;
    case TaskParser::RuleStatement:
      return failure.last_type() == TaskParser::REWARD;
    case TaskParser::RuleReward:  // `reward g = 1`, `reward rate g = 1`
    case TaskParser::RuleLog:
      return true;
    case TaskParser::RuleBlock:  // `m = 4`
      return failure.next_type() == TaskParser::ASSIGN;
    default:
      return false;
  }
}

// `joint.angle["left_knee"]`, `let v = "a"`
Help HelpForString(const Failure& failure) {
  const std::string text = failure.found.getText();
  const std::string name = text.size() > 2 ? text.substr(1, text.size() - 2) : "";
  const bool is_name = !name.empty() && std::ranges::all_of(name, [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
  const bool is_in_index =
      failure.last_type() == TaskParser::LEFT_BRACKET || failure.last_type() == TaskParser::COMMA;
  if (is_name && is_in_index)
    return {fmt::format("names of links, joints and sites have no quotes: `{}`", name),
            {{SpanOf(failure.found), name}}};
  return "a task computes with numbers and conditions; texts are only reasons and names of tests";
}

Help HelpForVector() { return "a vector is `vec2(x, y)`, `vec3(x, y, z)` or `vec4(x, y, z, w)`"; }

// For what is not an operand in this language.
Help HelpForOperand(const Failure& failure) {
  switch (failure.type()) {
    case TaskParser::STRING:
      return HelpForString(failure);
    case TaskParser::IF:
      return "a choice between two values is `select(condition, x, y)`";
    case TaskParser::LEFT_BRACKET:
      return HelpForVector();
    default:
      return {};
  }
}

}  // namespace

Help HelpBehindOperand(const Failure& failure) {
  const Span found = SpanOf(failure.found);
  switch (failure.type()) {
    case TaskParser::NAME:
      if (failure.last->getText() == "NOT" || failure.last->getText() == "Not")
        return WriteInstead(SpanOf(*failure.last), "not");
      return HelpForForeign(ForeignPlace::kOperator, failure.found.getText(), found);
    case TaskParser::POWER:
      return HelpForPower(failure.file, found);
    case TaskParser::COLON:
      return failure.rule == TaskParser::RuleSelection || failure.rule == TaskParser::RuleItems
                 ? Help("a range has two dots and includes both ends: `0..2`")
                 : Help();
    case TaskParser::COMMA:
      return failure.rule == TaskParser::RulePrimary ? HelpForVector() : Help();
    case TaskParser::IN:
      return "an element is picked with brackets, as in `contact[head]`";
    default:
      return {};
  }
}

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
  if (failure.type() != TaskParser::LEFT_BRACE || !ExpectsOperand(failure.last_type()) ||
      failure.last_type() == TaskParser::WITHIN) {
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
  if (failure.rule == TaskParser::RulePrimary && EndsOperand(last)) {
    return WithHelp(Expected(failure, "an operator or `)`"), HelpBehindOperand(failure));
  }
  const bool is_loop_set = last == TaskParser::IN && failure.statement_type() == TaskParser::FOR;
  Diagnostic diagnostic = Expected(failure, is_loop_set ? "a set" : "an expression");
  if (failure.is_behind_last()) return diagnostic;
  diagnostic.help = HelpForOperand(failure);
  if (!diagnostic.help.empty()) return diagnostic;
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

// `1.0f`, `0x10`, `1_000`: directly behind the digits.
Diagnostic BadSuffix(const antlr4::Token& number, const antlr4::Token& suffix) {
  const std::string text = number.getText();
  const std::string letters = suffix.getText();
  Diagnostic diagnostic = MakeDiagnostic(code::kBadNumber, Cover(SpanOf(number), SpanOf(suffix)),
                                         "this is not a number");
  const bool is_separated =
      letters.front() == '_' && letters.find_first_not_of("_0123456789") == std::string::npos;
  if (is_separated) {
    std::string digits = text;
    std::ranges::copy_if(letters, std::back_inserter(digits), [](char c) { return c != '_'; });
    return WithHelp(std::move(diagnostic), WriteInstead(diagnostic.span, digits));
  }
  if (letters.size() == 1) {
    return WithHelp(std::move(diagnostic), {fmt::format("a number has no suffix: write `{}`", text),
                                            {{SpanOf(suffix), ""}}});
  }
  return WithHelp(std::move(diagnostic), "numbers are decimal, such as `16`, `0.5` or `1e-3`");
}

bool IsSuffix(const antlr4::Token& number, const antlr4::Token& name) {
  const std::string letters = name.getText();
  const bool is_known =
      letters == "f" || letters == "F" || letters == "L" || letters == "d" || letters == "u" ||
      letters.front() == '_' ||
      (number.getText() == "0" && (letters.front() == 'x' || letters.front() == 'b'));
  return is_known && SpanOf(number).end == SpanOf(name).begin;
}

Help HelpForUnit(const Failure& failure, const antlr4::Token& token) {
  const std::string name = token.getText();
  Help help = HelpForForeign(ForeignPlace::kUnit, name, SpanOf(token));
  if (help.empty()) help = HelpForPowerInName(name, SpanOf(token));
  if (help.empty()) help = Nearest(token, UnitNames());
  if (!help.empty()) return help;
  const antlr4::Token* number = failure.parser.getTokenStream()->get(token.getTokenIndex() - 1);
  if (number->getType() != TaskParser::NUMBER)
    return fmt::format("the units are {}", fmt::join(UnitNames(), ", "));
  const uint32_t place = SpanOf(*number).end;
  return {fmt::format("to multiply, write `{} * {}`; the units are {}", number->getText(), name,
                      fmt::join(UnitNames(), ", ")),
          {{{place, place}, " *"}}};
}

Diagnostic UnknownUnit(const Failure& failure, const antlr4::Token& token) {
  antlr4::TokenStream& tokens = *failure.parser.getTokenStream();
  const size_t index = token.getTokenIndex();
  const antlr4::Token& number = *tokens.get(index - 1);
  const std::string name = token.getText();
  if (number.getType() == TaskParser::NUMBER && IsSuffix(number, token))
    return BadSuffix(number, token);
  const TokenType next = index + 1 < tokens.size() ? tokens.get(index + 1)->getType() : 0;
  if (next == TaskParser::DOT || next == TaskParser::LEFT_BRACKET) {
    const uint32_t place = SpanOf(number).end;
    return WithHelp(MakeDiagnostic(code::kUnexpectedToken, SpanOf(token),
                                   fmt::format("expected an operator, found `{}`", name)),
                    {fmt::format("to multiply, write `{} * {}...`", number.getText(), name),
                     {{{place, place}, " *"}}});
  }
  return WithHelp(
      MakeDiagnostic(code::kUnknownUnit, SpanOf(token), fmt::format("there is no unit `{}`", name)),
      HelpForUnit(failure, token));
}

// `20 sec`, wherever it stands.
Description NameBehindNumber(const Failure& failure) {
  const bool is_name = failure.type() == TaskParser::NAME &&
                       failure.last_type() == TaskParser::NUMBER && !failure.is_at_line_start();
  if (!is_name || failure.next_type() == TaskParser::LEFT_PARENTHESIS) return std::nullopt;
  return UnknownUnit(failure, failure.found);
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
  if (failure.type() == TaskParser::NAME) return UnknownUnit(failure, failure.found);
  return Expected(failure, "a unit");
}

Description BadType(const Failure& failure) {
  if (failure.rule != TaskParser::RuleType || failure.last_type() != TaskParser::LEFT_BRACKET) {
    return std::nullopt;
  }
  return Expected(failure, "a unit, an enumeration or a number");
}

}  // namespace compiler
