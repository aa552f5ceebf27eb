#include "compiler/difference/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace compiler {
namespace {

constexpr size_t kShort = 30;  // texts that stand side by side

using Parts = std::vector<const OutlinePart*>;

const OutlinePart* Find(const TaskOutline& outline, const OutlinePart& part) {
  const auto found = std::ranges::find_if(outline.parts, [&](const OutlinePart& other) {
    return other.kind == part.kind && other.name == part.name;
  });
  return found != outline.parts.end() ? &*found : nullptr;
}

// Those of `outline` that `other` has not, by kind and name.
Parts Missing(const TaskOutline& outline, const TaskOutline& other) {
  Parts missing;
  for (const OutlinePart& part : outline.parts)
    if (Find(other, part) == nullptr) missing.push_back(&part);
  return missing;
}

// Of `facts` those about `what` that `other` has not, one in a line.
std::string Left(const std::vector<Fact>& facts, const std::vector<Fact>& other,
                 const std::string& what) {
  std::multiset<Fact> known(other.begin(), other.end());
  std::string left;
  for (const Fact& fact : facts) {
    if (fact.what != what) continue;
    const auto same = known.find(fact);
    if (same != known.end()) {
      known.erase(same);
    } else {
      left += (left.empty() ? "" : "\n") + fact.text;
    }
  }
  return left;
}

void CompareFacts(const OutlinePart& first, const OutlinePart& second,
                  std::vector<TaskChange>& changes) {
  std::vector<std::string> known;
  for (const OutlinePart* part : {&first, &second}) {
    for (const Fact& fact : part->facts) {
      if (std::ranges::find(known, fact.what) != known.end()) continue;
      known.push_back(fact.what);
      const std::string before = Left(first.facts, second.facts, fact.what);
      const std::string after = Left(second.facts, first.facts, fact.what);
      if (before.empty() && after.empty()) continue;
      changes.push_back({TaskChange::kChanged, first.kind, first.name, fact.what, before, after});
    }
  }
}

std::string AllFacts(const OutlinePart& part) {
  std::string text;
  for (const Fact& fact : part.facts)
    text += fmt::format("{}{}: {}", text.empty() ? "" : "\n", fact.what, fact.text);
  return text;
}

// The part of the same kind and facts among `parts`, which is taken out of them.
const OutlinePart* TakeSame(const OutlinePart& part, Parts& parts) {
  const auto found = std::ranges::find_if(parts, [&](const OutlinePart* other) {
    return other->kind == part.kind && !part.name.empty() && other->facts == part.facts;
  });
  if (found == parts.end()) return nullptr;
  const OutlinePart* same = *found;
  parts.erase(found);
  return same;
}

// Events that do the same in another order.
void CompareOrders(const TaskOutline& first, const TaskOutline& second,
                   std::vector<TaskChange>& changes) {
  for (const auto& [event, order] : first.orders) {
    const auto other = second.orders.find(event);
    if (other == second.orders.end() || other->second == order) continue;
    if (!std::ranges::is_permutation(order, other->second)) continue;
    const auto [before, after] = std::ranges::mismatch(order, other->second);
    changes.push_back({TaskChange::kChanged, "event", event, "order", *before, *after});
  }
}

std::string Title(const TaskChange& change) {
  return change.name.empty() ? change.part : fmt::format("{} {}", change.part, change.name);
}

// Each line behind `sign`.
std::string Lines(std::string_view sign, std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    lines += fmt::format("  {} {}\n", sign, line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return lines;
}

std::string ToText(const TaskChange& change) {
  const std::string title = Title(change);
  switch (change.kind) {
    case TaskChange::kAdded:
      return fmt::format("{}: added\n{}", title, Lines("+", change.after));
    case TaskChange::kRemoved:
      return fmt::format("{}: removed\n{}", title, Lines("-", change.before));
    case TaskChange::kRenamed:
      return fmt::format("{}: renamed to {}\n", title, change.after);
    case TaskChange::kChanged:
      break;
  }
  const bool is_short = change.before.size() <= kShort && change.after.size() <= kShort &&
                        !change.before.empty() && !change.after.empty() &&
                        (change.before + change.after).find('\n') == std::string::npos;
  if (is_short)
    return fmt::format("{}: {}: {} -> {}\n", title, change.what, change.before, change.after);
  return fmt::format("{}: {}\n{}{}", title, change.what, Lines("-", change.before),
                     Lines("+", change.after));
}

}  // namespace

std::vector<TaskChange> Compare(const TaskOutline& first, const TaskOutline& second) {
  std::vector<TaskChange> changes;
  Parts added = Missing(second, first);
  for (const OutlinePart& part : first.parts) {
    if (const OutlinePart* other = Find(second, part)) {
      CompareFacts(part, *other, changes);
    } else if (const OutlinePart* same = TakeSame(part, added)) {
      changes.push_back({TaskChange::kRenamed, part.kind, part.name, "", "", same->name});
    } else {
      changes.push_back({TaskChange::kRemoved, part.kind, part.name, "", AllFacts(part), ""});
    }
  }
  for (const OutlinePart* part : added)
    changes.push_back({TaskChange::kAdded, part->kind, part->name, "", "", AllFacts(*part)});
  CompareOrders(first, second, changes);
  return changes;
}

std::string ToText(const std::vector<TaskChange>& changes) {
  std::string text;
  for (const TaskChange& change : changes) text += ToText(change);
  return text;
}

}  // namespace compiler
