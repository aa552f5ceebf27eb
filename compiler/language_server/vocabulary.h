// What the editor says of the words that the language itself brings.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace compiler {

struct ExplainedWord {
  std::string_view word;
  std::string_view explanation;  // one sentence, with Markdown
};

// Where they stand, each with what it does.
std::span<const ExplainedWord> DeclarationWords();
std::span<const ExplainedWord> StatementWords();
std::span<const ExplainedWord> TestWords();
std::span<const ExplainedWord> BodyWords();  // of a function
std::span<const ExplainedWord> ValueWords();
std::span<const ExplainedWord> OperatorWords();
std::span<const ExplainedWord> EventWords();
std::span<const ExplainedWord> ReductionWords();
std::span<const ExplainedWord> ScopeWords();
std::span<const ExplainedWord> OutcomeWords();
std::span<const ExplainedWord> AfterEndWords();

// Of any word of the language; empty for others.
std::string_view ExplanationOf(std::string_view word);

}  // namespace compiler
