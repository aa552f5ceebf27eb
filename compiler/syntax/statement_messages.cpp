// Messages about statements: of events, tests and functions.
#include <TaskParser.h>
#include <fmt/format.h>

#include <string>
#include <vector>

#include "base/text/nearest_name.h"
#include "compiler/syntax/descriptions.h"
#include "compiler/syntax/foreign_words.h"
#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

using grammar::TaskParser;

// `terminate "falls"`, `elif`: a word of other languages. Only with a reason behind it a word can
// be replaced by one that ends the episode.
Help HelpForForeignStatement(const Failure& failure, const antlr4::Token& word) {
  Help help = HelpForForeign(ForeignPlace::kStatement, word.getText(), SpanOf(word));
  const bool is_end =
      !help.fixes.empty() && help.fixes.front().text.find("_episode") != std::string::npos;
  if (is_end && failure.type() != TaskParser::STRING) help.fixes.clear();
  return help;
}

// `a = 1` where `a == 1` is meant.
Help Comparison(const Failure& failure) {
  return {"to compare, write `==`", {{SpanOf(failure.found), "=="}}};
}

Diagnostic Misplaced(const Failure& failure, const std::string& where, std::string help) {
  return WithHelp(MakeDiagnostic(code::kUnknownStatement, SpanOf(failure.found),
                                 fmt::format("{} {}", FoundText(failure), where)),
                  std::move(help));
}

Diagnostic StrayElse(const Failure& failure) {
  return WithHelp(
      MakeDiagnostic(code::kUnknownStatement, SpanOf(failure.found), "this `else` has no `if`"),
      "`else` follows the closing brace of an `if`");
}

// In the loop over the statements of a block, behind what could be the end of one.
Diagnostic BadEndOfStatement(const Failure& failure) {
  if (failure.statement_type() == TaskParser::FIRE) {
    Diagnostic diagnostic = Expected(failure, "`,` or the end of the line");
    if (failure.type() == TaskParser::TIMES) {
      diagnostic.help = "how often comes first: `100 * end_of_time_step`";
    }
    return diagnostic;
  }
  Diagnostic diagnostic = Expected(failure, "an operator or the end of the line");
  diagnostic.help = HelpBehindOperand(failure);
  const bool is_condition = failure.statement_type() == TaskParser::REQUIRE ||
                            failure.statement_type() == TaskParser::EXPECT ||
                            failure.statement_type() == TaskParser::RETURN;
  if (is_condition && failure.type() == TaskParser::ASSIGN) diagnostic.help = Comparison(failure);
  return diagnostic;
}

// `log speed base.velocity`: `speed` is no reduction, so it is the name.
bool IsNameInsteadOfKind(const Failure& failure) {
  if (failure.before_last == failure.begin) return false;
  std::vector<std::string> kinds;
  if (failure.rule == TaskParser::RuleLog) {
    for (const auto& word : kReductionNames) kinds.emplace_back(word.text);
  } else {
    for (const auto& word : kRewardKindNames) kinds.emplace_back(word.text);
  }
  return !text::NearestName(failure.before_last->getText(), kinds);
}

bool GoesOn(const Failure& failure) {
  return !failure.is_at_line_start() && EndsOperand(failure.last_type()) &&
         failure.last_type() != TaskParser::RIGHT_BRACE;
}

// The `if` of the statement stands behind a value: `1 if a else 2`.
bool IsBehindValue(const Failure& failure) {
  if (failure.statement_type() == TaskParser::IF) return false;
  antlr4::TokenStream& tokens = *failure.parser.getTokenStream();
  size_t index = failure.found.getTokenIndex();
  while (index > 0 && tokens.get(index)->getType() != TaskParser::IF) --index;
  const antlr4::Token* before = index > 0 ? tokens.get(index - 1) : nullptr;
  return before != nullptr && before->getLine() == failure.found.getLine() &&
         EndsOperand(before->getType()) && before->getType() != TaskParser::RIGHT_BRACE;
}

