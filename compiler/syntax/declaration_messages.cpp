// Messages about the header and declarations.
#include <TaskParser.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/syntax/descriptions.h"
#include "compiler/syntax/foreign_words.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using grammar::TaskParser;

constexpr std::string_view kFunctionHelp =
    "a function is declared with `fn half(x: real) -> real = 0.5 * x`";
constexpr std::string_view kTableHelp =
    "a table is declared with `table height: real [m] = \"walk.csv\"`";
// What may follow `override`.
constexpr std::array kOverridable = {"start", "after_end", "param",   "const",  "set",
                                     "table", "goal",      "observe", "metric", "reward",
                                     "on",    "phase",     "fn"};

// "`start`, `param` or `fn`"
std::string ListOfOverridable(std::string_view conjunction) {
  std::string list;
  for (const char* word : kOverridable) {
    const bool is_last = word == kOverridable.back();
    if (!list.empty()) list += is_last ? fmt::format(" {} ", conjunction) : ", ";
    list += fmt::format("`{}`", word);
  }
  return list;
}

constexpr const char* kHeaderHelp =
    "a file begins with the task's name and its robot: `task crawling for humanoid`";

constexpr const char* kWorldHelp = "the world is named by its file: `in \"FILE.toml\"`";

Help HelpForDeclaration(const antlr4::Token& word) {
  Help help = HelpForForeign(ForeignPlace::kDeclaration, word.getText(), SpanOf(word));
  const std::vector<std::string> keywords = DeclarationKeywords();
  if (help.empty()) help = Nearest(word, keywords);
  if (help.empty()) help = fmt::format("declarations begin with {}", fmt::join(keywords, ", "));
  return help;
}

// `wrong`: the word in the place of `for`.
Help RobotIs(const std::string& name, Span wrong) {
  return {fmt::format("the robot is named with `for {}`", name), {{wrong, "for"}}};
}

bool IsOfTable(const Failure& failure) {
  return failure.rule == TaskParser::RuleTable || failure.rule == TaskParser::RuleNewTable;
}

std::string PlaceOfStatement(TokenType type) {
  switch (type) {
    case TaskParser::GIVEN:
    case TaskParser::FIRE:
    case TaskParser::EXPECT:
      return "inside a test";
    case TaskParser::RETURN:
      return "inside a function";
    default:
      return "inside an event";
  }
}

std::string HelpForStatement(TokenType type) {
  switch (type) {
    case TaskParser::GIVEN:
    case TaskParser::FIRE:
    case TaskParser::EXPECT:
      return "tests are declared with `test \"...\" { ... }`";
    case TaskParser::RETURN:
      return std::string(kFunctionHelp);
    default:
      return "events are declared with `on EVENT { ... }`";
  }
}

// `start standing, lying`
Help HelpBehindDeclaration(const Failure& failure) {
  const bool is_list = failure.type() == TaskParser::COMMA || failure.type() == TaskParser::AND;
  if (failure.statement_type() != TaskParser::START || !is_list) return {};
  const Span sign = SpanOf(failure.found);
  const char* text = failure.type() == TaskParser::COMMA ? " or" : "or";
  return {"several poses are written with `or` between them", {{sign, text}}};
}

// `table gait = "walk.csv"`, `table gait: real "walk.csv"`
Description TableWithoutTypeOrFile(const Failure& failure) {
  for (const TokenType sign : {TaskParser::COLON, TaskParser::ASSIGN})
    if (failure.expects(sign))
      return WithHelp(ExpectedBehindLast(failure, fmt::format("`{}`", Spelling(sign))),
                      std::string(kTableHelp));
  return std::nullopt;
}

}  // namespace

Description MissingHeader(const Failure& failure) {
  if (failure.rule != TaskParser::RuleFile || failure.last != nullptr) return std::nullopt;
  std::vector<std::string> keywords = DeclarationKeywords();
  keywords.insert(keywords.begin(), Spelling(TaskParser::TASK));
  const Help guess = Nearest(failure.found, keywords);
  const Help task = Nearest(failure.found, {keywords.front()});
  if (guess.text != task.text) return std::nullopt;
  return WithHelp(MakeDiagnostic(code::kMissingHeader, SpanOf(failure.found),
                                 fmt::format("expected `task NAME`, found {}", FoundText(failure))),
                  {kHeaderHelp, task.fixes});
}

