#pragma once

#include "plugins/robot/robot_description.h"

namespace robot {

// Of a ball around the shape's center that holds it [m].
double RadiusAround(const LinkShape& shape);

// How far from its center the shape reaches along a unit vector in its own frame [m].
double ReachAlong(const LinkShape& shape, const Vector3& direction);

}  // namespace robot
