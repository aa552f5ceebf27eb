// Parse tree to syntax tree: expressions.
#pragma once

#include <TaskParser.h>

#include <vector>

#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Builds one expression. Its tree is never deeper than kMaxNesting: a longer chain of operators is
// an error.
class ExpressionBuilder {
 public:
  explicit ExpressionBuilder(SyntaxReport& report) : report_(report) {}

  Expression Build(grammar::TaskParser::ExpressionContext& context);
  // The items of an index set.
  std::vector<ExpressionPtr> BuildSet(grammar::TaskParser::ItemsContext& context);

 private:
  // An expression and the depth of its tree.
  struct Built {
    ExpressionPtr expression;
    uint32_t depth = 1;
  };

  Built Disjunction(grammar::TaskParser::ExpressionContext& context);
  Built Conjunction(grammar::TaskParser::ConjunctionContext& context);
  Built Negation(grammar::TaskParser::NegationContext& context);
  Built Comparison(grammar::TaskParser::ComparisonContext& context);
  Built Sum(grammar::TaskParser::SumContext& context);
  Built Product(grammar::TaskParser::ProductContext& context);
  Built Factor(grammar::TaskParser::FactorContext& context);
  Built Postfix(grammar::TaskParser::PostfixContext& context);
  Built Primary(grammar::TaskParser::PrimaryContext& context);
  Built Call(grammar::TaskParser::CallContext& context);
  // What is called is `result`.
  Built Method(Built result, grammar::TaskParser::ArgumentsContext& context);
  // The depth of the deepest goes to `depth`.
  std::vector<ExpressionPtr> Arguments(grammar::TaskParser::ArgumentsContext& context,
                                       uint32_t& depth);
  Built Set(grammar::TaskParser::PrimaryContext& context);
  Built Item(grammar::TaskParser::ItemContext& context);
  // The depth of the deepest goes to `depth`.
  std::vector<ExpressionPtr> Items(grammar::TaskParser::ItemsContext& context, uint32_t& depth);

  // Operands with operators between them, as the children of `context` stand in the tree.
  template <typename OperandContext>
  Built Chain(antlr4::ParserRuleContext& context,
              Built (ExpressionBuilder::*operand)(OperandContext&));
  Built Binary(Built left, const antlr4::Token& op, Built right);
  Built Unary(const antlr4::Token& op, Built operand);
  // Reports an expression that turned out to be too deep.
  void CheckDepth(Span span);
  template <typename Node>
  Built Make(Span span, Node node, uint32_t depth_below = 0);

  SyntaxReport& report_;
  bool is_in_index_ = false;
  bool is_too_deep_ = false;
};

}  // namespace compiler
