#pragma once

#include "plugins/robot/robot_description.h"

namespace robot {

// Of a ball around the shape's center that holds it [m].
double RadiusAround(const LinkShape& shape);

}  // namespace robot