Description BadHeader(const Failure& failure) {
  if (failure.statement_type() != TaskParser::TASK) return std::nullopt;
  // `task crawling on humanoid`
  const bool is_event = failure.rule == TaskParser::RuleBlock &&
                        failure.parent_rule == TaskParser::RuleEvent &&
                        failure.before_last->getType() == TaskParser::ON;
  if (is_event) {
    const Span on = SpanOf(*failure.before_last);
    return WithHelp(MakeDiagnostic(code::kUnexpectedToken, on,
                                   "expected `for` or the end of the line, found `on`"),
                    RobotIs(failure.last->getText(), on));
  }
  if (failure.rule != TaskParser::RuleFile || failure.is_at_line_start()) return std::nullopt;
  if (failure.type() == TaskParser::EXTENDS) {
    return WithHelp(Expected(failure, "the end of the line"), "`extends` comes before `for`");
  }
  if (failure.before_last->getType() == TaskParser::IN || failure.last_type() == TaskParser::STRING)
    return Expected(failure, "the end of the line");
  const bool has_robot = failure.before_last->getType() == TaskParser::FOR;
  if (has_robot) {
    Diagnostic diagnostic = Expected(failure, "`in` or the end of the line");
    const bool is_world = failure.next_type() == TaskParser::STRING;
    if (is_world) diagnostic.help = {std::string(kWorldHelp), {{SpanOf(failure.found), "in"}}};
    return diagnostic;
  }
  Diagnostic diagnostic = Expected(failure, "`for`, `extends` or the end of the line");
  if (failure.next_type() == TaskParser::STRING) {
    diagnostic.help = {fmt::format("did you mean `extends {}`?", failure.next->getText()),
                       {{SpanOf(failure.found), "extends"}}};
  } else if (failure.next_type() == TaskParser::NAME) {
    diagnostic.help = RobotIs(failure.next->getText(), SpanOf(failure.found));
  }
  return diagnostic;
}

Description BadFunction(const Failure& failure) {
  std::string what;
  if (failure.rule == TaskParser::RuleParameter) {
    what = "`:` and a type";
  } else if (failure.rule == TaskParser::RuleFunction) {
    if (failure.expects(TaskParser::ARROW)) what = "`->` and the type of the result";
    if (failure.expects(TaskParser::LEFT_PARENTHESIS)) what = "`(`";
    if (failure.expects(TaskParser::ASSIGN)) what = "`=` or `{`";
  }
  if (what.empty()) return std::nullopt;
  return WithHelp(Expected(failure, what), std::string(kFunctionHelp));
}

Description BadOverride(const Failure& failure) {
  const bool is_value = failure.rule == TaskParser::RuleNewDefault ||
                        failure.rule == TaskParser::RuleNewConstant ||
                        failure.rule == TaskParser::RuleNewTable;
  if (is_value && failure.type() == TaskParser::COLON) {
    const std::string kind = failure.before_last->getText();
    return WithHelp(
        MakeDiagnostic(code::kBadOverride, SpanOf(failure.found),
                       fmt::format("a {} keeps the type and the unit that it has", kind)),
        fmt::format("write `override {} {} = ...`", kind, failure.last->getText()));
  }
  if (failure.rule != TaskParser::RuleChange || failure.last_type() != TaskParser::OVERRIDE) {
    return std::nullopt;
  }
  const std::string word = failure.found.getText();
  if (IsReserved(failure.type())) {
    return WithHelp(MakeDiagnostic(code::kBadOverride, SpanOf(failure.found),
                                   fmt::format("`{}` cannot be overridden", word)),
                    fmt::format("only {} can", ListOfOverridable("and")));
  }
  Diagnostic diagnostic = Expected(failure, ListOfOverridable("or"));
  if (failure.type() != TaskParser::NAME) return diagnostic;
  diagnostic.help = Nearest(failure.found, {kOverridable.begin(), kOverridable.end()});
  if (failure.next_type() == TaskParser::ASSIGN) {
    diagnostic.help = {fmt::format("say what it is: `override param {} = ...`", word),
                       {{SpanOf(failure.found), "param " + word}}};
  }
  return diagnostic;
}

// `param gain = 3`, `memory fallen: bool`: without a type, without a value
Description BadValue(const Failure& failure) {
  if (failure.rule == TaskParser::RuleTable) return TableWithoutTypeOrFile(failure);
  const bool is_value =
      failure.rule == TaskParser::RuleParam || failure.rule == TaskParser::RuleMemory;
  if (!is_value) return std::nullopt;
  if (failure.type() == TaskParser::ASSIGN && failure.expects(TaskParser::COLON)) {
    const Span place = PlaceBehindLast(failure);
    return WithHelp(ExpectedBehindLast(failure, "`:`"),
                    {"its type comes first, such as `: real` or `: bool`",
                     {{place, ": real"}, {place, ": bool"}}});
  }
  if (!failure.is_behind_last() || !failure.expects(TaskParser::ASSIGN)) return std::nullopt;
  return WithHelp(ExpectedBehindLast(failure, "`=`"),
                  "everything has a value from the beginning, such as `= 0` or `= false`");
}

