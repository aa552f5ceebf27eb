#include "compiler/document/reads.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace compiler {
namespace {

std::optional<std::string> PlaceOf(const Expression& expression);

// `left_foot` or `2` in brackets; nothing for what several are picked by.
std::optional<std::string> OneIndex(const IndexExpression& index) {
  if (index.items.size() != 1) return std::nullopt;
  const auto& item = index.items.front()->node;
  if (const auto* name = std::get_if<NameExpression>(&item)) return name->name.text;
  if (const auto* number = std::get_if<NumberLiteral>(&item))
    return fmt::format("{}", number->value);
  return std::nullopt;
}

// The name that leads to what is read; nothing where that is computed.
std::optional<std::string> PlaceOf(const Expression& expression) {
  if (const auto* name = std::get_if<NameExpression>(&expression.node)) return name->name.text;
  if (const auto* member = std::get_if<MemberExpression>(&expression.node)) {
    const auto object = PlaceOf(*member->object);
    if (!object) return std::nullopt;
    return *object + "." + member->member.text;
  }
  if (const auto* index = std::get_if<IndexExpression>(&expression.node)) {
    const auto object = PlaceOf(*index->object);
    const auto item = OneIndex(*index);
    if (!object || !item) return std::nullopt;
    return *object + "[" + *item + "]";
  }
  return std::nullopt;
}

struct PartReader {
  std::vector<std::string>& reads;

  void operator()(const MemberExpression& node) const { AddReads(*node.object, reads); }
  void operator()(const IndexExpression& node) const { AddReads(*node.object, reads); }
  void operator()(const CallExpression& node) const {
    for (const ExpressionPtr& argument : node.arguments) AddReads(*argument, reads);
  }
  void operator()(const UnaryExpression& node) const { AddReads(*node.operand, reads); }
  void operator()(const BinaryExpression& node) const {
    AddReads(*node.left, reads);
    AddReads(*node.right, reads);
  }
  void operator()(const NumberLiteral&) const {}
  void operator()(const BoolLiteral&) const {}
  void operator()(const NameExpression&) const {}
  void operator()(const RangeExpression&) const {}
  void operator()(const SetExpression&) const {}
  // A task with errors has no page.
  void operator()(const MethodExpression&) const {}
  void operator()(const LostExpression&) const {}
};

}  // namespace

void AddReads(const Expression& expression, std::vector<std::string>& reads) {
  const auto place = PlaceOf(expression);
  if (!place) {
    std::visit(PartReader{reads}, expression.node);
  } else if (std::ranges::find(reads, *place) == reads.end()) {
    reads.push_back(*place);
  }
}

std::vector<std::string> ReadsOf(const Expression& expression) {
  std::vector<std::string> reads;
  AddReads(expression, reads);
  return reads;
}

}  // namespace compiler
