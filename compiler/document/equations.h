// The equations of a task: what is paid, when an episode ends, how memory changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/document/latex.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// left = right, or left <- right.
struct Equation {
  std::string left;
  std::string right;
  std::vector<std::string> reads{};  // the names in it, of a term's and a local's (reads.h)
  std::string let{};                 // of a local: its name
};

// What a reward term is paid.
struct TermEquation {
  std::string term;
  Equation equation;
};

// A statement that is not a sum: it happens under a condition.
struct ConditionalEquation {
  Equation equation;      // of an end or a requirement: empty
  std::string condition;  // in words and formulas; empty: always
};

struct ConditionalEnd {
  EndKind kind;
  std::string reason;
  std::string condition;  // empty: always
};

// A goal that is drawn anew.
struct ConditionalRedraw {
  std::string goal;       // its name
  std::string condition;  // empty: always
};

// A phase that comes next.
struct ConditionalNext {
  std::string phase;      // its name
  std::string condition;  // empty: always
};

// Of a block: what an event does, or a phase in each time step.
struct EventEquations {
  std::string name;  // of the event, or of the phase
  std::string doc;
  std::vector<TermEquation> terms;  // in the order of their first statements
  Formula total;                    // the sum of all terms
  std::vector<Equation> locals;
  std::vector<ConditionalEquation> memory;
  std::vector<ConditionalEquation> logs;
  std::vector<ConditionalEquation> requirements;  // left: the reason; right: the condition
  std::vector<ConditionalEnd> ends;
  std::vector<ConditionalRedraw> redraws;
  std::vector<ConditionalNext> next;
};

EventEquations EquationsOf(const EventDeclaration& event);
EventEquations EquationsOf(const PhaseDeclaration& phase);

// What the block of a start does; nothing where it has none.
struct StartEquations {
  std::vector<Equation> locals;
  std::vector<ConditionalEquation> values;
};
StartEquations EquationsOf(const StartDeclaration& start);

// Its lets are listed after its value.
std::vector<Equation> EquationsOf(const FunctionDeclaration& function);

}  // namespace compiler