// `observe`, `observe clock: real = ...`, `observe a, b`, `override observe base.up`
Description BadObservation(const Failure& failure) {
  if (failure.rule == TaskParser::RuleNewObservation && failure.expects(TaskParser::ASSIGN)) {
    return WithHelp(ExpectedBehindLast(failure, "`=`"),
                    "say what is seen in its place: `override observe NAME = ...`");
  }
  if (failure.rule == TaskParser::RuleObservation && failure.last_type() == TaskParser::OBSERVE) {
    return WithHelp(Expected(failure, "a value"),
                    "say what the learner sees: `observe base.up`, `observe NAME = ...`");
  }
  if (failure.statement_type() != TaskParser::OBSERVE) return std::nullopt;
  if (failure.type() == TaskParser::COLON) {
    return WithHelp(Expected(failure, "`=` or the end of the line"),
                    "an observation has the type of its value: `observe NAME = ...`");
  }
  if (failure.type() == TaskParser::ASSIGN) {
    return WithHelp(Expected(failure, "the end of the line"),
                    "an observation is named like a sensor: `observe NAME = ...`");
  }
  if (failure.type() != TaskParser::COMMA || failure.rule != TaskParser::RuleFile) {
    return std::nullopt;
  }
  return WithHelp(Expected(failure, "the end of the line"),
                  "each observation stands in a line of its own");
}

// `import shaping`, `extends forward_rolling`, `table gait: real = walk.csv`, `test falls`,
// `task kick for humanoid in ball`
Description BadPath(const Failure& failure) {
  std::string_view ending = "task";
  switch (failure.last_type()) {
    case TaskParser::IMPORT:
    case TaskParser::EXTENDS:
      break;
    case TaskParser::TEST:
      return WithHelp(Expected(failure, "the test's name in double quotes"),
                      "for example `test \"a fall is paid once\" { ... }`");
    case TaskParser::ASSIGN:
      if (!IsOfTable(failure)) return std::nullopt;
      ending = "csv";
      break;
    case TaskParser::IN:
      if (failure.rule != TaskParser::RuleHeader) return std::nullopt;
      ending = "toml";
      break;
    default:
      return std::nullopt;
  }
  Diagnostic diagnostic = Expected(failure, "a file in double quotes");
  const bool is_name = failure.type() == TaskParser::NAME;
  const std::string file =
      fmt::format("\"{}.{}\"", is_name ? failure.found.getText() : "NAME", ending);
  diagnostic.help = fmt::format("write `{} {}`", failure.last->getText(), file);
  const bool is_whole = failure.next_type() != TaskParser::DOT;
  if (is_name && is_whole) diagnostic.help.fixes = {{SpanOf(failure.found), file}};
  return diagnostic;
}

// `phase lift until 3 s`, `phase lift within 3 s {`, `next`
Description BadPhase(const Failure& failure) {
  const bool is_part =
      failure.rule == TaskParser::RuleName ||
      (failure.rule == TaskParser::RuleBlock && failure.expects(TaskParser::LEFT_BRACE));
  const size_t rule = is_part ? failure.parent_rule : failure.rule;
  const bool is_name = failure.expects(TaskParser::NAME);
  if (rule == TaskParser::RuleTransition)
    return WithHelp(Expected(failure, "the name of a phase"), "for example `next lift`");
  if (rule == TaskParser::RuleLimit)
    return WithHelp(Expected(failure, is_name ? "the name of a phase" : "`else` and a phase"),
                    "say what comes when the time is over: `phase lift within 3 s else reach`");
  if (rule != TaskParser::RulePhase) return std::nullopt;
  if (is_name) return WithHelp(Expected(failure, "a name"), "for example `phase lift { ... }`");
  const bool is_behind_name =
      failure.before_last != nullptr && failure.before_last->getType() == TaskParser::PHASE;
  return WithHelp(Expected(failure, is_behind_name ? "`within` or `{`" : "`{`"),
                  "write `phase lift { ... }`, or `phase lift within 3 s else reach { ... }`");
}

Description BadAllow(const Failure& failure) {
  if (failure.rule != TaskParser::RuleAllow) return std::nullopt;
  if (failure.last_type() == TaskParser::NAME) {
    return Expected(failure, "`,` or the end of the line");
  }
  return WithHelp(Expected(failure, "the code of a warning"), "for example `allow W0706`");
}

// In the loop over the declarations of the file.
Description BadDeclaration(const Failure& failure) {
  if (failure.rule != TaskParser::RuleFile) return std::nullopt;
  if (!failure.is_at_line_start() && failure.last_type() != TaskParser::RIGHT_BRACE) {
    return WithHelp(Expected(failure, "the end of the line"), HelpBehindDeclaration(failure));
  }
  const std::string word = failure.found.getText();
  if (failure.type() == TaskParser::EXTENDS) {
    return WithHelp(MakeDiagnostic(code::kUnknownDeclaration, SpanOf(failure.found),
                                   "`extends` is allowed only in the header"),
                    "write `task NAME extends \"BASE.task\"`");
  }
  if (IsStatementKeyword(failure.type()) || failure.type() == TaskParser::REWARD) {
    return WithHelp(MakeDiagnostic(code::kUnknownDeclaration, SpanOf(failure.found),
                                   fmt::format("`{}` is allowed only {}", word,
                                               PlaceOfStatement(failure.type()))),
                    HelpForStatement(failure.type()));
  }
  return WithHelp(
      MakeDiagnostic(code::kUnknownDeclaration, SpanOf(failure.found),
                     fmt::format("expected a declaration, found {}", FoundText(failure))),
      HelpForDeclaration(failure.found));
}

}  // namespace compiler
