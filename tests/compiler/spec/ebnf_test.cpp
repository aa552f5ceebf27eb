#include "compiler/spec/ebnf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "tests/golden.h"

namespace compiler {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string DefinitionOf(const std::string& name, const std::vector<GrammarRule>& rules) {
  const auto found = std::ranges::find(rules, name, &GrammarRule::name);
  return found != rules.end() ? found->definition : "no such rule";
}

std::vector<GrammarRule> OfTheLanguage() {
  return ReadGrammar(golden::ReadFile(SOURCE_DIR "/grammar/Task.g4"));
}

TEST(Ebnf, PutsWordsWhereTheyAreUsed) {
  const auto rules = ReadGrammar(R"(// About the whole.
grammar T;
tokens { LINE_END }

// ---- Part ----

// The whole of it.
file : (base=NAME | path+=item*)? LINE_END? EOF ;

// An example, which
// goes on.
item : MARK ('+' item)+ ;

never : MARK ;
MARK : '"' ;
NAME : [a-z] ~["\\\r\n]* DIGITS? ;
BLANK : [ \t]+ -> skip ;
fragment DIGITS : [0-9]+ ;
)");
  ASSERT_EQ(rules.size(), 5u);
  EXPECT_EQ(DefinitionOf("file", rules), "(NAME | item*)? end_of_line? end_of_file");
  EXPECT_EQ(DefinitionOf("item", rules), "'\"' (\"+\" item)+");
  EXPECT_EQ(DefinitionOf("NAME", rules), R"([a-z] [^"\\\r\n]* DIGITS?)");
  EXPECT_EQ(DefinitionOf("BLANK", rules), R"([ \t]+)");
  EXPECT_EQ(rules[0].comment, "The whole of it.");
  EXPECT_EQ(rules[1].comment, "An example, which goes on.");
  EXPECT_TRUE(rules[2].is_token);
  EXPECT_THAT(ToEbnf(rules), testing::StartsWith("/* The whole of it. */\nfile ::= (NAME"));
}

TEST(Ebnf, HasEachRuleOfTheParser) {
  const auto rules = OfTheLanguage();
  const std::string grammar = golden::ReadFile(SOURCE_DIR "/grammar/Task.g4");
  static const std::regex kRule("\n([a-z]\\w*)\\s*\n?\\s*:");
  size_t count = 0;
  for (std::sregex_iterator rule(grammar.begin(), grammar.end(), kRule), end; rule != end; ++rule) {
    ++count;
    EXPECT_NE(DefinitionOf((*rule)[1], rules), "no such rule") << (*rule)[1];
  }
  EXPECT_GT(count, 60u);
}

TEST(Ebnf, DefinesEachNameThatItUses) {
  const auto rules = OfTheLanguage();
  static const std::regex kText(R"("[^"]*"|'[^']*'|\[[^\]]*\])");
  static const std::regex kName("[A-Za-z_]+");
  for (const GrammarRule& rule : rules) {
    const std::string names = std::regex_replace(rule.definition, kText, " ");
    for (std::sregex_iterator name(names.begin(), names.end(), kName), end; name != end; ++name) {
      const std::string used = (*name)[0];
      if (used == "end_of_line" || used == "end_of_file") continue;
      EXPECT_NE(DefinitionOf(used, rules), "no such rule") << rule.name << " uses " << used;
    }
  }
}

// What ANTLR alone understands, and what is there for messages only.
TEST(Ebnf, HasNothingOfTheParserGenerator) {
  const std::string text = ToEbnf(OfTheLanguage());
  EXPECT_THAT(text, HasSubstr("header ::= \"task\" name (\"extends\" STRING)? (\"for\" name)? "
                              "(\"in\" STRING)? "
                              "end_of_line?\n"));
  for (const char* word : {"+=)", "FOREIGN", "LINE_END", "fragment", "UNKNOWN", "skip"}) {
    EXPECT_THAT(text, Not(HasSubstr(word)));
  }
}

}  // namespace
}  // namespace compiler
