// Conditions and numbers.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "tests/compiler/random/random_expression.h"
#include "tests/compiler/random/random_units.h"

namespace compiler {

RandomExpressions::Text RandomExpressions::MakeBool(int depth) {
  const Type boolean = ScalarType(Scalar::kBool);
  switch (random_.Below(5)) {
    case 0: {
      const Scalar scalar = random_.OneOf({Scalar::kInt, Scalar::kReal});
      const Unit unit = scalar == Scalar::kReal ? RandomUnit() : Unit{};
      const Text left = Make(ScalarType(scalar), unit, depth - 1);
      const Text right = Make(ScalarType(scalar), unit, depth - 1);
      return {fmt::format("({} {} {})", left.text,
                          random_.OneOf({"<", "<=", ">", ">=", "==", "!="}), right.text),
              left.is_constant && right.is_constant};
    }
    case 1: {
      const Text operand = Make(boolean, {}, depth - 1);
      return {fmt::format("(not {})", operand.text), operand.is_constant};
    }
    case 2: {
      return {fmt::format("{}({})", random_.OneOf({"any", "all", "none"}), SomeConditions(depth))};
    }
    default: {
      const Text left = Make(boolean, {}, depth - 1);
      const Text right = Make(boolean, {}, depth - 1);
      return {fmt::format("({} {} {})", left.text, random_.OneOf({"and", "or", "==", "!="}),
                          right.text),
              left.is_constant || right.is_constant};
    }
  }
}

// A row of conditions where there is one, or comparisons of the elements of a row.
std::string RandomExpressions::SomeConditions(int depth) {
  if (const auto numbers = RandomRow(Scalar::kReal); numbers && random_.OneIn(2)) {
    const Unit unit = RandomUnit();
    return Comparison(*numbers, random_.OneIn(2) ? *numbers : ScalarType(Scalar::kReal), unit,
                      depth);
  }
  const auto row = RandomRow(Scalar::kBool);
  return row ? Make(*row, {}, depth - 2).text : Read(ScalarType(Scalar::kBool), {});
}

std::string RandomExpressions::Comparison(const Type& left, const Type& right, const Unit& unit,
                                          int depth) {
  return fmt::format("({} {} {})", Make(left, unit, depth - 2).text,
                     random_.OneOf({"<", "<=", ">", ">=", "==", "!="}),
                     Make(right, unit, depth - 2).text);
}

RandomExpressions::Text RandomExpressions::MakeConditions(const Type& type, int depth) {
  const auto part = [&] { return Make(type, {}, depth - 1).text; };
  Type numbers = type;
  numbers.scalar = Scalar::kReal;
  switch (depth <= 0 ? 0 : random_.Below(6)) {
    case 0:
      return {Read(type, {})};
    case 1:
      return {fmt::format("(not {})", part())};
    case 2:
      if (Read(numbers, {}).empty()) return {part()};
      return {Comparison(numbers, random_.OneIn(2) ? numbers : ScalarType(Scalar::kReal),
                         RandomUnit(), depth)};
    case 3:
      return {fmt::format("select({}, {}, {})",
                          random_.OneIn(2) ? part() : MakeBool(depth - 1).text, part(), part())};
    case 4:
      return {fmt::format("({} {} {})", MakeBool(depth - 1).text,
                          random_.OneOf({"and", "or", "==", "!="}), part())};
    default:
      return {fmt::format("({} {} {})", part(), random_.OneOf({"and", "or", "==", "!="}), part())};
  }
}

RandomExpressions::Text RandomExpressions::MakeInt(int depth) {
  const Type integer = ScalarType(Scalar::kInt);
  const auto part = [&] { return Make(integer, {}, depth - 1).text; };
  switch (random_.Below(7)) {
    case 0: {
      return {fmt::format("count({})", SomeConditions(depth))};
    }
    case 1:
      return {fmt::format("{}({}, {})", random_.OneOf({"min", "max"}), part(),
                          Variable(integer, {}, depth - 1))};
    case 2:
      return {fmt::format("clamp({}, {}, {})", Variable(integer, {}, depth - 1), part(), part())};
    case 3:
      return {fmt::format("abs({})", Variable(integer, {}, depth - 1))};
    case 4: {
      const auto row = RandomRow(Scalar::kInt);
      if (!row) return {Variable(integer, {}, depth - 1)};
      return {fmt::format("{}({})", random_.OneOf({"sum", "min", "max"}),
                          Make(*row, {}, depth - 2).text)};
    }
    case 5:
      return {fmt::format("(-{})", Variable(integer, {}, depth - 1))};
    default:
      return {fmt::format("({} {} {})", part(), random_.OneOf({"+", "-", "*"}),
                          Variable(integer, {}, depth - 1))};
  }
}

RandomExpressions::Text RandomExpressions::MakeReal(const Unit& unit, int depth) {
  if (random_.OneIn(3)) return MakeReduction(unit, depth);
  if (IsPlain(unit) && random_.OneIn(3)) {
    switch (random_.Below(8)) {
      case 5:
        return {fmt::format("sign({})", VariableReal(RandomUnit(), depth - 1))};
      case 6:
        return {
            fmt::format("pow({}, {})", VariableReal({}, depth - 1), VariableReal({}, depth - 1))};
      case 7: {
        const Unit common = RandomUnit();
        return {fmt::format("tolerance({}, {}, {}, {})", VariableReal(common, depth - 1),
                            VariableReal(common, depth - 1), VariableReal(common, depth - 1),
                            VariableReal(common, depth - 1))};
      }
      case 0:
        return {fmt::format("{}({})",
                            random_.OneOf({"exp", "log", "tanh", "floor", "ceil", "round"}),
                            VariableReal({}, depth - 1))};
      case 1:
        return {fmt::format("{}({})", random_.OneOf({"sin", "cos", "tan"}),
                            VariableReal(kRadianUnit, depth - 1))};
      case 2:
        return {fmt::format("({} / {})", Variable(ScalarType(Scalar::kInt), {}, depth - 1),
                            Variable(ScalarType(Scalar::kInt), {}, depth - 1))};
      case 3:
        return {fmt::format("({} {} {})", Variable(ScalarType(Scalar::kInt), {}, depth - 1),
                            random_.OneOf({"+", "-", "*"}), VariableReal({}, depth - 1))};
      default:
        return {"pi", true};
    }
  }
  if (unit == kRadianUnit && random_.OneIn(3)) {
    if (random_.OneIn(3)) {
      return {fmt::format("{}({})", random_.OneOf({"asin", "acos", "atan"}),
                          VariableReal({}, depth - 1))};
    }
    if (random_.OneIn(4)) return {fmt::format("wrap({})", VariableReal(kRadianUnit, depth - 1))};
    if (const std::string turn = Read(kQuaternionType, {}); !turn.empty() && random_.OneIn(4)) {
      return {fmt::format("{}({})", random_.OneOf({"roll", "pitch", "yaw"}), turn)};
    }
    if (random_.OneIn(4) && !Read(kVec3Type, {}).empty()) {
      return {fmt::format("angle_between({}, {})", Make(kVec3Type, RandomUnit(), depth - 2).text,
                          Make(kVec3Type, RandomUnit(), depth - 2).text)};
    }
    const Unit common = RandomUnit();
    return {fmt::format("atan2({}, {})", VariableReal(common, depth - 1),
                        VariableReal(common, depth - 1))};
  }
  return MakeRealOfReals(unit, depth);
}

RandomExpressions::Text RandomExpressions::MakeRealOfReals(const Unit& unit, int depth) {
  const Type real = ScalarType(Scalar::kReal);
  const auto part = [&] { return Make(real, unit, depth - 1); };
  switch (random_.Below(9)) {
    case 8:
      return {fmt::format("select({}, {}, {})", Variable(ScalarType(Scalar::kBool), {}, depth - 1),
                          part().text, part().text)};
    case 0: {
      const Text left = part();
      return {fmt::format("(-{})", left.text), left.is_constant};
    }
    case 1:
      return {fmt::format("{}({}, {}, {})", random_.OneOf({"min", "max", "clamp"}), part().text,
                          part().text, VariableReal(unit, depth - 1))};
    case 2:
      return {fmt::format("abs({})", VariableReal(unit, depth - 1))};
    case 3: {
      const auto squared = Multiply(unit, unit);
      if (!squared || !IsSmall(*squared)) return part();
      return {fmt::format("sqrt({})", VariableReal(*squared, depth - 1))};
    }
    case 4: {
      const Unit other = RandomUnit();
      const auto product = Multiply(unit, other);
      if (!product || !IsSmall(*product)) return part();
      return {fmt::format("({} / {})", VariableReal(*product, depth - 1),
                          VariableReal(other, depth - 1))};
    }
    case 5: {
      const Unit other = RandomUnit();
      const auto quotient = Divide(unit, other);
      if (!quotient || !IsSmall(*quotient)) return part();
      return {fmt::format("({} * {})", Make(real, *quotient, depth - 1).text,
                          VariableReal(other, depth - 1))};
    }
    default: {
      const Text left = part();
      const Text right = part();
      return {fmt::format("({} {} {})", left.text, random_.OneOf({"+", "-"}), right.text),
              left.is_constant && right.is_constant};
    }
  }
}

RandomExpressions::Text RandomExpressions::MakeReduction(const Unit& unit, int depth) {
  const auto row = RandomRow(Scalar::kReal);
  if (!row) return MakeRealOfReals(unit, depth);
  if (random_.OneIn(3)) {
    const Unit other = RandomUnit();
    if (const auto quotient = Divide(unit, other); quotient && IsSmall(*quotient)) {
      return {fmt::format("dot({}, {})", Make(*row, *quotient, depth - 2).text,
                          Make(*row, other, depth - 2).text)};
    }
  }
  return {fmt::format("{}({})", random_.OneOf({"sum", "norm", "min", "max", "mean"}),
                      Make(*row, unit, depth - 2).text)};
}

}  // namespace compiler
