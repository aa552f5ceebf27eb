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

}  // namespace compiler
