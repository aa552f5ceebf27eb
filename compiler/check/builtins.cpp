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
    BuiltinDescription{"tan", Builtin::kTan, 1, 1, kRealScalars, UnitRule::kAngleToPlain,
                       "tan(angle)"},
    BuiltinDescription{"asin", Builtin::kAsin, 1, 1, kRealScalars, UnitRule::kPlainToAngle,
                       "asin(x)"},
    BuiltinDescription{"acos", Builtin::kAcos, 1, 1, kRealScalars, UnitRule::kPlainToAngle,
                       "acos(x)"},
    BuiltinDescription{"atan", Builtin::kAtan, 1, 1, kRealScalars, UnitRule::kPlainToAngle,
                       "atan(x)"},
    BuiltinDescription{"pow", Builtin::kPow, 2, 2, kRealScalars, UnitRule::kAllPlain, "pow(x, y)"},
    BuiltinDescription{"sign", Builtin::kSign, 1, 1, kElements, UnitRule::kToPlain, "sign(x)"},
    BuiltinDescription{"floor", Builtin::kFloor, 1, 1, kRealScalars, UnitRule::kPlain, "floor(x)"},
    BuiltinDescription{"ceil", Builtin::kCeil, 1, 1, kRealScalars, UnitRule::kPlain, "ceil(x)"},
    BuiltinDescription{"round", Builtin::kRound, 1, 1, kRealScalars, UnitRule::kPlain, "round(x)"},
    BuiltinDescription{"select", Builtin::kSelect, 3, 3, kChoice, UnitRule::kSame,
                       "select(condition, x, y)"},
    BuiltinDescription{"vec2", Builtin::kVector, 2, 2, kParts, UnitRule::kSame, "vec2(x, y)"},
    BuiltinDescription{"vec3", Builtin::kVector, 3, 3, kParts, UnitRule::kSame, "vec3(x, y, z)"},
    BuiltinDescription{"vec4", Builtin::kVector, 4, 4, kParts, UnitRule::kSame, "vec4(x, y, z, w)"},
    BuiltinDescription{"quat", Builtin::kVector, 4, 4, kParts, UnitRule::kSame, "quat(w, x, y, z)"},
    BuiltinDescription{
        "mean", {}, 1, 1, kNumbers, UnitRule::kSame, "mean(values)", Composite::kMean},
    BuiltinDescription{
        "normalize", {}, 1, 1, kRow, UnitRule::kToPlain, "normalize(v)", Composite::kNormalize},
    BuiltinDescription{"rotate",
                       {},
                       2,
                       2,
                       kRotation,
                       UnitRule::kOfRotated,
                       "rotate(rotation, v)",
                       Composite::kRotate},
    BuiltinDescription{
        "inverse", {}, 1, 1, kQuaternion, UnitRule::kPlain, "inverse(q)", Composite::kInverse},
    BuiltinDescription{
        "transpose", {}, 1, 1, kMatrix, UnitRule::kSame, "transpose(m)", Composite::kTranspose},
    BuiltinDescription{
        "roll", {}, 1, 1, kQuaternion, UnitRule::kPlainToAngle, "roll(q)", Composite::kRoll},
    BuiltinDescription{
        "pitch", {}, 1, 1, kQuaternion, UnitRule::kPlainToAngle, "pitch(q)", Composite::kPitch},
    BuiltinDescription{
        "yaw", {}, 1, 1, kQuaternion, UnitRule::kPlainToAngle, "yaw(q)", Composite::kYaw},
    BuiltinDescription{"angle_between",
                       {},
                       2,
                       2,
                       kTwoVec3,
                       UnitRule::kToAngle,
                       "angle_between(v, w)",
                       Composite::kAngleBetween},
    BuiltinDescription{
        "wrap", {}, 1, 1, kRealScalars, UnitRule::kAngle, "wrap(angle)", Composite::kWrap},
    BuiltinDescription{"tolerance",
                       {},
                       4,
                       4,
                       kRealScalars,
                       UnitRule::kSameToPlain,
                       "tolerance(x, low, high, margin)",
                       Composite::kTolerance},
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
