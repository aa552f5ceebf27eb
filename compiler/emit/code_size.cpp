#include "compiler/emit/code_size.h"

#include <algorithm>

#include "base/variant/overloaded.h"
#include "compiler/check/traversal.h"

namespace compiler {
namespace {

// Of a table, for the row.
constexpr uint64_t kSearch = 20;

// Reading costs nothing; all else is done for each element.
uint64_t OperationsIn(const CheckedExpression& part) {
  return std::visit(variant::Overloaded{
                        [&](const CheckedUnary&) -> uint64_t { return part.type.size(); },
                        [&](const CheckedBinary&) -> uint64_t { return part.type.size(); },
                        [](const BuiltinCall& call) {
                          uint64_t most = 1;
                          for (const CheckedExpressionPtr& argument : call.arguments) {
                            most = std::max<uint64_t>(most, argument->type.size());
                          }
                          return most;
                        },
                        [&](const TableRead&) -> uint64_t { return kSearch + part.type.size(); },
                        [&](const FunctionCall& call) -> uint64_t {
                          return (1 + call.arguments.size()) *
                                 (call.is_each ? part.type.size() : 1);
                        },
                        [](const auto&) -> uint64_t { return 0; },
                    },
                    part.node);
}

}  // namespace

void CodeSize::Add(const CheckedExpression& expression) {
  ForEachPart(expression,
              [this](const CheckedExpression& part) { operations_ += OperationsIn(part); });
}

}  // namespace compiler
