#include "compiler/syntax/syntax_messages.h"

#include <TaskParser.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "compiler/syntax/syntax_failure.h"
#include "compiler/syntax/token_classes.h"
#include "plugins/text/nearest_name.h"

namespace compiler {
namespace {

using grammar::TaskParser;

std::string DidYouMean(const std::string& name, const std::vector<std::string>& candidates) {
  const auto nearest = text::NearestName(name, candidates);
  return nearest ? fmt::format("did you mean `{}`?", *nearest) : "";
}

// ---- Kinds of failures: each says whether it is the one ----------------------------------------

using Description = std::optional<Diagnostic>;

Description MissingHeader(const Failure& failure) {
  if (failure.rule != TaskParser::RuleFile || failure.last != nullptr) return std::nullopt;
  return WithHelp(MakeDiagnostic(code::kMissingHeader, SpanOf(failure.found),
                                 fmt::format("expected `task NAME`, found {}", FoundText(failure))),
                  "a file begins with the task's name and its robot: `task crawling for humanoid`");
}

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

Description ReservedName(const Failure& failure) {
  if (!WantsName(failure) || !IsReserved(failure.type()) || failure.is_behind_last()) {
    return std::nullopt;
  }
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
                                 "a set in braces stands only inside an index"),
                  "pick elements with it: `contact[links - {body, head}]`");
}

// `reward fall -4`: what is found lies behind the place at which the grammar stands.
Description MissingEqualsInReward(const Failure& failure) {
  if (failure.rule != TaskParser::RuleReward || failure.last_type() != TaskParser::NAME) {
    return std::nullopt;
  }
  return ExpectedBehindLast(failure, "`=`");
}

Description ChainedComparison(const Failure& failure) {
  if (!IsComparison(failure.type()) || !EndsOperand(failure.last_type())) return std::nullopt;
  return WithHelp(MakeDiagnostic(code::kChainedComparison, SpanOf(failure.found),
                                 "comparisons cannot be chained"),
                  "combine two with `and`: `a < b and b < c`");
}

Description BadCondition(const Failure& failure) {
  const bool is_behind_condition = failure.rule == TaskParser::RuleBlock &&
                                   failure.parent_rule == TaskParser::RuleBranches &&
                                   EndsOperand(failure.last_type());
  if (!is_behind_condition) return std::nullopt;
  Diagnostic diagnostic = Expected(failure, "an operator or `{`");
  if (failure.type() == TaskParser::ASSIGN) diagnostic.help = "to compare, write `==`";
  return diagnostic;
}

// `5.`
Description NumberWithoutDigits(const Failure& failure) {
  const bool is_number = failure.last_type() == TaskParser::DOT && failure.before_last != nullptr &&
                         failure.before_last->getType() == TaskParser::NUMBER;
  if (!is_number) return std::nullopt;
  return WithHelp(
      MakeDiagnostic(code::kBadNumber, Cover(SpanOf(*failure.before_last), SpanOf(*failure.last)),
                     "a number ends with a digit"),
      fmt::format("write `{0}.0` or `{0}`", failure.before_last->getText()));
}

Description MissingOperand(const Failure& failure) {
  const TokenType last = failure.last_type();
  const bool is_behind_operator = ExpectsOperand(last) || last == TaskParser::LEFT_PARENTHESIS ||
                                  last == TaskParser::LEFT_BRACKET || last == TaskParser::IF ||
                                  last == TaskParser::IN;
  if (failure.rule != TaskParser::RulePrimary &&
      (!is_behind_operator || failure.rule == TaskParser::RuleStatement)) {
    return std::nullopt;
  }
  Diagnostic diagnostic = Expected(failure, "an expression");
  if (failure.is_behind_last()) return diagnostic;
  if (IsUnit(failure.type())) {
    diagnostic.help =
        fmt::format("`{0}` is a unit and stands behind a number: `1 {0}`", failure.found.getText());
  } else if (failure.type() == TaskParser::NOT) {
    diagnostic.help = "put `not` and what it denies in parentheses";
  } else if (failure.type() == TaskParser::PLUS) {
    diagnostic.help = "there is no plus sign in front of an operand";
  }
  return diagnostic;
}

