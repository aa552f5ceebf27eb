// The kinds of syntax errors. Each function looks at a failure and describes it if it is of that
// kind; syntax_messages.cpp asks them in turn.
#pragma once

#include <optional>
#include <string>
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

Diagnostic UnknownUnit(const Failure& failure, const antlr4::Token& token);
// What was probably meant by what stands behind a whole operand, where an operator would have to.
Help HelpBehindOperand(const Failure& failure);

// ---- Statements ---------------------------------------------------------------------------------

Description BadLet(const Failure& failure);
Description BadEnd(const Failure& failure);
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
Description BadObservation(const Failure& failure);
Description BadValue(const Failure& failure);
Description BadAllow(const Failure& failure);
Description BadPhase(const Failure& failure);
Description BadDeclaration(const Failure& failure);

// "did you mean `x`?", or nothing.
Help Nearest(const antlr4::Token& word, const std::vector<std::string>& candidates);

}  // namespace compiler
