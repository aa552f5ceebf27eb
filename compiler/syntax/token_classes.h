// What the tokens of the grammar have in common, as far as the grammar itself does not say it.
#pragma once

#include <antlr4-runtime.h>

#include <string>
#include <string_view>
#include <vector>

#include "compiler/source/source_file.h"

namespace compiler {

using TokenType = size_t;

Span SpanOf(const antlr4::Token& token);

// `+`, `and`, `<`, `=`, `,` ...: something must follow, so the line continues after it.
bool ExpectsOperand(TokenType type);
// What may follow an operand and continue with it: operators, `.`, `[`, `(`, `:` ...
bool FollowsOperand(TokenType type);
bool IsComparison(TokenType type);
bool IsAssignment(TokenType type);
// Names, numbers, closing brackets ...: what an expression or a declaration can end with.
bool EndsOperand(TokenType type);
// Names, numbers, `not` ...; no bracket, since those also follow an operand.
bool StartsOperand(TokenType type);

// `param`, `on` ...: begin a declaration and stand nowhere else.
bool IsDeclarationKeyword(TokenType type);
// `let`, `if`, `end_episode` ...: begin a statement, in an event or a test or a function. `reward`
// does not count.
bool IsStatementKeyword(TokenType type);
// `log`, `test`, `given` ...: keywords only where a statement or declaration begins, else names.
bool IsContextualKeyword(TokenType type);
bool IsUnit(TokenType type);
// Any keyword or unit.
bool IsReserved(TokenType type);

// Of brackets of all three kinds.
bool IsOpening(TokenType type);
bool IsClosing(TokenType type);

// The fixed spelling of a token, without quotes; empty if it has none.
std::string Spelling(TokenType type);
// The same as messages show it: "`{`".
std::string Quoted(TokenType type);

std::vector<std::string> DeclarationKeywords();
std::vector<std::string> StatementKeywords();
std::vector<std::string> UnitNames();

}  // namespace compiler
