#include "compiler/language_server/bounds_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "compiler/bounds/bounds.h"

namespace compiler {
namespace {

std::string Describe(const Interval& values) {
  if (IsEmpty(values)) return "never";
  if (IsExact(values)) return fmt::format("always {:.4g}", values.low);
  if (IsBounded(values)) return fmt::format("between {:.4g} and {:.4g}", values.low, values.high);
  if (values.low > -kInfinity) return fmt::format("at least {:.4g}", values.low);
  if (values.high < kInfinity) return fmt::format("at most {:.4g}", values.high);
  return "";
}

// Nothing where the list has no such name.
template <typename Named>
std::optional<size_t> IndexOf(const std::string& name, const std::vector<Named>& list) {
  const auto found = std::ranges::find(list, name, &Named::name);
  return found == list.end() ? std::nullopt
                             : std::optional(static_cast<size_t>(found - list.begin()));
}

std::string Join(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "; " + second;
}

std::string DescribeTerm(const TermBounds& term) {
  const std::string rate = term.rate ? Describe(*term.rate) : "";
  const std::string payment = term.payment ? Describe(*term.payment) : "";
  if (term.potential) return Describe(PaymentOfPotential(*term.potential)) + " each action";
  return Join(rate.empty() ? "" : rate + " per second",
              payment.empty() ? "" : payment + " each time");
}

}  // namespace

std::string BoundsText(const Reference& reference, const CheckedTask& task) {
  if (reference.kind == ReferenceKind::kTerm) {
    const auto index = IndexOf(reference.name, task.terms);
    return index ? DescribeTerm(ComputeBounds(task).terms[*index]) : "";
  }
  if (reference.kind == ReferenceKind::kMetric) {
    const auto index = IndexOf(reference.name, task.metrics);
    return index ? Describe(ComputeBounds(task).metrics[*index].value) : "";
  }
  if (reference.kind == ReferenceKind::kObservation) {
    const auto index = IndexOf(reference.name, task.observations);
    return index ? Describe(ComputeBounds(task).observations[*index].value) : "";
  }
  if (reference.kind == ReferenceKind::kLog) {
    const auto index = IndexOf(reference.name, task.logs);
    return index ? Describe(ComputeBounds(task).logs[*index].value) : "";
  }
  return "";
}

}  // namespace compiler
