// The names that a text declares, found without parsing it: what a person who is in the middle of
// writing can already use.
#pragma once

#include <string>
#include <vector>

#include "compiler/language_server/text_tokens.h"

namespace compiler {

enum class NameKind {
  kTask,
  kSensor,  // with its dots
  kParam,
  kConst,
  kSet,
  kTable,
  kMemory,
  kGoal,
  kObservation,  // where it has a name of its own
  kPhase,
  kMetric,
  kLog,
  kTerm,
  kEvent,
  kTest,  // the name is the text with its quotes
  kFunction,
  kArgument,
  kLet,
  kLoop
};

struct DeclaredName {
  NameKind kind = NameKind::kParam;
  std::string name;
  Span span{};       // of the name
  std::string type;  // as written, with its unit: "vec3 [m/s]"; a function's with its arguments;
                     // empty where none is written
  Span whole{};      // of the declaration
  Span visible{};    // where it can be used
  bool is_override = false;
};

// In the order of the text. Repeated terms and logs are listed each time.
std::vector<DeclaredName> FindDeclaredNames(const TextTokens& tokens);

}  // namespace compiler
