// Random numbers: `uniform(low, high)`, `normal(mean, deviation)`, `choose(a, b, ...)`, in the
// equation of a goal.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/conversion.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

struct DrawDescription {
  std::string_view name;
  Distribution distribution;
  std::string_view usage;  // "uniform(low, high)"
  std::string_view doc;
};
inline constexpr DrawDescription kDraws[] = {
    {"uniform", Distribution::kUniform, "uniform(low, high)",
     "A number between the two, each as likely; of vectors each element by itself."},
    {"normal", Distribution::kNormal, "normal(mean, deviation)",
     "A number from the bell curve with this mean and standard deviation."},
    {"choose", Distribution::kChoice, "choose(x, y, ...)", "One of the values, each as likely."},
};

bool IsDrawFunction(std::string_view name);

// A call of one of them. `count`: how many random numbers the goal has had, which goes up by one.
// Reports and returns nothing where the arguments do not fit.
std::optional<CheckedExpression> CheckDraw(const Identifier& function, Span span,
                                           std::vector<Operand> arguments, uint32_t& count,
                                           Diagnostics& diagnostics);

// Where a random number stands for several, as `uniform(-1, 1)` does in `origin + uniform(-1, 1)`,
// each is drawn by itself: the types in `value`, which becomes a goal of type `goal`, are made so.
void DrawEachElement(CheckedExpression& value, const Type& goal);

}  // namespace compiler