Diagnostic ForeignChoice(const Failure& failure) {
  return WithHelp(MakeDiagnostic(code::kForeignSyntax, SpanOf(failure.found),
                                 "a choice between two values is not written with `else`"),
                  "write `select(condition, x, y)`: `x` where the condition holds, else `y`");
}

}  // namespace

// `let mut y = 4`, `let y: real = 4`, `let y`
Description BadLet(const Failure& failure) {
  if (failure.rule != TaskParser::RuleLet || failure.last_type() != TaskParser::NAME) {
    return std::nullopt;
  }
  Diagnostic diagnostic = ExpectedBehindLast(failure, "`=`");
  const std::string name = failure.last->getText();
  const ForeignWord* foreign = FindForeign(ForeignPlace::kStatement, name);
  if (failure.type() == TaskParser::COLON) {
    diagnostic.help = fmt::format(
        "write `let {} = ...`: a local value has the type of what it is computed from", name);
  } else if (failure.type() == TaskParser::NAME && foreign != nullptr) {
    diagnostic.help = {
        fmt::format("leave out `{}`; what changes is a `memory`, declared outside of "
                    "events",
                    name),
        {{{SpanOf(*failure.last).begin, SpanOf(failure.found).begin}, ""}}};
  } else if (failure.is_behind_last()) {
    diagnostic.help = "a local value has its value from the beginning and keeps it";
  }
  return diagnostic;
}

// `end_episode "falls"`, `truncate_episode`
Description BadEnd(const Failure& failure) {
  if (failure.rule != TaskParser::RuleEnd) return std::nullopt;
  const bool is_truncation = failure.last_type() == TaskParser::TRUNCATE_EPISODE;
  if (failure.last_type() == TaskParser::END_EPISODE) {
    const uint32_t place = SpanOf(*failure.last).end;
    Diagnostic diagnostic = Expected(failure, "`success` or `failure`");
    diagnostic.help = "say how it ends: `end_episode failure \"falls down\"`";
    if (failure.type() == TaskParser::STRING)
      diagnostic.help.fixes = {{{place, place}, " failure"}, {{place, place}, " success"}};
    return diagnostic;
  }
  return WithHelp(Expected(failure, "a string in double quotes"),
                  is_truncation ? "say why: `truncate_episode \"time is up\"`"
                                : "say why: `end_episode failure \"falls down\"`");
}

Description BadCondition(const Failure& failure) {
  if (failure.rule == TaskParser::RuleBranches && failure.last_type() == TaskParser::ELSE) {
    return Expected(failure, "`if` or `{`");
  }
  const bool has_head = failure.parent_rule == TaskParser::RuleBranches ||
                        failure.parent_rule == TaskParser::RuleLoop ||
                        failure.parent_rule == TaskParser::RuleOnce;
  const bool is_behind_head =
      failure.rule == TaskParser::RuleBlock && has_head && failure.expects(TaskParser::LEFT_BRACE);
  if (!is_behind_head || !EndsOperand(failure.last_type())) return std::nullopt;
  if (failure.type() == TaskParser::ELSE && IsBehindValue(failure)) return ForeignChoice(failure);
  Diagnostic diagnostic = Expected(failure, "an operator or `{`");
  diagnostic.help = HelpBehindOperand(failure);
  if (failure.type() == TaskParser::ASSIGN) diagnostic.help = Comparison(failure);
  return diagnostic;
}

Description BadLoop(const Failure& failure) {
  const bool is_variable =
      failure.rule == TaskParser::RuleName && failure.parent_rule == TaskParser::RuleLoop;
  if (failure.rule != TaskParser::RuleLoop && !is_variable) return std::nullopt;
  return WithHelp(Expected(failure, is_variable ? "a name" : "`in`"),
                  "a loop iterates over a set: `for i in 0..3 { ... }`");
}

Description BadOnce(const Failure& failure) {
  if (failure.rule != TaskParser::RuleOnce) return std::nullopt;
  std::string what = "`if`";
  if (failure.last_type() == TaskParser::ONCE) what = "`per`";
  if (failure.last_type() == TaskParser::PER) what = "`action`, `episode` or `run`";
  return WithHelp(Expected(failure, what), "write `once per action if CONDITION { ... }`");
}

