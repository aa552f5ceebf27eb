// Vectors, arrays and matrices.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "tests/compiler/random/random_expression.h"
#include "tests/compiler/random/random_units.h"

namespace compiler {

RandomExpressions::Text RandomExpressions::MakeRow(const Type& type, const Unit& unit, int depth) {
  const auto part = [&] { return Make(type, unit, depth - 1).text; };
  const std::string read = Read(type, unit);
  const bool is_vector = type.shape == Shape::kVector;
  if (depth <= 0 && !read.empty()) return {read};
  if (type == kVec3Type && depth > 0 && random_.OneIn(4)) return MakeVec3(unit, depth);
  if (depth > 0 && random_.OneIn(6)) {
    if (std::string made = OfEachVector(type, unit, depth); !made.empty()) return {made};
  }
  if (is_vector && depth > 0 && random_.OneIn(6)) {
    return {Constructed(ToString(type), type.rows, unit, depth)};
  }
  if (depth > 0 && random_.OneIn(4)) {
    if (std::string made = OfEachElement(type, unit, depth); !made.empty()) return {made};
  }
  const Type element = ScalarType(type.scalar);
  switch (depth <= 0 ? 0 : random_.Below(7)) {
    case 0: {
      // From scalars: an array of this type in any unit, made to fit.
      const Unit plain{};
      std::string row = read.empty() ? Read(type, plain) : read;
      if (!read.empty()) return {row};
      return {fmt::format("({} * {})", row, Literal(type.scalar, unit).text)};
    }
    case 1:
      return {fmt::format("(-{})", part())};
    case 2:
      return {fmt::format("abs({})", part())};
    case 3:
      return {fmt::format("({} {} {})", part(), random_.OneOf({"+", "-"}),
                          Make(element, unit, depth - 1).text)};
    case 4:
      return {fmt::format("({} * {})", Make(element, unit, depth - 1).text,
                          Make(type, {}, depth - 1).text)};
    case 5:
      if (is_vector && type.rows == 3 && random_.OneIn(2)) {
        return {fmt::format("cross({}, {})", part(), Make(type, {}, depth - 1).text)};
      }
      if (is_vector && random_.OneIn(2)) {
        const Readable whole{part(), type, unit};
        std::string letters;
        for (uint32_t i = 0; i < type.rows; ++i) letters += "xyzw"[random_.Below(type.rows)];
        return {fmt::format("{}.{}", whole.name, letters)};
      }
      if (type.scalar == Scalar::kReal) {
        return {fmt::format("({} / {})", part(), VariableReal({}, depth - 1))};
      }
      return {part()};
    default:
      return {fmt::format("({} {} {})", part(), random_.OneOf({"+", "-"}), part())};
  }
}

std::string RandomExpressions::OfEachElement(const Type& type, const Unit& unit, int depth) {
  const auto part = [&] { return Make(type, unit, depth - 2).text; };
  const auto any = [&] {
    return random_.OneIn(2) ? part() : Make(ScalarType(type.scalar), unit, depth - 2).text;
  };
  const auto of = [&](const Unit& other) { return Make(type, other, depth - 2).text; };
  const bool is_real = type.scalar == Scalar::kReal;
  if (is_real && IsPlain(unit) && random_.OneIn(2)) {
    switch (random_.Below(4)) {
      case 0:
        return fmt::format("{}({})",
                           random_.OneOf({"exp", "log", "tanh", "floor", "ceil", "round"}), part());
      case 1:
        return fmt::format("{}({})", random_.OneOf({"sin", "cos", "tan"}), of(kRadianUnit));
      case 2:
        return fmt::format("pow({}, {})", part(), any());
      default:
        return fmt::format("tolerance({}, {}, {}, {})", part(), any(), any(),
                           VariableReal({}, depth - 2));
    }
  }
  if (is_real && unit == kRadianUnit && random_.OneIn(2)) {
    if (random_.OneIn(3)) return fmt::format("wrap({})", part());
    if (random_.OneIn(2)) return fmt::format("atan2({}, {})", any(), part());
    return fmt::format("{}({})", random_.OneOf({"asin", "acos", "atan"}), of({}));
  }
  Type conditions = ArrayOf(ScalarType(Scalar::kBool), type.rows, type.index);
  const bool are_some = type.shape == Shape::kArray && !Read(conditions, {}).empty();
  switch (random_.Below(3)) {
    case 0:
      return fmt::format("{}({}, {})", random_.OneOf({"min", "max"}), any(), part());
    case 1:
      return fmt::format("clamp({}, {}, {})", part(), any(), any());
    default:
      if (!are_some) return "";
      return fmt::format("select({}, {}, {})", Make(conditions, {}, depth - 2).text, any(), any());
  }
}

RandomExpressions::Text RandomExpressions::MakeVec3(const Unit& unit, int depth) {
  const std::string turn = Read(kQuaternionType, {});
  if (!turn.empty() && random_.OneIn(3)) {
    return {fmt::format("rotate({}, {})", turn, Make(kVec3Type, unit, depth - 1).text)};
  }
  if (IsPlain(unit) && random_.OneIn(2)) {
    return {fmt::format("normalize({})", Make(kVec3Type, RandomUnit(), depth - 1).text)};
  }
  return {Constructed("vec3", 3, unit, depth)};
}

// ---- Arrays of vectors --------------------------------------------------------------------------

RandomExpressions::Text RandomExpressions::MakeVectors(const Type& array, const Unit& unit,
                                                       int depth) {
  const std::string read = Read(array, unit);
  if (IsOfQuaternions(array)) return {read};
  const Type entry = EntryOf(array);
  const Type numbers = WithEntries(array, ScalarType(Scalar::kReal));
  const auto part = [&] { return Make(array, unit, depth - 1).text; };
  if (depth <= 0) {
    if (!read.empty()) return {read};
    return {fmt::format("({} * {})", Read(array, {}), Literal(Scalar::kReal, unit).text)};
  }
  switch (random_.Below(8)) {
    case 0:
      return {fmt::format("(-{})", part())};
    case 1:
      return {fmt::format("({} {} {})", part(), random_.OneOf({"+", "-"}),
                          Make(entry, unit, depth - 1).text)};
    case 2:
      return {fmt::format("({} {} {})", Make(entry, unit, depth - 1).text,
                          random_.OneOf({"+", "-"}), part())};
    case 3:
      return {fmt::format("({} * {})", Make(numbers, unit, depth - 1).text,
                          Make(array, {}, depth - 1).text)};
    case 4: {
      if (entry != kVec3Type) return {fmt::format("{}.yx", part())};
      const std::string turn = Read(random_.OneOf({kQuaternionType, *FindType("mat3")}), {});
      return {turn.empty() ? fmt::format("{}.zzx", part())
                           : fmt::format("rotate({}, {})", turn, part())};
    }
    case 5:
      if (entry != kVec3Type) return {fmt::format("abs({})", part())};
      return {fmt::format("cross({}, {})", part(),
                          Make(random_.OneIn(2) ? entry : array, {}, depth - 1).text)};
    case 6:
      return {fmt::format("({} / {})", part(), VariableReal({}, depth - 1))};
    default:
      return {fmt::format("({} {} {})", part(), random_.OneOf({"+", "-"}), part())};
  }
}

std::string RandomExpressions::OfEachVector(const Type& type, const Unit& unit, int depth) {
  std::vector<Type> arrays;
  for (const Readable& readable : readable_) {
    const Type& array = readable.type;
    const bool is_plain = IsPlain(readable.unit) && HasVectors(array) && !IsOfQuaternions(array);
    const bool fits =
        type == EntryOf(array) || type == WithEntries(array, ScalarType(Scalar::kReal));
    if (is_plain && fits) arrays.push_back(array);
  }
  if (arrays.empty()) return "";
  const Type array = random_.OneOf(arrays);
  const std::string made = Make(array, unit, depth - 1).text;
  if (type == EntryOf(array)) {
    return fmt::format("{}({})", random_.OneOf({"sum", "min", "max", "mean"}), made);
  }
  if (random_.OneIn(2)) return fmt::format("norm({})", made);
  return fmt::format("dot({}, {})", made,
                     Make(random_.OneIn(2) ? EntryOf(array) : array, {}, depth - 1).text);
}

std::string RandomExpressions::Constructed(const std::string& type, uint32_t size, const Unit& unit,
                                           int depth) {
  std::string parts = VariableReal(unit, depth - 1);
  for (uint32_t i = 1; i < size; ++i) parts += ", " + VariableReal(unit, depth - 1);
  return fmt::format("{}({})", type, parts);
}

RandomExpressions::Text RandomExpressions::MakeMatrix(const Type& type, const Unit& unit,
                                                      int depth) {
  const auto part = [&] { return Make(type, unit, depth - 1).text; };
  const std::string read = Read(type, unit);
  if (depth <= 0) {
    if (!read.empty()) return {read};
    return {fmt::format("({} * {})", Read(type, {}), Literal(Scalar::kReal, unit).text)};
  }
  switch (random_.Below(5)) {
    case 0:
      return {fmt::format("({} {} {})", part(), random_.OneOf({"+", "-"}), part())};
    case 1:
      return {fmt::format("(-{})", part())};
    case 3:
      return {fmt::format("transpose({})", part())};
    case 2:
      return {fmt::format("({} * {})", Make(type, {}, depth - 1).text,
                          Make(ScalarType(Scalar::kReal), unit, depth - 1).text)};
    default:
      return {fmt::format("({} / {})", part(), VariableReal({}, depth - 1))};
  }
}

}  // namespace compiler
