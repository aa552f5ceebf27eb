// How the surface of a robot looks.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/picture/color.h"

namespace runtime {

enum class Side { kLeft, kRight, kTrunk };

// By the words of a link's name: "left_shank".
Side SideOf(std::string_view link);

// How a link is painted: a color for each side, joints (balls of limbs) darker. Base and head have
// a dark plate on their front, without which front and back look alike.
struct Paint {
  Light light = Light::Zero();
  bool has_plate = false;
};

// The last `things` of them are no links and have a color of their own.
std::vector<Paint> PaintsOf(const std::vector<robot::Link>& links, size_t things = 0);

// The color at a place of the link's surface, in the link's frame.
Light ColorAt(const Paint& paint, const robot::LinkShape& shape, const Eigen::Vector3d& place);

// What light reaches a place.
struct Illumination {
  Eigen::Vector3d to_lamp, to_eye, to_fill;  // unit vectors
  bool is_lit = true;                        // by the lamp
  double openness = 1;                       // how much of its surroundings it sees
};

// The light that comes from a surface of this color to the eye.
Light Shade(const Light& color, const Eigen::Vector3d& normal, const Illumination& light);

}  // namespace runtime
