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
inline const Type kRealType = ScalarType(Scalar::kReal);
inline bool IsScalar(const Type& type) { return type.shape == Shape::kScalar; }
inline bool IsBool(const Type& type) { return type.scalar == Scalar::kBool; }
inline bool IsNumber(const Type& type) { return !IsBool(type); }
// A vector or an array.
inline bool IsRow(const Type& type) {
  return type.shape == Shape::kVector || type.shape == Shape::kArray;
}
// An array of vectors or quaternions.
inline bool HasVectors(const Type& type) { return type.entry != Shape::kScalar; }
// A quaternion, or an array of them: no arithmetic applies.
inline bool IsOfQuaternions(const Type& type) {
  return type.shape == Shape::kQuaternion || type.entry == Shape::kQuaternion;
}
// A vec3, or an array of them.
bool IsOfVec3(const Type& type);

// An array of `rows` such entries: scalars, vectors or quaternions.
Type ArrayOf(const Type& entry, uint32_t rows, std::string index = "");
// What an array consists of: `vec3` of `vec3[link]`.
Type EntryOf(const Type& array);
// An array as long as `array`, and indexed alike, of other entries.
Type WithEntries(const Type& array, const Type& entry);

// The type of `count` elements picked out of a value of type `from`, or of `count` entries of an
// array: a scalar, a vector, a quaternion or an array.
Type ElementsType(const Type& from, uint32_t count);

// "a `real`", "an `int`": how messages name a value.
std::string WithArticle(const Type& type);

}  // namespace compiler
