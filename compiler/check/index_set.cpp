#include "compiler/check/index_set.h"

#include <algorithm>

#include "compiler/check/report.h"

namespace compiler {
namespace {

using Indices = std::vector<uint32_t>;

void AddOnce(Indices& set, const Indices& more) {
  for (const uint32_t index : more)
    if (std::ranges::find(set, index) == set.end()) set.push_back(index);
}

// Resolves items recursively. Empty results are legal in here: only the whole must not be empty.
class IndexResolver {
 public:
  IndexResolver(const IndexDomain& domain, Diagnostics& diagnostics)
      : domain_(domain), diagnostics_(diagnostics) {}

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
    if (number.value >= domain_.size) {
      Report(diagnostics_, code::kIndexOutOfRange, span,
             fmt::format("index {} is out of range", number.value),
             {.note = fmt::format("valid are 0 .. {}", domain_.size - 1)});
      return std::nullopt;
    }
    return Indices{static_cast<uint32_t>(number.value)};
  }

  std::optional<Indices> ResolveNode(const NameExpression& name, Span span) {
    const std::string& text = name.name.text;
    if (domain_.names != nullptr) {
      if (auto indices = domain_.names->Find(text)) return indices;
      if (const Enumeration* other = FindEnumerationOf(*domain_.enumerations, text))
        return WrongEnumeration(text, *other, span);
      Report(diagnostics_, code::kUnknownPart, span,
             fmt::format("the robot has no {} or group of {} called `{}`", domain_.names->name,
                         domain_.names->all, text),
             {.help = Suggest(text, domain_.names->Names(), domain_.names->all + " and groups")});
      return std::nullopt;
    }
    return NotAnIndex(span);
  }

  std::optional<Indices> ResolveNode(const RangeExpression& range, Span span) {
    const auto first = ResolveEnd(*range.first);
    const auto last = ResolveEnd(*range.last);
    if (!first || !last) return std::nullopt;
    if (*first > *last) {
      Report(diagnostics_, code::kEmptySet, span,
             fmt::format("the range from {} to {} is empty", *first, *last),
             {.help = fmt::format("write the smaller end first: `{}..{}`", *last, *first)});
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
    if (IsNumber(*binary.left) && IsNumber(*binary.right)) {
      Report(diagnostics_, code::kNotAnIndex, span, "an index is not calculated",
             {.note = "`+` joins two sets here, `-` takes one out of another",
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
    Report(diagnostics_, code::kIndexOutOfRange, span,
           fmt::format("index -{} is out of range", number->value),
           {.note = fmt::format("valid are 0 .. {}", domain_.size - 1)});
    return std::nullopt;
  }

  template <typename Node>
  std::optional<Indices> ResolveNode(const Node&, Span span) {
    return NotAnIndex(span);
  }

  // An end of a range: a number, or a name that stands for one element.
  std::optional<uint32_t> ResolveEnd(const Expression& end) {
    const auto indices = Resolve(end);
    if (!indices) return std::nullopt;
    if (indices->size() == 1) return indices->front();
    Report(diagnostics_, code::kNotAnIndex, end.span, "a range ends at a single element",
           {.note = fmt::format("these are {}", indices->size())});
    return std::nullopt;
  }

  static bool IsNumber(const Expression& item) {
    return std::holds_alternative<NumberLiteral>(item.node);
  }

  std::nullopt_t WrongEnumeration(const std::string& part, const Enumeration& other, Span span) {
    Report(diagnostics_, code::kWrongEnumeration, span,
           fmt::format("`{}` belongs to the {} of the robot, but {} are indexed here", part,
                       other.all, domain_.names->all),
           {.help = Suggest(part, domain_.names->Names(), domain_.names->all + " and groups")});
    return std::nullopt;
  }

  std::nullopt_t NotAnIndex(Span span) {
    const std::string names =
        domain_.names == nullptr ? "" : fmt::format(", names of {}, groups", domain_.names->all);
    Report(diagnostics_, code::kNotAnIndex, span, "an index must be known before the task runs",
           {.help = fmt::format("whole numbers{}, ranges such as `0..{}` and sets of these can be "
                                "an index",
                                names, domain_.size - 1)});
    return std::nullopt;
  }

  const IndexDomain& domain_;
  Diagnostics& diagnostics_;
};

std::optional<Indices> RefuseEmpty(std::optional<Indices> indices, Span span,
                                   Diagnostics& diagnostics) {
  if (!indices || !indices->empty()) return indices;
  Report(diagnostics, code::kEmptySet, span, "no element is left in this set");
  return std::nullopt;
}

}  // namespace

std::optional<Indices> ResolveIndexItem(const Expression& item, const IndexDomain& domain,
                                        Diagnostics& diagnostics) {
  return RefuseEmpty(IndexResolver(domain, diagnostics).Resolve(item), item.span, diagnostics);
}

std::optional<Indices> ResolveIndexSet(const std::vector<ExpressionPtr>& items, Span span,
                                       const IndexDomain& domain, Diagnostics& diagnostics) {
  return RefuseEmpty(IndexResolver(domain, diagnostics).ResolveAll(items), span, diagnostics);
}

}  // namespace compiler
