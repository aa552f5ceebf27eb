// How the functions of the language become C++.
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "compiler/check/checked_task.h"
#include "compiler/emit/helper_functions.h"

namespace compiler {

// Makes one number out of many: a term for every element, the terms joined from the left, and one
// last step.
struct Chain {
  enum class Term { kElement, kCount, kSquare, kProduct };
  enum class Join { kOr, kAnd, kSum, kMin, kMax };
  enum class Finish { kNothing, kNot, kSquareRoot };

  Join join;
  Term term = Term::kElement;
  Finish finish = Finish::kNothing;
  bool joins_arguments = false;  // where there are several, as in `min(x, y)`: element by element
};

// A function that the C++ compiler knows, for reals and for ints.
struct CompilerFunction {
  std::string_view real;
  std::optional<Helper> integer = {};  // where another function is that of ints
};

// A function of our own, or of the C library.
struct HelperFunction {
  Helper real;
  Helper integer = real;
};

// What the emitter writes out itself.
enum class WrittenOut { kClamp, kCross, kSelect, kVector };

using Emission = std::variant<Chain, CompilerFunction, HelperFunction, WrittenOut>;

Emission EmissionOf(Builtin function);

}  // namespace compiler
