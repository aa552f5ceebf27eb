#include "compiler/check/written_form.h"

#include <fmt/format.h>

#include <algorithm>

namespace compiler {

std::vector<Identifier> PathOf(const Expression& expression) {
  std::vector<Identifier> path;
  const Expression* object = &expression;
  while (const auto* member = std::get_if<MemberExpression>(&object->node)) {
    path.push_back(member->member);
    object = member->object.get();
  }
  const auto* root = std::get_if<NameExpression>(&object->node);
  if (root == nullptr) return {};
  path.push_back(root->name);
  std::ranges::reverse(path);
  return path;
}

std::optional<std::string> WrittenForm(const Expression& expression) {
  if (const auto* name = std::get_if<NameExpression>(&expression.node)) return name->name.text;
  if (const auto* number = std::get_if<NumberLiteral>(&expression.node)) {
    if (!number->is_integer || number->unit) return std::nullopt;
    return fmt::format("{}", number->value);
  }
  if (const auto* member = std::get_if<MemberExpression>(&expression.node)) {
    const auto object = WrittenForm(*member->object);
    return object ? std::optional(*object + "." + member->member.text) : std::nullopt;
  }
  if (const auto* index = std::get_if<IndexExpression>(&expression.node)) {
    const auto object = WrittenForm(*index->object);
    const auto items = WrittenForm(index->items);
    return object && items ? std::optional(*object + "[" + *items + "]") : std::nullopt;
  }
  return std::nullopt;
}

std::optional<std::string> WrittenForm(const std::vector<ExpressionPtr>& expressions) {
  std::string text;
  for (const ExpressionPtr& expression : expressions) {
    const auto written = WrittenForm(*expression);
    if (!written) return std::nullopt;
    text += (text.empty() ? "" : ", ") + *written;
  }
  return text;
}

}  // namespace compiler
