#include "compiler/syntax/allowances.h"

#include <utility>

#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/unit_builder.h"

namespace compiler {

using grammar::TaskParser;

void Allowances::Add(TaskParser::AllowContext& context) {
  if (context.exception != nullptr) return;
  Pending pending;
  for (antlr4::tree::TerminalNode* code : context.NAME()) {
    pending.codes.push_back(BuildName(*code->getSymbol()));
  }
  pending.span = Cover(SpanOf(*context.ALLOW()->getSymbol()), pending.codes.back().span);
  pending_.push_back(std::move(pending));
}

void Allowances::Attach(Span covers) {
  for (Pending& pending : pending_) attached_.push_back({std::move(pending.codes), covers});
  pending_.clear();
}

void Allowances::End() {
  for (const Pending& pending : std::exchange(pending_, {})) {
    Diagnostic diagnostic =
        MakeDiagnostic(code::kMisplacedAllow, pending.span, "nothing follows this `allow`");
    diagnostic.help =
        "it goes on the line above a declaration, a statement or the header of the task";
    report_.AddUnlessFaulty(std::move(diagnostic));
  }
}

}  // namespace compiler
