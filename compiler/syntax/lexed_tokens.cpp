#include "compiler/syntax/lexed_tokens.h"

#include <TaskLexer.h>

#include <string>

#include "compiler/syntax/byte_stream.h"
#include "compiler/syntax/quick_lexer.h"
#include "compiler/syntax/token_classes.h"

namespace compiler {
namespace {

using grammar::TaskLexer;

LexedKind KindOf(TokenType type) {
  switch (type) {
    case TaskLexer::NAME:
    case TaskLexer::ANY_UNIT:  // its place says what it is
      return LexedKind::kName;
    case TaskLexer::NUMBER:
    case TaskLexer::NUMBER_WITHOUT_ZERO:
      return LexedKind::kNumber;
    case TaskLexer::STRING:
    case TaskLexer::UNCLOSED_STRING:
    case TaskLexer::FOREIGN_STRING:
      return LexedKind::kText;
    default:
      break;
  }
  if (IsUnit(type)) return LexedKind::kUnit;
  return IsReserved(type) ? LexedKind::kKeyword : LexedKind::kSign;
}

}  // namespace

std::vector<LexedToken> Lex(std::string_view text) {
  ByteStream bytes(SourceFile("", std::string(text)));
  QuickLexer lexer(&bytes);
  lexer.removeErrorListeners();
  std::vector<LexedToken> tokens;
  while (true) {
    const auto token = lexer.nextToken();
    if (token->getType() == antlr4::Token::EOF) return tokens;
    if (token->getChannel() != antlr4::Token::DEFAULT_CHANNEL) continue;
    tokens.push_back({KindOf(token->getType()),
                      {static_cast<uint32_t>(token->getStartIndex()),
                       static_cast<uint32_t>(token->getStopIndex() + 1)}});
  }
}

}  // namespace compiler
