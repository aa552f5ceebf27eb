// Interval arithmetic for the functions of the language beyond those of interval.h.
#pragma once

#include "compiler/bounds/interval.h"

namespace compiler {

Interval Sign(const Interval& x);
Interval Floor(const Interval& x);
Interval Ceil(const Interval& x);
// Half away from 0.
Interval Round(const Interval& x);
Interval Pow(const Interval& x, const Interval& y);
Interval Tan(const Interval& angle);
Interval Asin(const Interval& x);
Interval Acos(const Interval& x);
Interval Atan(const Interval& x);
// To (-pi, pi].
Interval Wrap(const Interval& angle);
// From -1 to 1, of the same sign as `x`: a coordinate of a unit vector.
Interval UnitCoordinate(const Interval& x);
// 1 from `low` to `high`, outside a Gaussian that is 0.1 at the distance `margin`.
Interval Tolerance(const Interval& x, const Interval& low, const Interval& high,
                   const Interval& margin);

}  // namespace compiler