// `reward fall -4`, `log speed 3`: what is found lies behind the place at which the grammar stands.
Description MissingEquals(const Failure& failure) {
  if (failure.rule == TaskParser::RuleGiven && EndsOperand(failure.last_type())) {
    if (!IsComparison(failure.type()) && !IsAssignment(failure.type())) {
      return ExpectedBehindLast(failure, "`=`");
    }
    return WithHelp(Expected(failure, "`=`"), "`given` sets a value, for the test to begin with");
  }
  const bool is_term =
      failure.rule == TaskParser::RuleReward || failure.rule == TaskParser::RuleLog;
  if (!is_term || failure.last_type() != TaskParser::NAME) return std::nullopt;
  if (IsReserved(failure.type()) && !failure.is_behind_last()) return std::nullopt;
  if (IsAssignment(failure.type())) {
    return WithHelp(Expected(failure, "`=`"),
                    {"a term may be paid in several places, and each adds to it: write `=`",
                     {{SpanOf(failure.found), "="}}});
  }
  if (!IsNameInsteadOfKind(failure)) return ExpectedBehindLast(failure, "`=`");
  const uint32_t place = SpanOf(*failure.before_last).end;
  return MakeDiagnostic(code::kUnexpectedToken, {place, place},
                        fmt::format("expected `=`, found `{}`", failure.last->getText()));
}

Description BadReward(const Failure& failure) {
  // `reward += 1` outside of all blocks
  const bool is_added = failure.last_type() == TaskParser::REWARD && IsAssignment(failure.type());
  if (is_added && failure.rule != TaskParser::RuleStatement) {
    return WithHelp(MakeDiagnostic(code::kUnknownDeclaration, SpanOf(*failure.last),
                                   "`reward` is allowed only inside an event"),
                    "events are declared with `on EVENT { ... }`");
  }
  if (failure.rule != TaskParser::RuleStatement || failure.last_type() != TaskParser::REWARD) {
    return std::nullopt;
  }
  return Expected(failure, "the name of a term, or `+=`");
}

Description BadFire(const Failure& failure) {
  if (failure.rule != TaskParser::RuleFired && failure.rule != TaskParser::RuleFire) {
    return std::nullopt;
  }
  if (failure.last_type() == TaskParser::NUMBER) return ExpectedBehindLast(failure, "`*`");
  return WithHelp(Expected(failure, "an event"), "for example `fire 100 * end_of_time_step`");
}

// What could begin an assignment but is followed by something else.
Description UnknownStatement(const Failure& failure) {
  if (failure.rule != TaskParser::RuleAssignment || failure.begin == nullptr) return std::nullopt;
  const antlr4::Token& begin = *failure.begin;
  const std::string name = begin.getText();
  const bool is_in_line =
      failure.before_begin != nullptr && failure.before_begin->getLine() == begin.getLine();
  const TokenType before = is_in_line ? failure.before_begin->getType() : 0;
  if (before == TaskParser::NUMBER) return UnknownUnit(failure, begin);
  if (EndsOperand(before) && before != TaskParser::RIGHT_BRACE) {
    return WithHelp(
        MakeDiagnostic(
            code::kUnexpectedToken, SpanOf(begin),
            fmt::format("expected an operator or the end of the line, found `{}`", name)),
        HelpForForeign(ForeignPlace::kOperator, name, SpanOf(begin)));
  }
  if (failure.last != &begin) return ExpectedBehindLast(failure, "`=`");
  const bool is_decrement =
      failure.type() == TaskParser::MINUS && failure.next_type() == TaskParser::MINUS;
  if (is_decrement) {
    const Span signs = Cover(SpanOf(failure.found), SpanOf(*failure.next));
    return WithHelp(
        MakeDiagnostic(code::kForeignSyntax, signs, "`--` is not part of the task language"),
        {fmt::format("write `{} -= 1`", name), {{signs, " -= 1"}}});
  }
  if (failure.type() == TaskParser::COLON) {
    return WithHelp(Expected(failure, "`=`"),
                    fmt::format("a local value is `let {} = ...`, without a type", name));
  }
  Help help = HelpForForeignStatement(failure, begin);
  if (help.empty() && failure.type() == TaskParser::LEFT_PARENTHESIS) {
    return WithHelp(MakeDiagnostic(code::kUnknownStatement, SpanOf(begin),
                                   fmt::format("the value of `{}` is not used", name)),
                    fmt::format("name it, `let x = {}(...)`, or assign it to a memory", name));
  }
  std::vector<std::string> keywords = StatementKeywords();
  keywords.push_back(Spelling(TaskParser::ELSE));
  if (help.empty()) help = Nearest(begin, keywords);
  if (help.empty()) help = fmt::format("a memory is set with `{} = ...`", name);
  return WithHelp(MakeDiagnostic(code::kUnknownStatement, SpanOf(begin),
                                 fmt::format("there is no statement `{}`", name)),
                  help);
}

