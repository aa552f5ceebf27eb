#include "compiler/check/elements.h"

#include <string_view>
#include <utility>

#include "compiler/check/builtins.h"
#include "compiler/check/fold.h"
#include "compiler/check/index_set.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/syntax/foreign_words.h"

namespace compiler {
namespace {

constexpr size_t kLongestSwizzle = 4;  // the longest vector type

// What members are taken from: a value, or each entry of an array.
Type WholeOf(const Type& type) { return HasVectors(type) ? EntryOf(type) : type; }

std::string_view LettersOf(const Type& type) {
  const Type whole = WholeOf(type);
  if (whole.shape == Shape::kQuaternion) return "wxyz";
  if (whole.shape == Shape::kVector) return std::string_view("xyzw").substr(0, whole.rows);
  return "";
}

std::string HelpForMember(const Type& type) {
  const Type whole = WholeOf(type);
  switch (whole.shape) {
    case Shape::kScalar:
      return "a single value has no parts";
    case Shape::kMatrix:
      return "write row and column in brackets: `[0, 2]`";
    case Shape::kArray:
      return type.index.empty() ? "write an index in brackets: `[0]`"
                                : fmt::format("write the name of a {} in brackets", type.index);
    case Shape::kVector:
    case Shape::kQuaternion:
      break;
  }
  std::vector<std::string> letters;
  for (const char letter : LettersOf(type)) letters.emplace_back(1, letter);
  return fmt::format("the elements of a `{}` are {}; several make a vector, as in `.{}`",
                     ToString(whole), List(letters), LettersOf(type).substr(0, 2));
}

// `m.T`, `v.norm`: what is a function here; `otherwise`: the help for anything else.
std::string HelpForFunction(const std::string& member, std::string otherwise) {
  const ForeignWord* foreign = FindForeign(ForeignPlace::kFunction, member);
  const std::string function = foreign != nullptr ? std::string(foreign->instead) : member;
  const BuiltinDescription* builtin = FindBuiltin(function);
  return builtin != nullptr ? fmt::format("it is a function here: `{}`", builtin->usage)
                            : std::move(otherwise);
}

// What `picked` of the elements of each of `rows` rows stand at, where a row has `columns`.
std::vector<uint32_t> InEachRow(const std::vector<uint32_t>& picked, uint32_t rows,
                                uint32_t columns) {
  std::vector<uint32_t> indices;
  for (uint32_t row = 0; row < rows; ++row)
    for (const uint32_t column : picked) indices.push_back(row * columns + column);
  return indices;
}

// Some of the elements that a call of Builtin::kVector lists, where these are constants: nothing
// else must be taken out of it.
std::optional<CheckedExpression> PickConstants(const CheckedExpression& list,
                                               const std::vector<uint32_t>& indices,
                                               const Type& type, Span span) {
  const auto* call = std::get_if<BuiltinCall>(&list.node);
  if (call == nullptr || call->function != Builtin::kVector) return std::nullopt;
  BuiltinCall picked{Builtin::kVector, {}};
  for (const uint32_t index : indices) {
    const CheckedExpression& element = *call->arguments[index];
    const auto value = ValueOf(element);
    if (!value) return std::nullopt;
    picked.arguments.push_back(std::make_unique<CheckedExpression>(
        CheckedExpression{span, element.type, list.unit, Constant{*value}}));
  }
  if (IsScalar(type)) return std::move(*picked.arguments.front());
  return CheckedExpression{span, type, list.unit, std::move(picked)};
}

std::optional<CheckedExpression> CheckMatrixIndex(CheckedExpression matrix,
                                                  const std::vector<ExpressionPtr>& items,
                                                  Span span, const TaskScope& scope) {
  if (items.size() != 2) {
    Report(scope.diagnostics, code::kMatrixIndex, span,
           fmt::format("a `{}` is indexed by row and column", ToString(matrix.type)),
           {.help = "write two indices: `[0, 2]`, or `[0..2, 2]` for a column"});
    return std::nullopt;
  }
  const auto rows = ResolveIndexItem(*items[0], {.size = matrix.type.rows}, scope);
  const auto columns = ResolveIndexItem(*items[1], {.size = matrix.type.columns}, scope);
  if (!rows || !columns) return std::nullopt;
  if (rows->size() > 1 && columns->size() > 1) {
    Report(scope.diagnostics, code::kMatrixIndex, span,
           "only one row or one column can be taken at a time",
           {.help = "let one of the two indices be a single number"});
    return std::nullopt;
  }
  std::vector<uint32_t> indices;
  for (const uint32_t row : *rows)
    for (const uint32_t column : *columns) indices.push_back(row * matrix.type.columns + column);
  const Type type = ElementsType(matrix.type, static_cast<uint32_t>(indices.size()));
  return PickElements(std::move(matrix), std::move(indices), type, span);
}

}  // namespace

std::optional<CheckedExpression> CheckMember(CheckedExpression operand, const Identifier& member,
                                             Diagnostics& diagnostics) {
  const std::string_view letters = LettersOf(operand.type);
  std::vector<uint32_t> indices;
  for (const char letter : member.text) {
    const size_t index = letters.find(letter);
    if (index == std::string_view::npos) break;
    indices.push_back(static_cast<uint32_t>(index));
  }
  if (indices.size() < member.text.size() || indices.size() > kLongestSwizzle) {
    Report(diagnostics, code::kUnknownElement, member.span,
           fmt::format("{} has no element `{}`", WithArticle(operand.type), member.text),
           {.help = HelpForFunction(member.text, HelpForMember(operand.type))});
    return std::nullopt;
  }
  const Span span = Cover(operand.span, member.span);
  const Type whole = WholeOf(operand.type);
  Type type = ElementsType(whole, static_cast<uint32_t>(indices.size()));
  if (HasVectors(operand.type)) {
    type = WithEntries(operand.type, type);
    indices = InEachRow(indices, operand.type.rows, operand.type.columns);
  }
  return PickElements(std::move(operand), std::move(indices), type, span);
}

std::optional<CheckedExpression> CheckIndex(CheckedExpression operand,
                                            const std::vector<ExpressionPtr>& items, Span span,
                                            const TaskScope& scope) {
  const Type& type = operand.type;
  if (IsScalar(type)) {
    Report(scope.diagnostics, code::kNotIndexable, span,
           fmt::format("a single `{}` has no elements to index", ToString(type)));
    return std::nullopt;
  }
  if (type.shape == Shape::kMatrix) return CheckMatrixIndex(std::move(operand), items, span, scope);
  const IndexDomain domain{type.rows, FindEnumeration(scope.enumerations, type.index)};
  const auto set = ResolveIndexSet(items, span, domain, scope);
  if (!set) return std::nullopt;
  const Type picked = ElementsType(type, static_cast<uint32_t>(set->size()));
  std::vector<uint32_t> indices;
  for (const uint32_t row : *set)
    for (uint32_t column = 0; column < type.columns; ++column)
      indices.push_back(row * type.columns + column);
  return PickElements(std::move(operand), std::move(indices), picked, span);
}

CheckedExpression PickElements(CheckedExpression operand, std::vector<uint32_t> indices,
                               const Type& type, Span span) {
  if (auto constants = PickConstants(operand, indices, type, span)) return std::move(*constants);
  const Unit unit = operand.unit;
  if (auto* inner = std::get_if<Elements>(&operand.node)) {
    for (uint32_t& index : indices) index = inner->indices[index];
    CheckedExpressionPtr whole = std::move(inner->operand);
    return {span, type, unit, Elements{std::move(whole), std::move(indices)}};
  }
  auto whole = std::make_unique<CheckedExpression>(std::move(operand));
  return {span, type, unit, Elements{std::move(whole), std::move(indices)}};
}

CheckedExpression InEachEntry(CheckedExpression vector, const Type& array) {
  const Span span = vector.span;
  std::vector<uint32_t> indices;
  for (uint32_t i = 0; i < array.size(); ++i) indices.push_back(i % array.columns);
  return PickElements(std::move(vector), std::move(indices), array, span);
}

CheckedExpression InAllOfEachEntry(CheckedExpression numbers, const Type& array) {
  const Span span = numbers.span;
  std::vector<uint32_t> indices;
  for (uint32_t i = 0; i < array.size(); ++i) indices.push_back(i / array.columns);
  return PickElements(std::move(numbers), std::move(indices), array, span);
}

void MakeAlike(CheckedExpression& left, CheckedExpression& right) {
  const auto spread = [](CheckedExpression& operand, const Type& array) {
    if (!HasVectors(array) || HasVectors(operand.type) || IsScalar(operand.type)) return;
    const bool is_vector = operand.type.shape == Shape::kVector;
    operand = is_vector ? InEachEntry(std::move(operand), array)
                        : InAllOfEachEntry(std::move(operand), array);
  };
  spread(left, right.type);
  spread(right, left.type);
}

}  // namespace compiler
