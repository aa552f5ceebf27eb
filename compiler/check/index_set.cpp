#include "compiler/check/index_set.h"

#include <algorithm>

#include "compiler/check/names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/syntax/foreign_words.h"

namespace compiler {
namespace {

using Indices = std::vector<uint32_t>;

void AddOnce(Indices& set, const Indices& more) {
  for (const uint32_t index : more)
    if (std::ranges::find(set, index) == set.end()) set.push_back(index);
}

Help SmallerFirst(Span range, const std::string& turned) {
  return {fmt::format("write the smaller end first: `{}`", turned), {{range, turned}}};
}

// Resolves items recursively. Empty results are legal in here: only the whole must not be empty.
class IndexResolver {
 public:
  IndexResolver(const IndexDomain& domain, const TaskScope& scope)
      : domain_(domain), scope_(scope) {}

  std::optional<Indices> Resolve(const Expression& item) {
    return std::visit([&](const auto& node) { return ResolveNode(node, item.span); }, item.node);
  }

  // All items are looked at, so that all mistakes are reported.
  std::optional<Indices> ResolveAll(const std::vector<ExpressionPtr>& items) {
    Indices set;
    bool is_valid = true;
    for (const ExpressionPtr& item : items) {
      const auto indices = Resolve(*item);
      if (indices) AddOnce(set, *indices);
      is_valid = is_valid && indices;
    }
    return is_valid ? std::optional(set) : std::nullopt;
  }

 private:
  std::optional<Indices> ResolveNode(const NumberLiteral& number, Span span) {
    if (!number.is_integer || number.unit) return NotAnIndex(span);
    return ResolveNumber(number.value, span);
  }

  std::optional<Indices> ResolveNumber(double number, Span span) {
    if (number >= 0 && number < domain_.size) return Indices{static_cast<uint32_t>(number)};
    Report(scope_.diagnostics, code::kIndexOutOfRange, span,
           fmt::format("index {} is out of range", number),
           {.note = fmt::format("valid are 0 .. {}", domain_.size - 1)});
    return std::nullopt;
  }

  std::optional<Indices> ResolveNode(const NameExpression& name, Span span) {
    const std::string& text = name.name.text;
    const Symbol* symbol = FindSymbol(name.name, scope_);
    if (symbol != nullptr && IsLoopVariable(*symbol)) return ResolveVariable(text, *symbol, span);
    if (symbol != nullptr && IsNamedConstant(*symbol)) return ResolveConstant(text, *symbol, span);
    if (symbol == nullptr && scope_.refused.contains(text)) return std::nullopt;
    if (domain_.names == nullptr) return NotAnIndex(span);
    if (auto indices = domain_.names->Find(text)) return indices;
    if (const Enumeration* other = FindEnumerationOf(scope_.enumerations, text))
      return WrongEnumeration(text, *other, span);
    if (symbol != nullptr) return NotAnIndex(span);
    if (!scope_.knows_names || scope_.refused.contains(text)) return std::nullopt;
    Report(scope_.diagnostics, code::kUnknownPart, span,
           fmt::format("the robot has no {} or group of {} called `{}`", domain_.names->name,
                       domain_.names->all, text),
           {.help = Suggest(span, text, KnownNames(), domain_.names->all + " and groups")});
    return std::nullopt;
  }

  std::vector<std::string> KnownNames() const {
    std::vector<std::string> names = domain_.names->Names();
    for (const CheckedSet& set : scope_.constants.sets)
      if (set.parts == domain_.names->name || set.parts.empty()) names.push_back(set.name);
    return names;
  }

  // The variable of a loop is what it stands for in the pass.
  std::optional<Indices> ResolveVariable(const std::string& text, const Symbol& variable,
                                         Span span) {
    if (!variable.is_valid) return std::nullopt;
    if (variable.kind == SymbolKind::kLoopNumber) return ResolveNumber(variable.index, span);
    const std::string& parts = variable.type.index;
    if (domain_.names != nullptr && domain_.names->name == parts) return Indices{variable.index};
    if (domain_.names != nullptr)
      return WrongEnumeration(text, *FindEnumeration(scope_.enumerations, parts), span);
    return NumbersWanted(fmt::format("`{}` is a {} of the robot", text, parts), variable, span);
  }

  std::optional<Indices> ResolveConstant(const std::string& text, const Symbol& constant,
                                         Span span) {
    if (!constant.is_valid) return std::nullopt;
    if (constant.kind == SymbolKind::kSet) return ResolveSet(text, constant, span);
    if (const auto number = NumberOf(constant)) return ResolveNumber(*number, span);
    Report(
        scope_.diagnostics, code::kNotAnIndex, span,
        fmt::format("`{}` is {}, and an index is an `int`", text,
                    constant.kind == SymbolKind::kTable ? "a table" : WithArticle(constant.type)),
        {.labels = {{constant.span, "declared here"}}});
    return std::nullopt;
  }

