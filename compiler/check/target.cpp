#include "compiler/check/target.h"

#include <set>
#include <utility>

#include "compiler/check/elements.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

// As a message calls it: "`touched[...]`".
std::string NameOf(const Target& target) {
  std::string name = target.name.text;
  if (target.member) name += '.' + target.member->text;
  if (!target.items.empty()) name += "[...]";
  if (target.indexed_member) name += '.' + target.indexed_member->text;
  return fmt::format("`{}`", name);
}

bool HasRepetition(const std::vector<uint32_t>& elements) {
  return std::set<uint32_t>(elements.begin(), elements.end()).size() < elements.size();
}

}  // namespace

std::vector<Identifier> PathOf(const Target& target) {
  std::vector<Identifier> path;
  const std::string& text = target.name.text;
  uint32_t begin = target.name.span.begin;
  for (size_t start = 0; start <= text.size();) {
    const std::string part = text.substr(start, text.find('.', start) - start);
    const auto length = static_cast<uint32_t>(part.size());
    path.push_back({part, {begin, begin + length}});
    start += length + 1;
    begin += length + 1;
  }
  if (target.member) path.push_back(*target.member);
  return path;
}

std::optional<CheckedExpression> SelectTarget(CheckedExpression whole, const Target& target,
                                              size_t length, const TaskScope& scope) {
  const std::vector<Identifier> path = PathOf(target);
  std::optional<CheckedExpression> selected = std::move(whole);
  for (size_t i = length; i < path.size() && selected; ++i)
    selected = CheckMember(std::move(*selected), path[i], scope.diagnostics);
  if (selected && !target.items.empty())
    selected = CheckIndex(std::move(*selected), target.items, target.span, scope);
  if (selected && target.indexed_member)
    selected = CheckMember(std::move(*selected), *target.indexed_member, scope.diagnostics);
  if (!selected) return std::nullopt;
  selected->span = target.span;
  if (!HasRepetition(ElementsOf(*selected))) return selected;
  Report(scope.diagnostics, code::kRepeatedElement, target.span,
         fmt::format("an element of `{}` would be set twice", target.name.text),
         {.help = "name each element once"});
  return std::nullopt;
}

std::vector<uint32_t> ElementsOf(const CheckedExpression& target) {
  const auto* elements = std::get_if<Elements>(&target.node);
  return elements == nullptr ? std::vector<uint32_t>{} : elements->indices;
}

std::optional<CheckedExpression> FitTo(Operand value, const CheckedExpression& selected,
                                       const Target& target, const TaskScope& scope) {
  const Type& given = value.expression.type;
  Type wanted = selected.type;
  const bool is_part = std::holds_alternative<Elements>(selected.node);
  const bool is_for_each = HasVectors(wanted) && given == EntryOf(wanted);
  if (IsScalar(given)) {
    wanted = ScalarType(wanted.scalar);
  } else if (is_for_each) {
    wanted = given;
  } else if (is_part && wanted.shape == Shape::kArray && wanted.rows == given.rows) {
    wanted.index = given.index;  // elements are set in their order, whatever they belong to
  }
  auto fitting =
      ConvertTo(std::move(value), wanted, selected.unit, NameOf(target), scope.diagnostics);
  if (fitting && is_for_each) return InEachEntry(std::move(*fitting), selected.type);
  return fitting;
}

}  // namespace compiler
