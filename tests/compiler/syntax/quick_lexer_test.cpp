// The short way through a text finds the tokens that ANTLR's automaton finds.
#include "compiler/syntax/quick_lexer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tests/golden.h"

namespace compiler {
namespace {

std::vector<std::string> TokensOf(antlr4::Lexer& lexer) {
  lexer.removeErrorListeners();
  std::vector<std::string> tokens;
  while (true) {
    const auto token = lexer.nextToken();
    if (token->getType() == antlr4::Token::EOF) return tokens;
    tokens.push_back(token->toString());  // type, channel, place and text
  }
}

void ExpectTheSameTokens(const std::string& text) {
  const SourceFile file("", text);
  ByteStream quick_bytes(file);
  ByteStream bytes(file);
  QuickLexer quick(&quick_bytes);
  grammar::TaskLexer lexer(&bytes);
  EXPECT_EQ(TokensOf(quick), TokensOf(lexer)) << text;
}

std::vector<std::string> Texts() {
  std::vector<std::string> texts;
  for (const char* folder : {"/tasks", "/examples/tasks", "/library/std", "/tests/compiler/syntax",
                             "/tests/compiler/syntax/messages", "/tests/compiler/check/messages"}) {
    for (const auto& path : golden::FilesIn(SOURCE_DIR + std::string(folder), "", ".task"))
      texts.push_back(golden::ReadFile(path));
  }
  return texts;
}

TEST(QuickLexer, FindsWhatAntlrFindsInAllTasks) {
  const std::vector<std::string> texts = Texts();
  EXPECT_GT(texts.size(), 100u);
  for (const std::string& text : texts) ExpectTheSameTokens(text);
}

TEST(QuickLexer, FindsWhatAntlrFindsInWhatIsHardToTellApart) {
  for (const char* text : {"",
                           "\"",
                           "\"a\\\"b\" \"c",
                           "\"a\nb\"",
                           "1..2",
                           "1.",
                           ".5",
                           "1.5.2",
                           "2e",
                           "2e+",
                           "2e-3",
                           "2E5x",
                           "4e3.5",
                           "a..b",
                           "a...b",
                           "x=-4",
                           "x- -4",
                           "a<-b",
                           "a->b",
                           "a=>b",
                           "*//c\nd",
                           "a///doc\r\nb",
                           "////",
                           "/*x*/y",
                           "/* x",
                           "a/ /b",
                           "a.*b",
                           "a**b",
                           "x:=1",
                           "!==",
                           "=====",
                           "<=>",
                           "#x\ny",
                           "'a' 'b",
                           "a\xc3\xa4"
                           "b",
                           "\xef\xbb\xbf"
                           "task a",
                           "min m ms km",
                           "within unit",
                           "_a1 A_",
                           "a\f\tb\r\nc\rd",
                           "{}[](),:;@%?~",
                           "+=-=*=/=",
                           "a\x01"
                           "b"})
    ExpectTheSameTokens(text);
}

TEST(QuickLexer, FindsWhatAntlrFindsInAnyText) {
  const std::vector<std::string> pieces = {
      "a",  "if", "reward", "1",  "0.5", "e3", ".",  "..",  "-",  "+",  "=", "<",    ">", "/",  "*",
      "\"", "\\", "\n",     "\r", " ",   "\t", "//", "///", "/*", "*/", "#", "'",    "(", "]",  "{",
      ",",  ":",  "&",      "|",  "!",   "~",  "^",  "?",   ";",  "@",  "%", "\xc3", "m", "min"};
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    std::string text;
    for (size_t k = 0, count = 1 + random() % 12; k < count; ++k)
      text += pieces[random() % pieces.size()];
    ExpectTheSameTokens(text);
  }
}

}  // namespace
}  // namespace compiler
