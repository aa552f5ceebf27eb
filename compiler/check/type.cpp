#include "compiler/check/type.h"

#include <fmt/format.h>

#include <array>

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
    if (type.name == name) return Type{type.scalar, type.shape, type.rows, type.columns, ""};
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
    return fmt::format("{}[{}]", ToString(ScalarType(type.scalar)), index);
  }
  for (const NamedType& named : kTypes)
    if (Matches(named, type)) return std::string(named.name);
  return "";  // no other type can be built
}

Type ElementsType(const Type& from, uint32_t count) {
  if (count == 1) return ScalarType(from.scalar);
  const bool is_vector = from.shape != Shape::kArray;
  return {from.scalar, is_vector ? Shape::kVector : Shape::kArray, count, 1, ""};
}

std::string WithArticle(const Type& type) {
  const std::string name = ToString(type);
  return fmt::format("{} `{}`", name.starts_with('i') ? "an" : "a", name);
}

}  // namespace compiler
