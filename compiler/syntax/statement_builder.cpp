#include "compiler/syntax/statement_builder.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/source/in_one_line.h"
#include "compiler/syntax/lost_text.h"
#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/unit_builder.h"
#include "compiler/syntax/word_lookup.h"

namespace compiler {
namespace {

using grammar::TaskParser;

AssignOperator AssignOperatorOf(TokenType type) {
  switch (type) {
    case TaskParser::ADD_ASSIGN:
      return AssignOperator::kAdd;
    case TaskParser::SUBTRACT_ASSIGN:
      return AssignOperator::kSubtract;
    case TaskParser::MULTIPLY_ASSIGN:
      return AssignOperator::kMultiply;
    case TaskParser::DIVIDE_ASSIGN:
      return AssignOperator::kDivide;
    default:
      return AssignOperator::kSet;
  }
}

// `.xy`
bool IsSwizzle(std::string_view member) {
  return !member.empty() && member.find_first_not_of("xyzw") == std::string_view::npos;
}

}  // namespace

Block StatementBuilder::Build(TaskParser::BlockContext& context) {
  Block block;
  for (antlr4::tree::ParseTree* child : context.children) {
    if (auto* allow = dynamic_cast<TaskParser::AllowContext*>(child)) {
      allowances_.Add(*allow);
    } else if (auto* statement = dynamic_cast<TaskParser::StatementContext*>(child)) {
      allowances_.Attach(SpanOf(*statement));
      if (IsLost(*statement, report_)) {
        AddLost(*statement, block);
      } else {
        block.push_back(BuildStatement(*statement));
      }
    } else if (auto* inner = dynamic_cast<TaskParser::BlockContext*>(child)) {
      block.push_back({SpanOf(*inner), IfStatement{{}, Build(*inner)}});  // of what is lost
    }
  }
  NoteLost(context, lost_);
  allowances_.End();
  return block;
}

void StatementBuilder::AddLost(TaskParser::StatementContext& context, Block& block) {
  NoteLost(context, lost_);
  for (TaskParser::BlockContext* inner : BlocksIn(context))
    block.push_back({SpanOf(*inner), IfStatement{{}, Build(*inner)}});
}

Statement StatementBuilder::BuildStatement(TaskParser::StatementContext& context) {
  auto& inner = *static_cast<antlr4::ParserRuleContext*>(context.children.front());
  Statement statement{SpanOf(inner), {}};
  if (auto* let = context.let()) {
    statement.node = Let(*let);
  } else if (auto* assignment = context.assignment()) {
    statement.node = Assignment(*assignment);
  } else if (auto* branches = context.branches()) {
    statement.node = Branches(*branches);
  } else if (auto* loop = context.loop()) {
    statement.node = Loop(*loop);
  } else if (auto* once = context.once()) {
    statement.node = Once(*once);
  } else if (auto* reward = context.reward()) {
    statement.node = RewardInBlock(*reward);
  } else if (auto* log = context.log()) {
    statement.node = Log(*log);
  } else if (auto* require = context.require()) {
    statement.node = Require(*require);
  } else if (auto* redraw = context.redraw()) {
    statement.node = RedrawStatement{BuildName(*redraw->name())};
  } else if (auto* transition = context.transition()) {
    statement.node = NextStatement{BuildName(*transition->name())};
  } else {
    statement.node = End(*context.end());
  }
  return statement;
}

LetStatement StatementBuilder::Let(TaskParser::LetContext& context) {
  return {BuildName(*context.name()), expressions_.Build(*context.expression())};
}

AssignStatement StatementBuilder::Assignment(TaskParser::AssignmentContext& context) {
  AssignStatement statement;
  if (context.anonymous != nullptr) {
    const Identifier name = BuildName(*context.anonymous);
    statement.target = Target{.name = name, .span = name.span};
  } else {
    statement.target = BuildTarget(*context.target());
  }
  statement.op = AssignOperatorOf(context.op->getType());
  statement.value = expressions_.Build(*context.expression());
  return statement;
}

Target StatementBuilder::BuildTarget(TaskParser::TargetContext& context) {
  Target target;
  for (TaskParser::NameContext* part : context.path) {
    const Identifier name = BuildName(*part);
    if (target.name.text.empty()) {
      target.name = name;
    } else if (part == context.path.back() && IsSwizzle(name.text)) {
      target.member = name;
    } else {
      target.name = {target.name.text + "." + name.text, Cover(target.name.span, name.span)};
    }
  }
  if (context.items() != nullptr) target.items = expressions_.BuildSet(*context.items());
  if (context.element != nullptr) target.indexed_member = BuildName(*context.element);
  target.span = SpanOf(context);
  return target;
}

IfStatement StatementBuilder::Branches(TaskParser::BranchesContext& context) {
  IfStatement statement;
  const std::vector<TaskParser::ExpressionContext*> conditions = context.expression();
  const std::vector<TaskParser::BlockContext*> blocks = context.block();
  for (size_t i = 0; i < conditions.size(); ++i) {
    statement.branches.push_back({expressions_.Build(*conditions[i]), Build(*blocks[i])});
  }
  if (context.otherwise != nullptr) statement.otherwise = Build(*context.otherwise);
  return statement;
}

ForStatement StatementBuilder::Loop(TaskParser::LoopContext& context) {
  ForStatement statement;
  statement.variable = BuildName(*context.name());
  statement.items = expressions_.BuildSet(*context.items());
  statement.items_span = SpanOf(*context.items());
  statement.body = Build(*context.block());
  return statement;
}

OnceStatement StatementBuilder::Once(TaskParser::OnceContext& context) {
  OnceStatement statement;
  statement.scope = LookUp(BuildName(*context.scope), kScopeNames, code::kUnknownWord,
                           "a scope of `once`", report_);
  for (size_t i = 0; i < context.expression().size(); ++i)
    statement.branches.push_back(
        {expressions_.Build(*context.expression(i)), Build(*context.block(i))});
  if (context.otherwise != nullptr) {
    Diagnostic diagnostic =
        MakeDiagnostic(code::kUnknownStatement, SpanOf(*context.ELSE().back()->getSymbol()),
                       "`once` has no `else`");
    diagnostic.note = "it would run in the first step in which no condition holds";
    diagnostic.help = "write what is done meanwhile as an `if` of its own";
    report_.AddMended(std::move(diagnostic));
  }
  return statement;
}

RewardKind StatementBuilder::KindOf(TaskParser::RewardContext& context) {
  if (context.kind == nullptr) return RewardKind::kPayment;
  return LookUp(BuildName(*context.kind), kRewardKindNames, code::kUnknownWord, "a kind of reward",
                report_);
}

RewardStatement StatementBuilder::RewardInBlock(TaskParser::RewardContext& context) {
  const RewardKind kind = KindOf(context);
  RewardStatement statement = Reward(context, kind);
  if (kind != RewardKind::kPotential) return statement;
  Diagnostic diagnostic =
      MakeDiagnostic(code::kMisplacedPotential, {SpanOf(context).begin, statement.name.span.end},
                     "a potential is declared outside of events");
  diagnostic.note = "it pays each action by itself, so no event pays it";
  diagnostic.help = "move it out of the braces";
  report_.AddMended(std::move(diagnostic));
  return statement;
}

RewardStatement StatementBuilder::Reward(TaskParser::RewardContext& context, RewardKind kind) {
  RewardStatement statement;
  statement.doc = DocOf(context);
  statement.is_rate = kind == RewardKind::kRate;
  statement.name = BuildName(*context.name());
  statement.value = expressions_.Build(*context.expression());
  return statement;
}

EndStatement StatementBuilder::End(TaskParser::EndContext& context) {
  EndStatement statement{EndKind::kTruncated, "", {}, SpanOf(context)};
  if (context.outcome != nullptr) {
    statement.kind = LookUp(BuildName(*context.outcome), kOutcomeNames, code::kUnknownWord,
                            "an outcome of an episode", report_);
  }
  antlr4::Token& text = *context.STRING()->getSymbol();
  statement.reason = BuildText(text, report_);
  statement.reason_span = SpanOf(text);
  return statement;
}

LogStatement StatementBuilder::Log(TaskParser::LogContext& context) {
  LogStatement statement;
  statement.doc = DocOf(context);
  if (context.reduction != nullptr) {
    statement.reduction = LookUp(BuildName(*context.reduction), kReductionNames, code::kUnknownWord,
                                 "a reduction of a log", report_);
  }
  statement.name = BuildName(*context.name());
  statement.value = expressions_.Build(*context.expression());
  return statement;
}

RequireStatement StatementBuilder::Require(TaskParser::RequireContext& context) {
  RequireStatement statement{expressions_.Build(*context.expression()), "", ""};
  statement.text = InOneLine(report_.source().TextOf(SpanOf(*context.expression())));
  if (context.STRING() != nullptr) {
    statement.reason = BuildText(*context.STRING()->getSymbol(), report_);
  }
  return statement;
}

std::string StatementBuilder::DocOf(antlr4::ParserRuleContext& context) const {
  const auto found = docs_.find(SpanOf(context).begin);
  return found != docs_.end() ? found->second : "";
}

}  // namespace compiler
