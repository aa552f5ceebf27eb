// Units and types as random tasks write them.
#pragma once

#include <string>

#include "compiler/check/checked_task.h"

namespace compiler {

inline constexpr Unit kRadianUnit{.radian = 1};
inline const Type kVec3Type{Scalar::kReal, Shape::kVector, 3};
inline const Type kQuaternionType{Scalar::kReal, Shape::kQuaternion, 4};

// Whether products with it are still units that a task may have.
bool IsSmall(const Unit& unit);

// A type with a unit, as a declaration writes it: "vec3 [m/s]".
std::string DeclaredType(const Type& type, const Unit& unit);
// " m/s" or " / s", to stand behind a number; "" for a plain one.
std::string UnitOfLiteral(const Unit& unit);

}  // namespace compiler