Diagnostic UnknownUnit(const antlr4::Token& token) {
  const std::string name = token.getText();
  std::string help = DidYouMean(name, UnitNames());
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

Description BadReward(const Failure& failure) {
  if (failure.rule != TaskParser::RuleStatement || failure.last_type() != TaskParser::REWARD) {
    return std::nullopt;
  }
  return Expected(failure, "the name of a term, or `+=`");
}

// ---- Statements and declarations ---------------------------------------------------------------

// What could begin an assignment but is followed by something else.
Description UnknownStatement(const Failure& failure) {
  if (failure.rule != TaskParser::RuleAssignment || failure.begin == nullptr) return std::nullopt;
  const antlr4::Token& begin = *failure.begin;
  const std::string name = begin.getText();
  const bool is_in_line =
      failure.before_begin != nullptr && failure.before_begin->getLine() == begin.getLine();
  const TokenType before = is_in_line ? failure.before_begin->getType() : 0;
  if (before == TaskParser::NUMBER) return UnknownUnit(begin);
  if (EndsOperand(before) && before != TaskParser::RIGHT_BRACE) {
    return MakeDiagnostic(
        code::kUnexpectedToken, SpanOf(begin),
        fmt::format("expected an operator or the end of the line, found `{}`", name));
  }
  if (failure.last != &begin) return ExpectedBehindLast(failure, "`=`");
  if (failure.type() == TaskParser::LEFT_PARENTHESIS) {
    return WithHelp(MakeDiagnostic(code::kUnknownStatement, SpanOf(begin),
                                   fmt::format("the value of `{}` is not used", name)),
                    fmt::format("name it, `let x = {}(...)`, or assign it to a memory", name));
  }
  std::vector<std::string> keywords = StatementKeywords();
  keywords.push_back(Spelling(TaskParser::ELSE));
  std::string help = DidYouMean(name, keywords);
  if (help.empty()) help = fmt::format("a memory is set by `{} = ...`", name);
  return WithHelp(MakeDiagnostic(code::kUnknownStatement, SpanOf(begin),
                                 fmt::format("there is no statement `{}`", name)),
                  help);
}

// In the loop over the statements of a block.
Description BadStatement(const Failure& failure) {
  if (failure.rule != TaskParser::RuleBlock ||
      !failure.parser.getExpectedTokens().contains(size_t{TaskParser::LET})) {
    return std::nullopt;
  }
  if (failure.type() == TaskParser::ELSE) {
    return WithHelp(
        MakeDiagnostic(code::kUnknownStatement, SpanOf(failure.found), "this `else` has no `if`"),
        "`else` follows the closing brace of an `if`");
  }
  if (IsDeclarationKeyword(failure.type())) {
    return WithHelp(
        MakeDiagnostic(code::kUnknownStatement, SpanOf(failure.found),
                       fmt::format("{} does not stand inside an event", FoundText(failure))),
        "move it out of the braces");
  }
  const bool goes_on = !failure.is_at_line_start() && EndsOperand(failure.last_type());
  return Expected(failure, goes_on ? "an operator or the end of the line" : "a statement or `}`");
}

// In the loop over the declarations of the file.
Description BadDeclaration(const Failure& failure) {
  if (failure.rule != TaskParser::RuleFile) return std::nullopt;
  if (failure.type() == TaskParser::TASK) {
    return WithHelp(
        MakeDiagnostic(code::kRepeatedHeader, SpanOf(failure.found), "a file holds one task"),
        "put the other task into a file of its own");
  }
  if (!failure.is_at_line_start() && failure.last_type() != TaskParser::RIGHT_BRACE) {
    return Expected(failure, "the end of the line");
  }
  const std::string word = failure.found.getText();
  if (IsStatementKeyword(failure.type()) || failure.type() == TaskParser::REWARD) {
    return WithHelp(MakeDiagnostic(code::kUnknownDeclaration, SpanOf(failure.found),
                                   fmt::format("`{}` stands only inside an event", word)),
                    "events are declared by `on EVENT { ... }`");
  }
  const std::vector<std::string> keywords = DeclarationKeywords();
  std::string help = DidYouMean(word, keywords);
  if (help.empty()) help = fmt::format("declarations begin with {}", fmt::join(keywords, ", "));
  return WithHelp(
      MakeDiagnostic(code::kUnknownDeclaration, SpanOf(failure.found),
                     fmt::format("expected a declaration, found {}", FoundText(failure))),
      help);
}

// ---- The rest: what the grammar allows ---------------------------------------------------------

std::string NameWanted(const Failure& failure) {
  if (failure.rule == TaskParser::RuleEnd) return "`success` or `failure`";
  if (failure.last_type() == TaskParser::PER) return "`run`, `episode` or `action`";
  switch (failure.parent_rule) {
    case TaskParser::RuleType:
      return "a type";
    case TaskParser::RuleEvent:
      return "an event";
    case TaskParser::RuleStart:
      return "a pose";
    default:
      return "a name";
  }
}

std::string TokenText(const Failure& failure, TokenType type) {
  switch (type) {
    case TaskParser::NAME:
      return NameWanted(failure);
    case TaskParser::NUMBER:
      return "a number";
    case TaskParser::STRING:
      return "a text in double quotes";
    case TaskParser::LINE_END:
    case antlr4::Token::EOF:
      return "the end of the line";
    default:
      return fmt::format("`{}`", Spelling(type));
  }
}

Diagnostic Unexpected(const Failure& failure) {
  std::vector<ssize_t> expected = failure.parser.getExpectedTokens().toList();
  // Where a word may stand, `min` may; that says nothing.
  if (std::ranges::count(expected, ssize_t{TaskParser::NAME}) > 0) {
    std::erase(expected, ssize_t{TaskParser::MIN});
  }
  // Both are the end of the line.
  if (std::ranges::count(expected, ssize_t{TaskParser::LINE_END}) > 0) {
    std::erase(expected, static_cast<ssize_t>(antlr4::Token::EOF));
  }
  constexpr size_t kMostNamed = 4;
  if (expected.empty() || expected.size() > kMostNamed) {
    return Expected(failure, EndsOperand(failure.last_type()) ? "an operator or the end of the line"
                                                              : "something else");
  }
  std::string what;
  for (size_t i = 0; i < expected.size(); ++i) {
    if (i > 0) what += i + 1 < expected.size() ? ", " : " or ";
    what += TokenText(failure, static_cast<TokenType>(expected[i]));
  }
  const bool is_sign = expected.size() == 1 && failure.last != nullptr &&
                       !Spelling(static_cast<TokenType>(expected.front())).empty();
  return is_sign ? ExpectedBehindLast(failure, what) : Expected(failure, what);
}

// The first that applies wins.
constexpr auto kDescriptions = {
    MissingHeader,    NumberWithoutDigits,
    MisplacedSet,     MissingEqualsInReward,
    ReservedName,     ChainedComparison,
    NameBehindNumber, BadCondition,
    BadUnit,          BadType,
    BadReward,        UnknownStatement,
    BadStatement,     BadDeclaration,
    MissingOperand,
};

}  // namespace

Diagnostic DescribeSyntaxError(antlr4::Parser& parser, antlr4::Token& found) {
  const Failure failure = MakeFailure(parser, found);
  for (const auto& description : kDescriptions) {
    if (auto diagnostic = description(failure)) return *diagnostic;
  }
  return Unexpected(failure);
}

}  // namespace compiler
