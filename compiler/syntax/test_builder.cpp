#include "compiler/syntax/test_builder.h"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <system_error>
#include <utility>

#include "compiler/syntax/lost_text.h"
#include "compiler/syntax/token_classes.h"
#include "compiler/syntax/unit_builder.h"
#include "compiler/syntax/word_lookup.h"

namespace compiler {
namespace {

using grammar::TaskParser;

constexpr uint32_t kMostTimes = 1'000'000;

}  // namespace

TestDeclaration TestBuilder::Build(TaskParser::TestContext& context) {
  TestDeclaration test;
  antlr4::Token& name = *context.STRING()->getSymbol();
  test.name = BuildNeededText(name, "a test needs a name", report_);
  test.name_span = SpanOf(name);
  for (antlr4::tree::ParseTree* child : context.testBlock()->children) {
    if (auto* allow = dynamic_cast<TaskParser::AllowContext*>(child)) {
      allowances_.Add(*allow);
    } else if (auto* statement = dynamic_cast<TaskParser::TestStatementContext*>(child)) {
      allowances_.Attach(SpanOf(*statement));
      if (!IsLost(*statement, report_)) test.statements.push_back(BuildStatement(*statement));
    }
  }
  allowances_.End();
  return test;
}

TestStatement TestBuilder::BuildStatement(TaskParser::TestStatementContext& context) {
  auto& inner = *static_cast<antlr4::ParserRuleContext*>(context.children.front());
  TestStatement statement{SpanOf(inner), {}};
  if (auto* given = context.given()) {
    statement.node = GivenStatement{statements_.BuildTarget(*given->target()),
                                    expressions_.Build(*given->expression())};
  } else if (auto* fire = context.fire()) {
    statement.node = Fire(*fire);
  } else if (auto* end = context.expect()->end()) {
    statement.node = ExpectEndStatement{statements_.End(*end)};
  } else {
    statement.node = ExpectStatement{expressions_.Build(*context.expect()->expression())};
  }
  return statement;
}

FireStatement TestBuilder::Fire(TaskParser::FireContext& context) {
  FireStatement statement;
  for (TaskParser::FiredContext* fired : context.fired()) {
    const Identifier name = BuildName(*fired->name());
    const EventKind event = LookUp(name, kEventNames, code::kUnknownEvent, "an event", report_);
    statement.events.push_back({event, name, fired->times != nullptr ? Times(*fired->times) : 1});
  }
  return statement;
}

uint32_t TestBuilder::Times(antlr4::Token& number) {
  const std::string text = number.getText();
  uint32_t times = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, times);
  if (result.ec == std::errc() && result.ptr == end && times >= 1 && times <= kMostTimes) {
    return times;
  }
  Diagnostic diagnostic = MakeDiagnostic(code::kBadNumber, SpanOf(number),
                                         fmt::format("an event cannot be fired {} times", text));
  diagnostic.help = fmt::format("write an integer from 1 to {}", kMostTimes);
  report_.AddMended(std::move(diagnostic));
  return 1;
}

}  // namespace compiler
