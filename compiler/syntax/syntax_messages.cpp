#include "compiler/syntax/syntax_messages.h"

#include <TaskParser.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/text/nearest_name.h"
#include "compiler/syntax/descriptions.h"
#include "compiler/syntax/syntax_failure.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {

Help Nearest(const antlr4::Token& word, const std::vector<std::string>& candidates) {
  const std::string name = word.getText();
  const auto nearest = text::NearestName(name, candidates);
  return nearest && *nearest != name ? DidYouMean(SpanOf(word), *nearest) : Help();
}

namespace {

using grammar::TaskParser;

std::string NameWanted(const Failure& failure) {
  if (failure.rule == TaskParser::RuleEnd) return "`success` or `failure`";
  if (failure.rule == TaskParser::RuleAfterEnd) return "`continue` or `stop`";
  if (failure.last_type() == TaskParser::PER) return "`run`, `episode` or `action`";
  switch (failure.parent_rule) {
    case TaskParser::RuleType:
      return "a type";
    case TaskParser::RuleEvent:
    case TaskParser::RuleFired:
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
      return "a string in double quotes";
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
    if (!EndsOperand(failure.last_type())) return Expected(failure, "something else");
    return WithHelp(Expected(failure, "an operator or the end of the line"),
                    HelpBehindOperand(failure));
  }
  std::string what;
  for (size_t i = 0; i < expected.size(); ++i) {
    if (i > 0) what += i + 1 < expected.size() ? ", " : " or ";
    what += TokenText(failure, static_cast<TokenType>(expected[i]));
  }
  const bool is_sign = expected.size() == 1 && failure.last != nullptr &&
                       !Spelling(static_cast<TokenType>(expected.front())).empty();
  Diagnostic diagnostic = is_sign ? ExpectedBehindLast(failure, what) : Expected(failure, what);
  if (EndsOperand(failure.last_type())) diagnostic.help = HelpBehindOperand(failure);
  return diagnostic;
}

// The first that applies wins.
constexpr auto kDescriptions = {
    MissingHeader,    BadHeader,        BadPath,          BadAllow,       NumberWithoutDigits,
    MisplacedSet,     MissingEquals,    ReservedName,     BadFire,        ChainedComparison,
    NameBehindNumber, BadCondition,     BadUnit,          BadType,        BadLoop,
    BadOnce,          BadReward,        BadLet,           BadEnd,         BadValue,
    BadFunction,      BadObservation,   BadPhase,         BadOverride,    UnknownStatement,
    BadStatement,     BadTestStatement, BadBodyStatement, BadDeclaration, MissingOperand,
};

}  // namespace

Diagnostic DescribeSyntaxError(antlr4::Parser& parser, antlr4::Token& found,
                               const SourceFile& file) {
  const Failure failure = MakeFailure(parser, found, file);
  for (const auto& description : kDescriptions) {
    if (auto diagnostic = description(failure)) return *diagnostic;
  }
  return Unexpected(failure);
}

}  // namespace compiler
