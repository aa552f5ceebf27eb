#include "compiler/check/type.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace compiler {
namespace {

struct NamedType {
  std::string_view name;
  Scalar scalar;
  Shape shape;
  uint32_t rows;
  uint32_t columns;
};

constexpr std::array kTypes = {
    NamedType{"bool", Scalar::kBool, Shape::kScalar, 1, 1},
    NamedType{"int", Scalar::kInt, Shape::kScalar, 1, 1},
    NamedType{"real", Scalar::kReal, Shape::kScalar, 1, 1},
    NamedType{"vec2", Scalar::kReal, Shape::kVector, 2, 1},
    NamedType{"vec3", Scalar::kReal, Shape::kVector, 3, 1},
    NamedType{"vec4", Scalar::kReal, Shape::kVector, 4, 1},
    NamedType{"mat2", Scalar::kReal, Shape::kMatrix, 2, 2},
    NamedType{"mat3", Scalar::kReal, Shape::kMatrix, 3, 3},
    NamedType{"mat4", Scalar::kReal, Shape::kMatrix, 4, 4},
    NamedType{"quat", Scalar::kReal, Shape::kQuaternion, 4, 1},
};

bool Matches(const NamedType& named, const Type& type) {
  return named.scalar == type.scalar && named.shape == type.shape && named.rows == type.rows &&
         named.columns == type.columns;
}

}  // namespace

std::optional<Type> FindType(std::string_view name) {
  for (const NamedType& type : kTypes)
    if (type.name == name) return Type{type.scalar, type.shape, type.rows, type.columns};
  return std::nullopt;
}

std::vector<std::string> TypeNames() {
  std::vector<std::string> names;
  for (const NamedType& type : kTypes) names.emplace_back(type.name);
  return names;
}

std::string ToString(const Type& type) {
  if (type.shape == Shape::kArray) {
    const std::string index = type.index.empty() ? std::to_string(type.rows) : type.index;
    return fmt::format("{}[{}]", ToString(EntryOf(type)), index);
  }
  for (const NamedType& named : kTypes)
    if (Matches(named, type)) return std::string(named.name);
  return "";  // no other type can be built
}

bool IsOfVec3(const Type& type) {
  const Type part = type.shape == Shape::kArray ? EntryOf(type) : type;
  return part.shape == Shape::kVector && part.rows == 3;
}

Type ArrayOf(const Type& entry, uint32_t rows, std::string index) {
  return {entry.scalar, Shape::kArray, rows, entry.rows, std::move(index), entry.shape};
}

Type EntryOf(const Type& array) { return {array.scalar, array.entry, array.columns}; }

Type WithEntries(const Type& array, const Type& entry) {
  return ArrayOf(entry, array.rows, array.index);
}

Type ElementsType(const Type& from, uint32_t count) {
  if (from.shape == Shape::kArray)
    return count == 1 ? EntryOf(from) : ArrayOf(EntryOf(from), count);
  if (count == 1) return ScalarType(from.scalar);
  return {from.scalar, Shape::kVector, count};
}

std::string WithArticle(const Type& type) {
  const std::string name = ToString(type);
  return fmt::format("{} `{}`", name.starts_with('i') ? "an" : "a", name);
}

}  // namespace compiler
