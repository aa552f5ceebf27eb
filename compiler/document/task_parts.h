#pragma once

#include <string>
#include <variant>
#include <vector>

#include "compiler/analyze/analyze.h"
#include "compiler/document/equations.h"
#include "compiler/document/page.h"
#include "compiler/weights/weights.h"

namespace compiler {

// The declarations of one kind, in the order of the file.
template <typename Node>
std::vector<const Node*> All(const SyntaxTree& tree) {
  std::vector<const Node*> nodes;
  for (const Declaration& declaration : tree.declarations) {
    if (const auto* node = std::get_if<Node>(&declaration.node)) nodes.push_back(node);
  }
  return nodes;
}

// What an event or a phase does.
struct Statements {
  EventEquations equations;
  std::string place;  // "end_of_time_step", "phase lift"
  std::string when;   // "at the end of a time step", "in the phase lift"
};

// All that the sections of a task's page are written from. Refers to the analysis, whose task must
// be there.
struct TaskParts {
  explicit TaskParts(const Analysis& analysis);

  const Analysis& analysis;
  const CheckedTask& task;
  const SyntaxTree& tree;
  Weights weights;
  std::vector<Statements> statements;
};

// What stands in a table where something happens under a condition, in LaTeX.
Text WhenText(const std::string& condition);

}  // namespace compiler
