// What may be written at a place of a text that is being written.
#pragma once

#include <string>

#include "compiler/language_server/text_tokens.h"

namespace compiler {

enum class Expected {
  kAnyText,  // a new name, a comment, a text
  kDeclaration,
  kStatement,  // of an event
  kTestStatement,
  kStartStatement,
  kBodyStatement,  // of a function
  kOverridden,     // after `override`
  kParamName,      // of the base, after `override param`
  kConstName,
  kSetName,
  kTableName,
  kGoalName,
  kObservationName,
  kPhaseName,
  kMetricName,
  kFunctionName,
  kValue,
  kGoalValue,  // what a goal is drawn from
  kObserved,   // after `observe`: a value, or `onboard`
  kOperator,   // after a value
  kMember,     // after `path.`
  kIndex,      // inside `path[...]`, after `for x in`, or after `set NAME =`
  kUnit,
  kType,
  kTypeIndex,  // `bool[...]`: an enumeration, or a unit
  kEvent,
  kPose,
  kRobot,
  kScope,
  kReduction,
  kOutcome,
  kAfterEnd,     // after `after_end`
  kTerm,         // after `reward`
  kPotential,    // after `reward` outside of events
  kGoal,         // after `redraw`
  kPhase,        // after `next`, `phase ==`
  kTarget,       // after `given`
  kExpectation,  // after `expect`
  kWarningCode,
  kFile,  // the name of a task file
  kTableFile,
  kWorldFile
};

struct CursorPlace {
  Expected expected = Expected::kAnyText;
  std::string path;  // of kMember and kIndex: "base", "joint.angle"
  Span word;         // what has been written of the word already
};

// Is this text the file of a table: `table gait: real = "walk.csv"`?
bool IsFileOfTable(const TextTokens& tokens, size_t text);

CursorPlace FindCursorPlace(const TextTokens& tokens, uint32_t offset);

// The call whose arguments are being written at `offset`.
struct OpenCall {
  std::string function;  // empty: there is none
  uint32_t argument = 0;
};
OpenCall FindOpenCall(const TextTokens& tokens, uint32_t offset);

// The names with dots around `offset` that lead to the one there: `base.velocity` with the offset
// in `velocity`. Empty where there is no name.
struct PathAtCursor {
  std::string path;
  Span span{};  // of all of it
  Span last{};  // of the name at the offset
};
PathAtCursor FindPath(const TextTokens& tokens, uint32_t offset);

}  // namespace compiler
