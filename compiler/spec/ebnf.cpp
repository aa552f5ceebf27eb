#include "compiler/spec/ebnf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "compiler/spec/grammar_text.h"

namespace compiler {
namespace {

using Tokens = std::vector<GrammarToken>;

constexpr std::string_view kFirstRule = "file";

// What the layout puts between the lexer and the parser, and what only ANTLR needs.
const std::map<std::string, std::string, std::less<>> kGivenTokens = {{"LINE_END", "end_of_line"},
                                                                      {"SET_BEGIN", "\"{\""},
                                                                      {"SET_END", "\"}\""},
                                                                      {"EOF", "end_of_file"}};

struct ReadRule {
  std::string name;
  std::string comment;
  Tokens body;
  bool is_between_tokens = false;  // the parser does not see it

  bool is_token() const { return std::isupper(static_cast<unsigned char>(name.front())) != 0; }
  bool is_word() const { return body.size() == 1 && body.front().kind == GrammarToken::kLiteral; }
};

bool Is(const GrammarToken& token, std::string_view sign) {
  return token.kind == GrammarToken::kSign && token.text == sign;
}

std::string TextOf(const Tokens& comment) {
  std::string text;
  for (const GrammarToken& line : comment) {
    if (line.text.starts_with("// ----")) continue;
    if (!text.empty()) text += ' ';
    text += line.text.substr(std::min<size_t>(3, line.text.size()));
  }
  return text;
}

// `base=`, `path+=`: names for the tree builder. They begin where a name is followed by a sign.
void DropLabels(Tokens& body) {
  for (size_t i = 0; i + 1 < body.size();) {
    const bool is_label =
        body[i].kind == GrammarToken::kName && (Is(body[i + 1], "=") || Is(body[i + 1], "+="));
    if (is_label) {
      body.erase(body.begin() + static_cast<std::ptrdiff_t>(i),
                 body.begin() + static_cast<std::ptrdiff_t>(i) + 2);
    } else {
      ++i;
    }
  }
}

ReadRule RuleOf(const Tokens& tokens, const Tokens& comment) {
  ReadRule rule;
  const bool is_fragment = tokens.front().text == "fragment";
  rule.name = tokens[is_fragment ? 1 : 0].text;
  rule.comment = TextOf(comment);
  rule.body.assign(tokens.begin() + (is_fragment ? 3 : 2), tokens.end());
  const auto is_arrow = [](const GrammarToken& token) { return Is(token, "->"); };
  const auto action = std::ranges::find_if(rule.body, is_arrow);
  rule.is_between_tokens = action != rule.body.end();
  rule.body.erase(action, rule.body.end());
  DropLabels(rule.body);
  return rule;
}

std::vector<ReadRule> RulesOf(std::string_view grammar) {
  std::vector<ReadRule> rules;
  Tokens statement;
  Tokens comment;
  for (GrammarToken& token : TokensOfGrammar(grammar)) {
    if (token.kind == GrammarToken::kComment) {
      if (token.is_apart) comment.clear();
      if (statement.empty()) comment.push_back(std::move(token));
    } else if (Is(token, ";") || (Is(token, "}") && statement.front().text == "tokens")) {
      const bool is_rule = statement.size() > 2 && statement.front().text != "tokens";
      if (is_rule) rules.push_back(RuleOf(statement, comment));
      statement.clear();
      comment.clear();
    } else {
      if (statement.empty() && token.is_apart) comment.clear();
      statement.push_back(std::move(token));
    }
  }
  return rules;
}

const ReadRule* Find(const std::vector<ReadRule>& rules, std::string_view name) {
  const auto found = std::ranges::find(rules, name, &ReadRule::name);
  return found != rules.end() ? &*found : nullptr;
}

void Reach(std::string_view name, const std::vector<ReadRule>& rules,
           std::set<std::string>& known) {
  const ReadRule* rule = Find(rules, name);
  if (rule == nullptr || rule->is_word() || !known.insert(rule->name).second) return;
  for (const GrammarToken& token : rule->body)
    if (token.kind == GrammarToken::kName) Reach(token.text, rules, known);
}

// `'task'` as "task", `'"'` as '"'.
std::string Quoted(std::string_view literal) {
  std::string text(literal.substr(1, literal.size() - 2));
  if (text == "\\\\") text = "\\";
  const char quote = text.find('"') == std::string::npos ? '"' : '\'';
  return quote + text + quote;
}

std::string Written(const GrammarToken& token, const std::vector<ReadRule>& rules) {
  if (token.kind == GrammarToken::kLiteral) return Quoted(token.text);
  if (token.kind != GrammarToken::kName) return token.text;
  const auto given = kGivenTokens.find(token.text);
  if (given != kGivenTokens.end()) return given->second;
  const ReadRule* rule = Find(rules, token.text);
  return rule != nullptr && rule->is_word() ? Quoted(rule->body.front().text) : token.text;
}

// With blanks between the parts, but none inside of brackets and before `?`, `*`, `+`.
std::string DefinitionOf(const ReadRule& rule, const std::vector<ReadRule>& rules) {
  std::string text;
  bool is_complement = false;
  for (size_t i = 0; i < rule.body.size(); ++i) {
    const GrammarToken& token = rule.body[i];
    if (Is(token, "~")) {
      is_complement = true;
      continue;
    }
    const bool is_repetition = Is(token, "?") || Is(token, "*") || Is(token, "+");
    const bool is_close = Is(token, ")");
    const bool is_after_open = i > 0 && Is(rule.body[i - 1], "(");
    if (!text.empty() && !is_repetition && !is_close && !is_after_open) text += ' ';
    std::string written = Written(token, rules);
    if (is_complement && token.kind == GrammarToken::kSet) written.insert(1, "^");
    is_complement = false;
    text += written;
  }
  return text;
}

}  // namespace

std::vector<GrammarRule> ReadGrammar(std::string_view grammar) {
  const std::vector<ReadRule> rules = RulesOf(grammar);
  std::set<std::string> reached;
  Reach(kFirstRule, rules, reached);
  std::vector<GrammarRule> written;
  for (const ReadRule& rule : rules) {
    if (!reached.contains(rule.name) && !rule.is_between_tokens) continue;
    written.push_back({rule.name, DefinitionOf(rule, rules), rule.comment, rule.is_token()});
  }
  return written;
}

std::string ToEbnf(const std::vector<GrammarRule>& rules) {
  std::string text;
  for (const GrammarRule& rule : rules) {
    if (!rule.comment.empty()) text += fmt::format("/* {} */\n", rule.comment);
    text += fmt::format("{} ::= {}\n", rule.name, rule.definition);
  }
  return text;
}

}  // namespace compiler
