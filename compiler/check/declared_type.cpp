#include "compiler/check/declared_type.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "compiler/check/expressions.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/syntax/foreign_words.h"

namespace compiler {
namespace {

// A length as written in the brackets of an array type; nothing if it is not a number.
std::optional<uint64_t> LengthOf(const std::string& text) {
  if (text.empty() || !std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  uint64_t length = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  return error == std::errc{} ? length : uint64_t{kLargestArray} + 1;
}

std::optional<Type> CheckArray(const Type& entry, const Identifier& index, const TaskScope& scope) {
  if (const auto length = LengthOf(index.text)) {
    if (*length >= 1 && *length * entry.size() <= kLargestArray)
      return ArrayOf(entry, static_cast<uint32_t>(*length));
    Report(scope.diagnostics, code::kBadArrayType, index.span,
           fmt::format("an array{} has 1 to {} elements",
                       IsScalar(entry) ? "" : fmt::format(" of `{}`", ToString(entry)),
                       kLargestArray / entry.size()));
    return std::nullopt;
  }
  if (const Enumeration* enumeration = FindEnumeration(scope.enumerations, index.text))
    return ArrayOf(entry, enumeration->size(), enumeration->name);
  // `real [Nm]`: what is no unit is read as an index.
  if (Help help = HelpForForeign(ForeignPlace::kUnit, index.text, index.span); !help.empty()) {
    Report(scope.diagnostics, code::kUnknownUnit, index.span,
           fmt::format("there is no unit `{}`", index.text), {.help = std::move(help)});
    return std::nullopt;
  }
  if (!scope.knows_robot) return std::nullopt;
  std::vector<std::string> valid;
  for (const Enumeration& enumeration : scope.enumerations) valid.push_back(enumeration.name);
  Report(scope.diagnostics, code::kBadArrayType, index.span,
         fmt::format("an array cannot be indexed by `{}`", index.text),
         {.help = scope.has_robot ? fmt::format("write a number, or one of {}", List(valid))
                                  : "write a number: only a robot has links, joints and sites"});
  return std::nullopt;
}

std::optional<Type> CheckType(const TypeExpression& written, const TaskScope& scope) {
  const auto type = FindType(written.name.text);
  if (!type) {
    const Identifier& name = written.name;
    Help help = HelpForForeign(ForeignPlace::kType, name.text, name.span);
    if (help.empty()) help = Suggest(name.span, name.text, TypeNames(), "types");
    Report(scope.diagnostics, code::kUnknownType, name.span,
           fmt::format("there is no type `{}`", name.text), {.help = std::move(help)});
    return std::nullopt;
  }
  if (!written.index) return type;
  if (type->shape != Shape::kMatrix) return CheckArray(*type, *written.index, scope);
  Report(scope.diagnostics, code::kBadArrayType, written.span,
         fmt::format("there are no arrays of `{}`", ToString(*type)),
         {.help = "the elements of an array are single values, vectors or quaternions"});
  return std::nullopt;
}

}  // namespace

std::optional<DeclaredType> CheckDeclaredType(const TypeExpression& type,
                                              const std::optional<UnitExpression>& unit,
                                              const TaskScope& scope) {
  const auto checked = CheckType(type, scope);
  const auto scaled = CheckUnit(unit, scope.diagnostics);
  if (!checked || !scaled) return std::nullopt;
  if (unit && checked->scalar != Scalar::kReal) {
    Report(scope.diagnostics, code::kUnitWithoutReal, unit->span,
           fmt::format("{} has no unit", WithArticle(ScalarType(checked->scalar))),
           {.help = "declare it as `real`, or leave out the unit"});
    return std::nullopt;
  }
  if (scaled->numerator != scaled->denominator) {
    Report(
        scope.diagnostics, code::kScaledUnit, unit->span, "declarations are in SI units",
        {.note = "this is a multiple of one",
         .help = {fmt::format("write `[{}]`; numbers may have any unit of length, time and so on",
                              ToString(scaled->unit)),
                  {{unit->span, ToString(scaled->unit)}}}});
    return std::nullopt;
  }
  return DeclaredType{*checked, scaled->unit};
}

}  // namespace compiler
