#include "tests/compiler/random/random_expression.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/check/type.h"
#include "compiler/check/unit.h"

namespace compiler {
namespace {

constexpr Unit kRadian{.radian = 1};
const Type kVec3{Scalar::kReal, Shape::kVector, 3};
const Type kQuaternion{Scalar::kReal, Shape::kQuaternion, 4};

struct Factor {
  std::string_view name;
  int power;
};

std::vector<Factor> FactorsOf(const Unit& unit) {
  return {{"m", unit.meter}, {"kg", unit.kilogram}, {"s", unit.second}, {"rad", unit.radian}};
}

std::string Power(const Factor& factor, int power) {
  return power == 1 ? std::string(factor.name) : fmt::format("{}^{}", factor.name, power);
}

bool IsSmall(const Unit& unit) {
  for (const Factor& factor : FactorsOf(unit)) {
    if (factor.power < -3 || factor.power > 3) return false;
  }
  return true;
}

}  // namespace

std::string UnitOfLiteral(const Unit& unit) {
  std::string above;
  std::string below;
  for (const Factor& factor : FactorsOf(unit)) {
    if (factor.power > 0) above += (above.empty() ? " " : "*") + Power(factor, factor.power);
    if (factor.power < 0) below += " / " + Power(factor, -factor.power);
  }
  return above + below;
}

std::string TypeText(const Type& type, const Unit& unit) {
  if (IsPlain(unit)) return ToString(type);
  std::string text;
  for (const Factor& factor : FactorsOf(unit)) {
    if (factor.power != 0) text += (text.empty() ? "" : " ") + Power(factor, factor.power);
  }
  return fmt::format("{} [{}]", ToString(type), text);
}

RandomExpressions::RandomExpressions(RandomNumbers& random, const std::vector<Readable>& readable,
                                     const std::vector<Callable>& callable)
    : random_(random), readable_(readable), callable_(callable) {}

Type RandomExpressions::RandomType() {
  if (random_.OneIn(4)) return ScalarType(random_.OneOf({Scalar::kInt, Scalar::kReal}));
  return random_.OneOf(readable_).type;
}

Unit RandomExpressions::RandomUnit() {
  static const std::vector<Unit> units = {{},
                                          {},
                                          {.meter = 1},
                                          {.second = 1},
                                          {.radian = 1},
                                          {.meter = 1, .second = -1},
                                          {.second = -1},
                                          {.meter = 1, .kilogram = 1, .second = -2}};
  return random_.OneOf(units);
}

std::optional<Type> RandomExpressions::RandomRow(Scalar scalar) {
  std::vector<Type> rows;
  for (const Readable& readable : readable_) {
    const Type& type = readable.type;
    const bool is_row = IsRow(type) && !HasVectors(type);
    if (is_row && type.scalar == scalar && IsPlain(readable.unit)) rows.push_back(type);
  }
  return rows.empty() ? std::nullopt : std::optional(random_.OneOf(rows));
}

// Scalars can always be made; of what has a shape there must be something plain to begin with.
bool RandomExpressions::CanMakeArguments(const Callable& function) {
  return std::ranges::all_of(function.arguments, [this](const Readable& argument) {
    return IsScalar(argument.type) || !Read(argument.type, {}).empty();
  });
}

std::string RandomExpressions::Call(const Type& type, const Unit& unit, int depth) {
  std::vector<const Callable*> fitting;
  for (const Callable& callable : callable_) {
    const bool gives_it = callable.type == type && callable.unit == unit && !callable.is_open;
    if (gives_it && CanMakeArguments(callable)) fitting.push_back(&callable);
    const bool is_real =
        type.scalar == Scalar::kReal && (IsScalar(type) || IsRow(type)) && !HasVectors(type);
    if (callable.is_open && is_real && !Read(type, {}).empty()) fitting.push_back(&callable);
  }
  if (fitting.empty()) return "";
  const Callable& function = *random_.OneOf(fitting);
  if (function.is_open) return CallOfElements(function, type, unit, depth);
  std::string arguments;
  for (const Readable& argument : function.arguments) {
    arguments += arguments.empty() ? "" : ", ";
    arguments += Make(argument.type, argument.unit, depth - 2).text;
  }
  return fmt::format("{}({})", function.name, arguments);
}

// Rows where the result is one, and single values among them.
std::string RandomExpressions::CallOfElements(const Callable& function, const Type& type,
                                              const Unit& unit, int depth) {
  const auto number = [&](const Unit& of) {
    const bool is_single = random_.OneIn(3);
    return Make(is_single ? ScalarType(Scalar::kReal) : type, of, depth - 2).text;
  };
  return fmt::format("{}({}, {}, {}, {})", function.name, Variable(type, unit, depth - 2),
                     number(unit), number({}), MakeBool(depth - 2).text);
}

RandomExpressions::Text RandomExpressions::Literal(Scalar scalar, const Unit& unit) {
  switch (scalar) {
    case Scalar::kBool:
      return {random_.OneOf({"true", "false"}), true};
    case Scalar::kInt:
      return {std::to_string(random_.Below(12)), true};
    case Scalar::kReal:
      break;
  }
  static const std::vector<std::string> numbers = {"0.5",  "1.0",  "2.0",   "0.1",  "3.25",
                                                   "1e-3", "17.0", "1.5e4", "0.25", "0.0"};
  return {"(" + random_.OneOf(numbers) + UnitOfLiteral(unit) + ")", true};
}

// ---- Names and their elements -------------------------------------------------------------------

std::string RandomExpressions::ElementOf(const Readable& whole) {
  const Type& type = whole.type;
  if (type.shape == Shape::kMatrix) {
    return fmt::format("{}[{}, {}]", whole.name, random_.Below(type.rows),
                       random_.Below(type.columns));
  }
  if (HasVectors(type)) {
    const char letter = "xyzw"[random_.Below(type.columns)];
    return fmt::format(fmt::runtime(random_.OneIn(2) ? "{0}[{1}].{2}" : "{0}.{2}[{1}]"), whole.name,
                       random_.Below(type.rows), letter);
  }
  const bool has_letters = type.shape != Shape::kArray;
  const uint32_t index = random_.Below(type.size());
  if (!has_letters || (type.shape == Shape::kVector && random_.OneIn(3))) {
    return fmt::format("{}[{}]", whole.name, index);
  }
  return fmt::format("{}.{}", whole.name, "xyzw"[index]);
}

std::string RandomExpressions::Read(const Type& type, const Unit& unit) {
  std::vector<std::string> reads;
  for (const Readable& readable : readable_) {
    if (readable.unit != unit || readable.type.scalar != type.scalar) continue;
    if (readable.type == type) {
      reads.push_back(readable.name);
    } else if (IsScalar(type) && readable.is_constant) {
      continue;
    } else if (IsScalar(type)) {
      reads.push_back(ElementOf(readable));
    } else if (std::string part = PartOf(readable, type); !part.empty()) {
      reads.push_back(std::move(part));
    }
  }
  return reads.empty() ? "" : random_.OneOf(reads);
}

std::string RandomExpressions::PartOf(const Readable& whole, const Type& type) {
  const Type& from = whole.type;
  if (HasVectors(from) && type == EntryOf(from)) {
    return fmt::format("{}[{}]", whole.name, random_.Below(from.rows));
  }
  if (HasVectors(from) && type == WithEntries(from, ScalarType(Scalar::kReal))) {
    return fmt::format("{}.{}", whole.name, "xyzw"[random_.Below(from.columns)]);
  }
  const bool is_longer = IsRow(type) && from.rows > type.rows && from.columns == type.columns;
  if (!is_longer || from.shape != type.shape || from.entry != type.entry) return "";
  const uint32_t first = random_.Below(from.rows - type.rows + 1);
  return fmt::format("{}[{}..{}]", whole.name, first, first + type.rows - 1);
}

std::string RandomExpressions::Variable(const Type& type, const Unit& unit, int depth) {
  const Text made = Make(type, unit, depth);
  if (!made.is_constant) return made.text;
  if (std::string read = Read(type, unit); !read.empty()) return read;
  return fmt::format("({} * {})", made.text, Read(ScalarType(Scalar::kReal), {}));
}

std::string RandomExpressions::VariableReal(const Unit& unit, int depth) {
  return Variable(ScalarType(Scalar::kReal), unit, depth);
}

// ---- By type ------------------------------------------------------------------------------------

RandomExpressions::Text RandomExpressions::Make(const Type& type, const Unit& unit, int depth) {
  if (depth <= 0 || random_.OneIn(8)) {
    if (std::string read = Read(type, unit); !read.empty()) return {read};
    if (IsScalar(type) && (depth <= 0 || type.scalar != Scalar::kReal)) {
      return Literal(type.scalar, unit);
    }
  }
  if (depth > 0 && random_.OneIn(4)) {
    if (std::string call = Call(type, unit, depth); !call.empty()) return {call};
  }
  if (type.shape == Shape::kMatrix) return MakeMatrix(type, unit, depth);
  if (type.shape == Shape::kQuaternion) {
    if (random_.OneIn(6)) return {Constructed("quat", 4, {}, depth)};
    const std::string read = Read(type, {});
    if (random_.OneIn(4)) return {fmt::format("({} * {})", read, Make(type, {}, depth - 2).text)};
    return {random_.OneIn(3) ? fmt::format("inverse({})", read) : read};
  }
  if (HasVectors(type)) return MakeVectors(type, unit, depth);
  if (IsRow(type) && IsBool(type)) return MakeConditions(type, depth);
  if (IsRow(type)) return MakeRow(type, unit, depth);
  switch (type.scalar) {
    case Scalar::kBool:
      return MakeBool(depth);
    case Scalar::kInt:
      return MakeInt(depth);
    case Scalar::kReal:
      break;
  }
  return MakeReal(unit, depth);
}

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
                            VariableReal(kRadian, depth - 1))};
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
  if (unit == kRadian && random_.OneIn(3)) {
    if (random_.OneIn(3)) {
      return {fmt::format("{}({})", random_.OneOf({"asin", "acos", "atan"}),
                          VariableReal({}, depth - 1))};
    }
    if (random_.OneIn(4)) return {fmt::format("wrap({})", VariableReal(kRadian, depth - 1))};
    if (const std::string turn = Read(kQuaternion, {}); !turn.empty() && random_.OneIn(4)) {
      return {fmt::format("{}({})", random_.OneOf({"roll", "pitch", "yaw"}), turn)};
    }
    if (random_.OneIn(4) && !Read(kVec3, {}).empty()) {
      return {fmt::format("angle_between({}, {})", Make(kVec3, RandomUnit(), depth - 2).text,
                          Make(kVec3, RandomUnit(), depth - 2).text)};
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

RandomExpressions::Text RandomExpressions::MakeRow(const Type& type, const Unit& unit, int depth) {
  const auto part = [&] { return Make(type, unit, depth - 1).text; };
  const std::string read = Read(type, unit);
  const bool is_vector = type.shape == Shape::kVector;
  if (depth <= 0 && !read.empty()) return {read};
  if (type == kVec3 && depth > 0 && random_.OneIn(4)) return MakeVec3(unit, depth);
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
        return fmt::format("{}({})", random_.OneOf({"sin", "cos", "tan"}), of(kRadian));
      case 2:
        return fmt::format("pow({}, {})", part(), any());
      default:
        return fmt::format("tolerance({}, {}, {}, {})", part(), any(), any(),
                           VariableReal({}, depth - 2));
    }
  }
  if (is_real && unit == kRadian && random_.OneIn(2)) {
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
  const std::string turn = Read(kQuaternion, {});
  if (!turn.empty() && random_.OneIn(3)) {
    return {fmt::format("rotate({}, {})", turn, Make(kVec3, unit, depth - 1).text)};
  }
  if (IsPlain(unit) && random_.OneIn(2)) {
    return {fmt::format("normalize({})", Make(kVec3, RandomUnit(), depth - 1).text)};
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
      if (entry != kVec3) return {fmt::format("{}.yx", part())};
      const std::string turn = Read(random_.OneOf({kQuaternion, *FindType("mat3")}), {});
      return {turn.empty() ? fmt::format("{}.zzx", part())
                           : fmt::format("rotate({}, {})", turn, part())};
    }
    case 5:
      if (entry != kVec3) return {fmt::format("abs({})", part())};
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
