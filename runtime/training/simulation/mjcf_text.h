// Elements of MJCF that robots and what is around them have in common.
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <iterator>
#include <string>
#include <utility>

#include "plugins/robot/robot_description.h"
#include "runtime/training/simulation/ode_library.h"

namespace runtime {

using MjcfText = fmt::memory_buffer;

template <class... Arguments>
void Append(MjcfText& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

std::string Numbers(const robot::Vector3& v);
std::string Numbers(const Eigen::Quaterniond& q);

// A geom of this name: in the frame of its body, or of the world with a place and a turn there. The
// mesh of a convex shape has the same name.
void AppendShape(const std::string& name, const robot::LinkShape& shape, MjcfText& text);
void AppendShapeAt(const std::string& name, const robot::LinkShape& shape,
                   const robot::Vector3& position, const robot::Quaternion& orientation,
                   MjcfText& text);

// Mass and inertia of the body, in its own frame. Throws UserError with its name where no body has
// that inertia.
void AppendInertia(const std::string& name, dBodyID body, MjcfText& text);

// That two geoms touch each other, with this coefficient of friction.
void AppendPair(const std::string& first, const std::string& second, double friction,
                MjcfText& text);

}  // namespace runtime
