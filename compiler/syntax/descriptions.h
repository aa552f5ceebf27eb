// The kinds of syntax errors. Each function looks at a failure and describes it if it is of that
// kind; syntax_messages.cpp asks them in turn.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_failure.h"

namespace compiler {

using Description = std::optional<Diagnostic>;

// ---- Names, operands and units ------------------------------------------------------------------

Description ReservedName(const Failure& failure);
Description MisplacedSet(const Failure& failure);
Description ChainedComparison(const Failure& failure);
Description NumberWithoutDigits(const Failure& failure);
Description NameBehindNumber(const Failure& failure);
Description BadUnit(const Failure& failure);
Description BadType(const Failure& failure);
Description MissingOperand(const Failure& failure);

Diagnostic UnknownUnit(const antlr4::Token& token);

// ---- Statements ---------------------------------------------------------------------------------

Description BadCondition(const Failure& failure);
Description BadLoop(const Failure& failure);
Description BadOnce(const Failure& failure);
Description MissingEquals(const Failure& failure);
Description BadReward(const Failure& failure);
Description BadFire(const Failure& failure);
Description UnknownStatement(const Failure& failure);
Description BadStatement(const Failure& failure);
Description BadTestStatement(const Failure& failure);
Description BadBodyStatement(const Failure& failure);

// ---- Declarations -------------------------------------------------------------------------------

Description MissingHeader(const Failure& failure);
Description BadHeader(const Failure& failure);
Description BadFunction(const Failure& failure);
Description BadOverride(const Failure& failure);
Description BadPath(const Failure& failure);
Description BadAllow(const Failure& failure);
Description BadDeclaration(const Failure& failure);

// A word of other languages, and what is written here.
struct ForeignWord {
  std::string_view text;
  std::string_view help;
  std::string_view instead = "";  // the word itself; empty where more has to change
};
// The help for such a word; empty where it is none of these.
Help HelpForForeign(const antlr4::Token& word, std::span<const ForeignWord> words);

// "did you mean `x`?", or nothing.
Help Nearest(const antlr4::Token& word, const std::vector<std::string>& candidates);

}  // namespace compiler