  // Numbers may stand for parts of the robot as well, as far as there are so many.
  std::optional<Indices> ResolveSet(const std::string& text, const Symbol& symbol, Span span) {
    const CheckedSet& set = scope_.constants.sets[symbol.index];
    if (domain_.names != nullptr && domain_.names->name == set.parts) return set.indices;
    if (!set.parts.empty()) {
      const Enumeration& other = *FindEnumeration(scope_.enumerations, set.parts);
      if (domain_.names != nullptr) return WrongEnumeration(text, other, span);
      return NumbersWanted(fmt::format("`{}` is a set of {}", text, other.all), symbol, span);
    }
    const auto beyond =
        std::ranges::find_if(set.indices, [&](uint32_t index) { return index >= domain_.size; });
    if (beyond == set.indices.end()) return set.indices;
    Report(scope_.diagnostics, code::kIndexOutOfRange, span,
           fmt::format("index {} of the set `{}` is out of range", *beyond, text),
           {.note = fmt::format("valid are 0 .. {}", domain_.size - 1),
            .labels = {{symbol.span, "declared here"}}});
    return std::nullopt;
  }

  // `is`: what is there instead, "`l` is a link of the robot".
  std::nullopt_t NumbersWanted(const std::string& is, const Symbol& symbol, Span span) {
    Report(scope_.diagnostics, code::kWrongEnumeration, span,
           fmt::format("{}, but numbers are the index here", is),
           {.help = fmt::format("valid are 0 .. {}", domain_.size - 1),
            .labels = {{symbol.span, IsLoopVariable(symbol) ? "defined here" : "declared here"}}});
    return std::nullopt;
  }

  std::optional<Indices> ResolveNode(const RangeExpression& range, Span span) {
    const auto first = ResolveEnd(*range.first);
    const auto last = ResolveEnd(*range.last);
    if (!first || !last) return std::nullopt;
    if (*first > *last) {
      Report(scope_.diagnostics, code::kEmptySet, span,
             fmt::format("the range from {} to {} is empty", *first, *last),
             {.help = SmallerFirst(span, fmt::format("{}..{}", *last, *first))});
      return std::nullopt;
    }
    Indices indices;
    for (uint32_t index = *first; index <= *last; ++index) indices.push_back(index);
    return indices;
  }

  std::optional<Indices> ResolveNode(const SetExpression& set, Span) {
    return ResolveAll(set.items);
  }

  std::optional<Indices> ResolveNode(const BinaryExpression& binary, Span span) {
    const bool is_union = binary.op == BinaryOperator::kAdd;
    if (!is_union && binary.op != BinaryOperator::kSubtract) return NotAnIndex(span);
    const auto left_number = NumberOf(*binary.left);
    const auto right_number = NumberOf(*binary.right);
    if (left_number && right_number) {
      if (const auto sum = Calculate(binary, *left_number, *right_number); sum.has_variable)
        return ResolveNumber(sum.value, span);
      Report(scope_.diagnostics, code::kNotAnIndex, span, "an index is not computed",
             {.note = "`+` joins two sets here, `-` removes one from another",
              .help = "write the number itself, or sets in braces: `{1} + {2}`"});
      return std::nullopt;
    }
    auto left = Resolve(*binary.left);
    const auto right = Resolve(*binary.right);
    if (!left || !right) return std::nullopt;
    if (is_union) {
      AddOnce(*left, *right);
    } else {
      std::erase_if(
          *left, [&](uint32_t index) { return std::ranges::find(*right, index) != right->end(); });
    }
    return left;
  }

  std::optional<Indices> ResolveNode(const UnaryExpression& unary, Span span) {
    const auto* number = std::get_if<NumberLiteral>(&unary.operand->node);
    if (unary.op != UnaryOperator::kNegate || number == nullptr) return NotAnIndex(span);
    Report(scope_.diagnostics, code::kIndexOutOfRange, span,
           fmt::format("index -{} is out of range", number->value),
           {.note = fmt::format("valid are 0 .. {}", domain_.size - 1)});
    return std::nullopt;
  }

  // `for i in range(3)`
  std::optional<Indices> ResolveNode(const CallExpression& call, Span span) {
    if (call.function.text != "range" || call.arguments.size() != 1) return NotAnIndex(span);
    Help help = HelpForForeign(ForeignPlace::kFunction, call.function.text, span);
    const auto* number = std::get_if<NumberLiteral>(&call.arguments.front()->node);
    if (number != nullptr && number->is_integer && number->value > 1) {
      const std::string range = fmt::format("0..{}", number->value - 1);
      help = {fmt::format("a range includes both ends: `{}`", range), {{span, range}}};
    }
    Report(scope_.diagnostics, code::kNotAnIndex, span, "a set is not made by a function",
           {.help = std::move(help)});
    return std::nullopt;
  }

