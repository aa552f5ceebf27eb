#include "tests/compiler/random/random_expression.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "tests/compiler/random/random_units.h"

namespace compiler {

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

}  // namespace compiler