// In the loop over the statements of a block.
Description BadStatement(const Failure& failure) {
  if (failure.rule != TaskParser::RuleBlock || !failure.expects(TaskParser::LET)) {
    return std::nullopt;
  }
  switch (failure.type()) {
    case TaskParser::ELSE:
      return StrayElse(failure);
    case TaskParser::GIVEN:
    case TaskParser::FIRE:
    case TaskParser::EXPECT:
      return Misplaced(failure, "is allowed only in a test",
                       "tests are declared with `test \"...\" { ... }`");
    case TaskParser::RETURN:
      return Misplaced(failure, "is allowed only in a function",
                       "an event runs to its end: put what is skipped into an `if`");
    default:
      break;
  }
  if (failure.type() == TaskParser::CONST) {
    Diagnostic diagnostic = Misplaced(failure, "is not allowed inside an event", "");
    diagnostic.help = {"a value of this block is `let x = ...`; a `const` is declared outside",
                       {{SpanOf(failure.found), "let"}}};
    return diagnostic;
  }
  if (IsDeclarationKeyword(failure.type())) {
    return Misplaced(failure, "is not allowed inside an event", "move it out of the braces");
  }
  if (GoesOn(failure)) return BadEndOfStatement(failure);
  return Expected(failure, "a statement or `}`");
}

Description BadTestStatement(const Failure& failure) {
  if (failure.rule != TaskParser::RuleTestBlock || !failure.expects(TaskParser::GIVEN)) {
    return std::nullopt;
  }
  if (GoesOn(failure) && failure.type() != TaskParser::NAME) return BadEndOfStatement(failure);
  const std::string help = "a test holds `given`, `fire` and `expect`";
  if (IsReserved(failure.type())) return Misplaced(failure, "is not allowed in a test", help);
  if (failure.type() != TaskParser::NAME) return Expected(failure, "a statement or `}`");
  const Help guess = Nearest(
      failure.found,
      {Spelling(TaskParser::GIVEN), Spelling(TaskParser::FIRE), Spelling(TaskParser::EXPECT)});
  if (guess.empty() && GoesOn(failure)) return BadEndOfStatement(failure);
  return WithHelp(Expected(failure, "a statement of a test"), guess.empty() ? Help(help) : guess);
}

Description BadBodyStatement(const Failure& failure) {
  if (failure.rule != TaskParser::RuleBody || !failure.expects(TaskParser::LET)) {
    return std::nullopt;
  }
  const bool is_reserved = IsReserved(failure.type());
  if (GoesOn(failure) && !is_reserved) return BadEndOfStatement(failure);
  const std::string help = "a function is `let`s and one `return`, and changes nothing";
  const Help guess =
      Nearest(failure.found, {Spelling(TaskParser::LET), Spelling(TaskParser::RETURN)});
  return WithHelp(
      MakeDiagnostic(code::kBadFunctionBody, SpanOf(failure.found),
                     is_reserved
                         ? fmt::format("{} is not allowed in a function", FoundText(failure))
                         : fmt::format("expected `let` or `return`, found {}", FoundText(failure))),
      guess.empty() || is_reserved ? Help(help) : guess);
}

}  // namespace compiler
