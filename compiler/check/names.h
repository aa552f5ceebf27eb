// What a name or a dotted path of names stands for.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/task_scope.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// Names that are built in beside sensors, functions, types and units.
inline constexpr std::string_view kReward = "reward";
inline constexpr std::string_view kTimeStep = "time_step";
inline constexpr std::string_view kPi = "pi";
// What only the `expect` of a test reads.
inline constexpr std::string_view kTotal = "total";
inline constexpr std::string_view kValue = "value";
inline constexpr std::string_view kObserved = "observed";
inline constexpr std::string_view kEnded = "ended";
// The learner's, which only the `given` of a test names.
inline constexpr std::string_view kDiscount = "discount";
inline constexpr std::array kTestFunctions = {kTotal, kValue, kObserved};
inline bool IsTestFunction(std::string_view name) {
  return std::ranges::find(kTestFunctions, name) != kTestFunctions.end();
}

// A name, and how many further names of the path belong to it: `base.velocity` of
// `base.velocity.xy`.
struct ResolvedPath {
  CheckedExpression expression;
  size_t length = 1;
};

// What `path` begins with: the longest sensor name, or a single name of another kind. Reports and
// returns nothing where there is no such name or it must not be read at `place`.
std::optional<ResolvedPath> ResolvePath(const std::vector<Identifier>& path, const Place& place,
                                        const TaskScope& scope);

// "a param", "the variable of a loop": how messages name a symbol.
std::string_view WhatIs(SymbolKind kind);

// The visible symbol that `name` stands for where it is read, or null.
const Symbol* FindSymbol(const Identifier& name, const TaskScope& scope);

// The task's function that a call names. Reports and returns null where there is none, or where
// nothing can be called.
const FunctionSignature* ResolveFunction(const Identifier& name, const Place& place,
                                         const TaskScope& scope);

// How a call is written: "near(distance, reach)".
std::string UsageOf(const FunctionSignature& function);

// Declares a param, a memory or a local value, unless its name is taken: that is then reported
// and the result false.
bool DeclareSymbol(const Identifier& name, Symbol symbol, TaskScope& scope);

// Notes what a name stands for, for those who want to know.
void NoteReference(const Identifier& name, const Symbol& symbol, const TaskScope& scope);
// The same for names that have no symbol: terms, metrics and the like.
void NoteReference(const Identifier& name, ReferenceKind kind, const TaskScope& scope);

// Reports a name that is the language's own or a sensor's: such a name cannot be declared.
bool IsTaken(const Identifier& name, const TaskScope& scope);
// The same, for the language's own names only.
bool IsLanguageName(const Identifier& name, Diagnostics& diagnostics);

// Reports that there is no such name among params, memory, local values and sensors.
void ReportUnknownName(const Identifier& name, const TaskScope& scope);

}  // namespace compiler
