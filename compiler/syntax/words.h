// The words of the language that are not keywords, each of which is used in one place only, and
// the symbols of its operators and assignments.
#pragma once

#include <array>
#include <string_view>

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

template <typename Meaning>
struct Word {
  std::string_view text;
  Meaning meaning;
};

// In the order of EventKind.
inline constexpr std::array<Word<EventKind>, 8> kEventNames = {{
    {"start_of_episode", EventKind::kStartOfEpisode},
    {"end_of_episode", EventKind::kEndOfEpisode},
    {"start_of_action", EventKind::kStartOfAction},
    {"end_of_action", EventKind::kEndOfAction},
    {"start_of_time_step", EventKind::kStartOfTimeStep},
    {"end_of_time_step", EventKind::kEndOfTimeStep},
    {"start_of_physics_step", EventKind::kStartOfPhysicsStep},
    {"end_of_physics_step", EventKind::kEndOfPhysicsStep},
}};

// `metric max height`
inline constexpr std::array<Word<Reduction>, 5> kReductionNames = {{
    {"last", Reduction::kLast},
    {"sum", Reduction::kSum},
    {"max", Reduction::kMax},
    {"min", Reduction::kMin},
    {"mean", Reduction::kMean},
}};

// `reward rate forward`
inline constexpr std::array<Word<RewardKind>, 2> kRewardKindNames = {{
    {"rate", RewardKind::kRate},
    {"potential", RewardKind::kPotential},
}};

// `per action`
inline constexpr std::array<Word<MemoryScope>, 3> kScopeNames = {{
    {"run", MemoryScope::kPerRun},
    {"episode", MemoryScope::kPerEpisode},
    {"action", MemoryScope::kPerAction},
}};

// `after_end continue`
inline constexpr std::array<Word<AfterEnd>, 2> kAfterEndNames = {{
    {"stop", AfterEnd::kStop},
    {"continue", AfterEnd::kContinue},
}};

// `height + 1 m`
inline constexpr std::array<Word<BinaryOperator>, 12> kBinarySymbols = {{
    {"+", BinaryOperator::kAdd},
    {"-", BinaryOperator::kSubtract},
    {"*", BinaryOperator::kMultiply},
    {"/", BinaryOperator::kDivide},
    {"<", BinaryOperator::kLess},
    {"<=", BinaryOperator::kLessEqual},
    {">", BinaryOperator::kGreater},
    {">=", BinaryOperator::kGreaterEqual},
    {"==", BinaryOperator::kEqual},
    {"!=", BinaryOperator::kNotEqual},
    {"and", BinaryOperator::kAnd},
    {"or", BinaryOperator::kOr},
}};

// `height += 1 m`
inline constexpr std::array<Word<AssignOperator>, 5> kAssignSymbols = {{
    {"=", AssignOperator::kSet},
    {"+=", AssignOperator::kAdd},
    {"-=", AssignOperator::kSubtract},
    {"*=", AssignOperator::kMultiply},
    {"/=", AssignOperator::kDivide},
}};

// `observe onboard`
inline constexpr std::string_view kOnboard = "onboard";

// `end_episode failure`
inline constexpr std::array<Word<EndKind>, 2> kOutcomeNames = {{
    {"success", EndKind::kSuccess},
    {"failure", EndKind::kFailure},
}};

// The word of a table that has this meaning.
template <typename Meaning, size_t size>
constexpr std::string_view NameOf(Meaning meaning, const std::array<Word<Meaning>, size>& words) {
  for (const Word<Meaning>& word : words) {
    if (word.meaning == meaning) return word.text;
  }
  return "";
}

}  // namespace compiler
