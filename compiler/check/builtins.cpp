#include "compiler/check/builtins.h"

#include <algorithm>
#include <array>

namespace compiler {
namespace {

using enum ArgumentRule;

constexpr std::array kBuiltins = {
    BuiltinDescription{"any", Builtin::kAny, 1, 1, kConditions, UnitRule::kNone, "any(conditions)"},
    BuiltinDescription{"all", Builtin::kAll, 1, 1, kConditions, UnitRule::kNone, "all(conditions)"},
    BuiltinDescription{"none", Builtin::kNone, 1, 1, kConditions, UnitRule::kNone,
                       "none(conditions)"},
    BuiltinDescription{"count", Builtin::kCount, 1, 1, kConditions, UnitRule::kNone,
                       "count(conditions)"},
    BuiltinDescription{"sum", Builtin::kSum, 1, 1, kNumbers, UnitRule::kSame, "sum(values)"},
    BuiltinDescription{"norm", Builtin::kNorm, 1, 1, kRow, UnitRule::kSame, "norm(v)"},
    BuiltinDescription{"dot", Builtin::kDot, 2, 2, kTwoRows, UnitRule::kProduct, "dot(v, w)"},
    BuiltinDescription{"cross", Builtin::kCross, 2, 2, kTwoVec3, UnitRule::kProduct, "cross(v, w)"},
    BuiltinDescription{"abs", Builtin::kAbs, 1, 1, kElements, UnitRule::kSame, "abs(x)"},
    // With a single argument `min` and `max` follow kNumbers.
    BuiltinDescription{"min", Builtin::kMin, 1, 8, kScalars, UnitRule::kSame,
                       "min(x, y)` or `min(values)"},
    BuiltinDescription{"max", Builtin::kMax, 1, 8, kScalars, UnitRule::kSame,
                       "max(x, y)` or `max(values)"},
    BuiltinDescription{"clamp", Builtin::kClamp, 3, 3, kScalars, UnitRule::kSame,
                       "clamp(x, low, high)"},
    BuiltinDescription{"sqrt", Builtin::kSqrt, 1, 1, kRealScalars, UnitRule::kSquareRoot,
                       "sqrt(x)"},
    BuiltinDescription{"exp", Builtin::kExp, 1, 1, kRealScalars, UnitRule::kPlain, "exp(x)"},
    BuiltinDescription{"log", Builtin::kLog, 1, 1, kRealScalars, UnitRule::kPlain, "log(x)"},
    BuiltinDescription{"tanh", Builtin::kTanh, 1, 1, kRealScalars, UnitRule::kPlain, "tanh(x)"},
    BuiltinDescription{"sin", Builtin::kSin, 1, 1, kRealScalars, UnitRule::kAngleToPlain,
                       "sin(angle)"},
    BuiltinDescription{"cos", Builtin::kCos, 1, 1, kRealScalars, UnitRule::kAngleToPlain,
                       "cos(angle)"},
    BuiltinDescription{"atan2", Builtin::kAtan2, 2, 2, kRealScalars, UnitRule::kSameToAngle,
                       "atan2(y, x)"},
};

}  // namespace

const BuiltinDescription* FindBuiltin(std::string_view name) {
  const auto found = std::ranges::find(kBuiltins, name, &BuiltinDescription::name);
  return found == kBuiltins.end() ? nullptr : &*found;
}

std::vector<std::string> BuiltinNames() {
  std::vector<std::string> names;
  for (const BuiltinDescription& builtin : kBuiltins) names.emplace_back(builtin.name);
  return names;
}

}  // namespace compiler
