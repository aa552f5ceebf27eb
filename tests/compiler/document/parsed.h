// Parts of tasks as they are written, for tests.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "compiler/document/equations.h"
#include "compiler/syntax/parse.h"

namespace compiler {

inline SyntaxTree Parsed(const std::string& text) {
  SourceFile source("t.task", text);
  Diagnostics diagnostics;
  std::optional<SyntaxTree> tree = Parse(source, diagnostics);
  if (!tree) throw std::runtime_error("no task: " + text);
  return std::move(*tree);
}

// What a function of an expression says of it.
template <class Function>
auto OfExpression(const std::string& text, const Function& function) {
  const SyntaxTree tree = Parsed("task t\nmetric value = " + text + "\n");
  return function(std::get<MetricDeclaration>(tree.declarations.front().node).value);
}

inline EventEquations Equations(const std::string& body) {
  const SyntaxTree tree = Parsed("task t\non end_of_time_step {\n" + body + "\n}\n");
  return EquationsOf(std::get<EventDeclaration>(tree.declarations.front().node));
}

}  // namespace compiler
