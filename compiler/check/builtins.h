// What the checker knows of the functions of the language; the list is builtin_table.def.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/composites.h"

namespace compiler {

// Which values a function takes, and the type of its result. What joins numbers joins the vectors
// of an array element by element; what takes a vector takes each vector of an array, if need be
// beside the same other one.
enum class ArgumentRule {
  kConditions,    // a bool or an array of them -> a bool, or an int for `count`
  kNumbers,       // a number, vector or array -> its scalar type; of vectors: a vector
  kRow,           // a vector or array -> a real; an array of vectors -> an array
  kTwoRows,       // two of the same vector or array type -> as kRow
  kTwoVec3,       // two vec3 -> a vec3; one or both an array of them -> such an array
  kElements,      // single numbers, or elements of one shape -> ints if all are, else reals
  kRealElements,  // single numbers, or elements of one shape -> reals
  kParts,         // numbers -> the type called like the function
  kChoice,        // a condition and two values of one type -> that type; or elements of one shape
  kRotation,      // a quat or a mat3, and a vec3 or an array of them -> the type of what is rotated
  kQuaternion,    // a quat -> a quat for `inverse`, else a real
  kMatrix,        // a matrix -> the same type
};

// What the units of arguments and result have to do with each other.
enum class UnitRule {
  kNone,          // conditions have no unit
  kSame,          // all arguments have the unit of the result
  kProduct,       // the result has the product of the arguments' units
  kSquareRoot,    // the result has the root of the argument's unit
  kPlain,         // a plain number to a plain number
  kAngleToPlain,  // an angle to a plain number
  kAllPlain,      // plain numbers to a plain number
  kSameToAngle,   // two of the same unit to an angle
  kSameToPlain,   // all of the same unit to a plain number
  kToPlain,       // anything to a plain number
  kToAngle,       // anything to an angle
  kPlainToAngle,  // a plain number to an angle
  kAngle,         // an angle to an angle
  kOfRotated,     // a plain rotation; the result has the unit of what is rotated
};

struct BuiltinDescription {
  std::string_view name;
  std::variant<Builtin, Composite> function;  // what a call becomes
  size_t min_arguments;
  size_t max_arguments;
  ArgumentRule arguments;
  UnitRule units;
  std::string_view usage;  // how a call is written: "clamp(x, low, high)"
};

// The function called `name`, or null.
const BuiltinDescription* FindBuiltin(std::string_view name);
std::vector<std::string> BuiltinNames();
// Whether it takes single numbers, and so applies to each element of several.
bool IsElementwise(Builtin function);

}  // namespace compiler
