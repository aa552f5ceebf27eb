// Syntax trees as text, so that the tests can say what they expect.
#pragma once

#include <string>

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// `a + b * c` is "(+ a (* b c))"; a unit stands in brackets: "20[s]", "[m s^-2]".
std::string ToText(const Expression& expression);
std::string ToText(const UnitExpression& unit);
std::string ToText(const TypeExpression& type);
// One statement: "let x 3", "reward rate fall (- 4)", "if a {...} else {...}".
std::string ToText(const Statement& statement);
std::string ToText(const Block& block);
// "given (at contact head) = true", "fire 100*end_of_time_step", "expect end failure 'fell'"
std::string ToText(const TestStatement& statement);

// Parse what must be well-formed; else the test fails and the messages are shown.
SyntaxTree ParseTask(const std::string& text);
// A task around one event whose block holds `statements`.
Block ParseBlock(const std::string& statements);
// The expression as text.
std::string ParseExpression(const std::string& expression);

// What is said of a task that is not well-formed, one line each: "E0101 3:7 expected ...".
std::string Errors(const std::string& text);

}  // namespace compiler
