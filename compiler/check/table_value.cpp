#include "compiler/check/table_value.h"

#include <algorithm>
#include <cmath>

#include "compiler/check/type.h"

namespace compiler {
namespace {

// Between which rows, and how far from the first to the second.
struct TablePlace {
  size_t from = 0;
  size_t to = 0;
  double share = 0;
};

double InFirstRound(const CheckedTable& table, double argument) {
  const double first = table.arguments.front();
  const double length = table.duration();
  const double passed = argument - first;
  return first + (passed - std::floor(passed / length) * length);
}

// An argument that is no number gives a share that is none.
TablePlace PlaceOf(const CheckedTable& table, double argument) {
  const std::vector<double>& at = table.arguments;
  if (argument >= at.back()) return {at.size() - 1, at.size() - 1, 0};
  if (!(argument > at.front())) return {0, 0, std::isnan(argument) ? argument : 0};
  const auto next = static_cast<size_t>(std::ranges::upper_bound(at, argument) - at.begin());
  return {next - 1, next, (argument - at[next - 1]) / (at[next] - at[next - 1])};
}

// Never beyond `to`, however the sum is rounded.
double Between(double from, double to, double share) {
  const double value = from + (to - from) * share;
  return from < to ? (value > to ? to : value) : (value < to ? to : value);
}

void Normalize(double* rotation) {
  double square = 0;
  for (int i = 0; i < 4; ++i) square += rotation[i] * rotation[i];
  const double length = std::sqrt(square);
  for (int i = 0; i < 4; ++i) rotation[i] /= length;
}

}  // namespace

Reals ValueAt(const CheckedTable& table, double argument, bool repeats) {
  const size_t size = table.type.size();
  const TablePlace place = PlaceOf(table, repeats ? InFirstRound(table, argument) : argument);
  Reals value(size);
  for (size_t i = 0; i < size; ++i)
    value[i] = Between(table.elements[place.from * size + i], table.elements[place.to * size + i],
                       place.share);
  if (IsOfQuaternions(table.type))
    for (size_t i = 0; i < size; i += 4) Normalize(&value[i]);
  return value;
}

}  // namespace compiler
