// What an expression means, as text: two expressions of two tasks that mean the same have the same
// text, however they are laid out and whatever their local values and functions are called.
//
// Local values stand there as what they are, and calls of the task's own functions as what these
// compute. Numbers are in SI units, elements are named by their links, joints and sites.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/enumeration.h"

namespace compiler {

// How tightly the outermost operator of a text binds; see grammar/Task.g4.
enum class TextBinding { kOr, kAnd, kNot, kComparison, kSum, kProduct, kMinus, kAtom };

struct ExpressionText {
  std::string text;
  TextBinding binding = TextBinding::kAtom;
  // It reads what statements of the same callback change: where it is computed matters.
  bool is_changing = false;
};

class ExpressionWriter {
 public:
  // Refers to both, which must outlive it.
  ExpressionWriter(const CheckedTask& task, const std::vector<Enumeration>& enumerations);

  ExpressionText Write(const CheckedExpression& expression);
  std::string Text(const CheckedExpression& expression) { return Write(expression).text; }

  // An event, whose local values are then given one after the other. `changed`: the memory that
  // its statements assign to.
  void Begin(std::set<uint32_t> changed);
  void SetLocal(uint32_t local, ExpressionText text) { locals_[local] = std::move(text); }

  // "[left_foot, right_foot]" behind a value of this type; "" for all elements.
  std::string SelectionText(const Type& type, const std::vector<uint32_t>& elements) const;

 private:
  class Visitor;
  using Texts = std::map<uint32_t, ExpressionText>;

  ExpressionText WriteCall(const FunctionCall& call);
  ExpressionText WriteMemory(uint32_t memory);
  std::string EntryText(const Type& type, uint32_t entry) const;

  const CheckedTask& task_;
  const std::vector<Enumeration>& enumerations_;
  std::map<uint32_t, const CheckedAdvance*> time_functions_;  // by the memory that they give
  std::set<uint32_t> changed_;
  Texts locals_;
  Texts arguments_;
};

// Memory that the language needs for itself has a name with a number behind a `#`.
std::string OwnName(const std::string& name);

// "0.05 m"
std::string NumberWithUnit(double value, const Type& type, const Unit& unit);

}  // namespace compiler
