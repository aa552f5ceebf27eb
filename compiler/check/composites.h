// Functions of the language, and the product of two quaternions, that are equations of others. A
// call is replaced by its equation, so that nothing after the checker has to know them.
//
//   mean(v)                 sum(v) / n
//   normalize(v)            v / max(norm(v), smallest), so that a vector of zeros stays one
//   rotate(q, v)            v + w t + u x t, with q = (w, u) of length 1 and t = 2 u x v
//   rotate(m, v)            m v
//   inverse(q)              (w, -x, -y, -z) / |q|^2
//   transpose(m)            the element i, j becomes j, i
//   roll(q)                 atan2(2 (w x + y z), 1 - 2 (x^2 + y^2)): about the x axis
//   pitch(q)                asin(2 (w y - z x)): about the y axis, from -pi / 2 to pi / 2
//   yaw(q)                  atan2(2 (w z + x y), 1 - 2 (y^2 + z^2)): about the z axis
//   angle_between(v, w)     atan2(norm(v x w), v . w), from 0 to pi
//   wrap(a)                 a - 2 pi ceil((a - pi) / (2 pi)): above -pi, up to pi
//   tolerance(x, l, h, m)   exp(-ln 10 (max(l - x, x - h, 0) / m)^2): 1 from l to h, 0.1 at a
//                           distance m from there
//
// So are some others where they are called with arrays of vectors:
//
//   sum(a), min(a), max(a)  vec3(sum(a.x), sum(a.y), sum(a.z)), and so on
//   cross(a, b)             a.yzx b.zxy - a.zxy b.yzx
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

// From the one list in builtin_table.def.
enum class Composite {
#define COMPOSITE(id, name, least, most, arguments, units, usage) id,
#include "compiler/check/builtin_table.def"
};

// The equation of a call, with checked arguments of reals; its type, and the unit as given.
// Reports and returns nothing where the arguments are too large to stand in it several times, or
// where it has no value.
std::optional<CheckedExpression> Expand(std::variant<Builtin, Composite> function, Span span,
                                        const Unit& unit, std::vector<CheckedExpression> arguments,
                                        Diagnostics& diagnostics);

// The same, of `q * p`, Hamilton's product of two quaternions.
std::optional<CheckedExpression> ExpandProduct(CheckedExpression q, CheckedExpression p, Span span,
                                               const Unit& unit, Diagnostics& diagnostics);

}  // namespace compiler
