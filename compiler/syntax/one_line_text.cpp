#include "compiler/syntax/one_line_text.h"

#include <optional>

#include "compiler/syntax/spacing.h"
#include "compiler/syntax/token_role.h"

namespace compiler {
namespace {

class TextBuilder {
 public:
  void Visit(antlr4::ParserRuleContext& context) {
    for (antlr4::tree::ParseTree* child : context.children) {
      if (auto* terminal = dynamic_cast<antlr4::tree::TerminalNode*>(child)) {
        Add(*terminal);
      } else {
        Visit(*static_cast<antlr4::ParserRuleContext*>(child));
      }
    }
  }

  std::string text;

 private:
  void Add(antlr4::tree::TerminalNode& node) {
    const TokenRole role = RoleOf(node);
    if (last_ && IsSpaced(*last_, role)) text += ' ';
    text += node.getText();
    last_ = role;
  }

  std::optional<TokenRole> last_;
};

}  // namespace

std::string OneLineText(antlr4::ParserRuleContext& context) {
  TextBuilder builder;
  builder.Visit(context);
  return std::move(builder.text);
}

}  // namespace compiler
