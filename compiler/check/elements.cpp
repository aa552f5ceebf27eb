#include "compiler/check/elements.h"

#include <string_view>
#include <utility>

#include "compiler/check/index_set.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

constexpr size_t kLongestSwizzle = 4;  // the longest vector type

std::string_view LettersOf(const Type& type) {
  if (type.shape == Shape::kQuaternion) return "wxyz";
  if (type.shape == Shape::kVector) return std::string_view("xyzw").substr(0, type.rows);
  return "";
}

std::string HelpForMember(const Type& type) {
  switch (type.shape) {
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
                     ToString(type), List(letters), LettersOf(type).substr(0, 2));
}

// Elements of elements are elements of the first operand.
CheckedExpression Select(CheckedExpression operand, std::vector<uint32_t> indices, Span span) {
  const Type type = ElementsType(operand.type, static_cast<uint32_t>(indices.size()));
  const Unit unit = operand.unit;
  if (auto* inner = std::get_if<Elements>(&operand.node)) {
    for (uint32_t& index : indices) index = inner->indices[index];
    CheckedExpressionPtr whole = std::move(inner->operand);
    return {span, type, unit, Elements{std::move(whole), std::move(indices)}};
  }
  auto whole = std::make_unique<CheckedExpression>(std::move(operand));
  return {span, type, unit, Elements{std::move(whole), std::move(indices)}};
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
  return Select(std::move(matrix), std::move(indices), span);
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
           {.help = HelpForMember(operand.type)});
    return std::nullopt;
  }
  const Span span = Cover(operand.span, member.span);
  return Select(std::move(operand), std::move(indices), span);
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
  auto indices = ResolveIndexSet(items, span, domain, scope);
  if (!indices) return std::nullopt;
  return Select(std::move(operand), std::move(*indices), span);
}

}  // namespace compiler
