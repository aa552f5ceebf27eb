// Expressions as LaTeX.
//
// They come from the syntax tree rather than from the checked task: a reader of the equations wants
// `0.25 / 5 ms` and `links - feet` as the author wrote them, not the 50 and the list of numbers
// that checking makes of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// How tightly the outermost operator of a formula binds.
enum class Binding {
  kOr,
  kAnd,
  kNot,
  kComparison,
  kSum,
  kNegation,      // `-x`
  kInnerProduct,  // of vectors: its dot is not that of a product of numbers
  kProduct,
  kPower,
  kAtom
};

struct Formula {
  std::string text;
  Binding binding = Binding::kAtom;
  Binding behind_minus = Binding::kAtom;  // of a negation: of what is negated
};

Formula ToFormula(const Expression& expression);
// An index set: `links - feet`, `0..3`.
Formula ToFormula(const std::vector<ExpressionPtr>& items);
// What is assigned to.
Formula ToFormula(const Target& target);

// The formula as an operand: in parentheses where it binds more loosely than `least`.
std::string AtLeast(Binding least, const Formula& formula);

Formula Product(const Formula& left, const Formula& right);
Formula Power(const Formula& base, const std::string& exponent);
Formula Sum(const std::vector<Formula>& summands);  // of none: 0
Formula Quotient(const Formula& above, const Formula& below);
Formula Minus(const Formula& operand);
Formula Not(const Formula& condition);
Formula Conjunction(const std::vector<Formula>& conditions);  // at least one

// "fall_penalty" upright, one letter as a variable; `time` is t.
std::string NameToLatex(std::string_view name);
// Words inside a formula.
std::string TextToLatex(std::string_view text);
std::string NumberToLatex(double value);

// A call of a builtin or of the task's own function. There are arguments; how many has not been
// checked.
Formula CallFormula(std::string_view function, const std::vector<Formula>& arguments);

}  // namespace compiler
