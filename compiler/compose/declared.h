// What a declaration of a task declares: its kind and its name.
#pragma once

#include <string_view>

#include "compiler/syntax/syntax_tree.h"

namespace compiler {

// How the language calls it: what follows `override`.
std::string_view KindOf(const Declaration& declaration);

// Empty where it has none.
const Identifier& NameOf(const Declaration& declaration);

// Not an event whose name is wrong.
bool IsKnown(const Declaration& declaration);

// Of these there is one in a task, whatever its name.
bool IsOnly(std::string_view kind);

// Do the two declare the same thing?
bool AreOfTheSame(const Declaration& a, const Declaration& b);

}  // namespace compiler
