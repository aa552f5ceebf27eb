// The names of types, and the questions that the checks ask about a type.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"

namespace compiler {

// The largest array that a task can declare: keeps a task's memory small.
inline constexpr uint32_t kLargestArray = 4096;

// The type called `name`: "real", "vec3", "quat". Nothing for another name.
std::optional<Type> FindType(std::string_view name);
std::vector<std::string> TypeNames();

inline Type ScalarType(Scalar scalar) { return {.scalar = scalar}; }
inline bool IsScalar(const Type& type) { return type.shape == Shape::kScalar; }
inline bool IsBool(const Type& type) { return type.scalar == Scalar::kBool; }
inline bool IsNumber(const Type& type) { return !IsBool(type); }
// A vector or an array: one row of elements.
inline bool IsRow(const Type& type) {
  return type.shape == Shape::kVector || type.shape == Shape::kArray;
}

// The type of `count` elements picked out of a value of type `from`: a scalar, a vector or an
// array.
Type ElementsType(const Type& from, uint32_t count);

// "a `real`", "an `int`": how messages name a value.
std::string WithArticle(const Type& type);

}  // namespace compiler