  std::optional<Indices> ResolveNode(const LostExpression&, Span) { return std::nullopt; }

  template <typename Node>
  std::optional<Indices> ResolveNode(const Node&, Span span) {
    return NotAnIndex(span);
  }

  // An end of a range: a number, or a name that stands for one element.
  std::optional<uint32_t> ResolveEnd(const Expression& end) {
    const auto indices = Resolve(end);
    if (!indices) return std::nullopt;
    if (indices->size() == 1) return indices->front();
    Report(scope_.diagnostics, code::kNotAnIndex, end.span, "a range ends at a single element",
           {.note = fmt::format("these are {}", indices->size())});
    return std::nullopt;
  }

  // A single number, as far as sums are concerned: `i + 1` is calculated if `i` is the variable of
  // a loop or a const, everything else is a set.
  struct Number {
    double value = 0;
    bool has_variable = false;
  };

  std::optional<Number> NumberOf(const Expression& item) const {
    if (const auto* number = std::get_if<NumberLiteral>(&item.node)) return Number{number->value};
    if (const auto* name = std::get_if<NameExpression>(&item.node)) {
      const Symbol* symbol = FindSymbol(name->name, scope_);
      const auto number = symbol != nullptr ? NumberOf(*symbol) : std::nullopt;
      if (number) return Number{*number, true};
    }
    const auto* binary = std::get_if<BinaryExpression>(&item.node);
    const bool is_sum = binary != nullptr && (binary->op == BinaryOperator::kAdd ||
                                              binary->op == BinaryOperator::kSubtract);
    if (!is_sum) return std::nullopt;
    const auto left = NumberOf(*binary->left);
    const auto right = NumberOf(*binary->right);
    if (!left || !right) return std::nullopt;
    return Calculate(*binary, *left, *right);
  }

  // Of the variable of a loop over numbers, and of a const that is an `int`.
  std::optional<double> NumberOf(const Symbol& symbol) const {
    if (!symbol.is_valid) return std::nullopt;
    if (symbol.kind == SymbolKind::kLoopNumber) return symbol.index;
    const bool is_int =
        symbol.kind == SymbolKind::kConst && symbol.type == ScalarType(Scalar::kInt);
    if (!is_int) return std::nullopt;
    return scope_.constants.consts[symbol.index].elements.front();
  }

  static Number Calculate(const BinaryExpression& binary, Number left, Number right) {
    const bool is_sum = binary.op == BinaryOperator::kAdd;
    return {is_sum ? left.value + right.value : left.value - right.value,
            left.has_variable || right.has_variable};
  }

  std::nullopt_t WrongEnumeration(const std::string& part, const Enumeration& other, Span span) {
    Report(
        scope_.diagnostics, code::kWrongEnumeration, span,
        fmt::format("`{}` belongs to the {} of the robot, but {} are indexed here", part, other.all,
                    domain_.names->all),
        {.help = Suggest(span, part, domain_.names->Names(), domain_.names->all + " and groups")});
    return std::nullopt;
  }

  std::nullopt_t NotAnIndex(Span span) {
    const std::string names =
        domain_.names == nullptr ? "" : fmt::format(", names of {}, groups", domain_.names->all);
    const bool is_index = domain_.use == IndexUse::kIndex;
    Report(scope_.diagnostics, code::kNotAnIndex, span,
           fmt::format("{} must be known before the task runs", NameOf(domain_.use)),
           {.help = fmt::format("integers{}, ranges such as `0..{}` and sets of these can "
                                "{}",
                                names, is_index ? domain_.size - 1 : 3,
                                is_index ? "be an index" : "be used here")});
    return std::nullopt;
  }

  static std::string_view NameOf(IndexUse use) {
    switch (use) {
      case IndexUse::kIndex:
        return "an index";
      case IndexUse::kLoop:
        return "what a loop iterates over";
      case IndexUse::kSet:
        return "what a set holds";
    }
    return "";
  }

  const IndexDomain& domain_;
  const TaskScope& scope_;
};

std::optional<Indices> RefuseEmpty(std::optional<Indices> indices, Span span,
                                   const TaskScope& scope) {
  if (!indices || !indices->empty()) return indices;
  Report(scope.diagnostics, code::kEmptySet, span, "no element is left in this set");
  return std::nullopt;
}

}  // namespace

std::optional<Indices> ResolveIndexItem(const Expression& item, const IndexDomain& domain,
                                        const TaskScope& scope) {
  return RefuseEmpty(IndexResolver(domain, scope).Resolve(item), item.span, scope);
}

std::optional<Indices> ResolveIndexSet(const std::vector<ExpressionPtr>& items, Span span,
                                       const IndexDomain& domain, const TaskScope& scope) {
  return RefuseEmpty(IndexResolver(domain, scope).ResolveAll(items), span, scope);
}

}  // namespace compiler
