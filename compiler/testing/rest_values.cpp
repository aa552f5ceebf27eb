#include "compiler/testing/rest_values.h"

#include <string_view>

namespace compiler {
namespace {

struct Upright {
  std::string_view sensor;
  Reals value;
};

const std::vector<Upright>& BaseUpright() {
  static const std::vector<Upright> upright = {
      {"base.orientation", {1, 0, 0, 0}},
      {"base.rotation", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
      {"base.forward", {1, 0, 0}},
      {"base.left", {0, 1, 0}},
      {"base.up", {0, 0, 1}},
  };
  return upright;
}

}  // namespace

Value RestValue(const CheckedSensor& sensor) {
  const bool is_real = sensor.type.scalar == Scalar::kReal;
  for (const Upright& upright : BaseUpright()) {
    const bool has_its_shape = is_real && sensor.type.size() == upright.value.size();
    if (sensor.name == upright.sensor && has_its_shape) return upright.value;
  }
  return Filled(sensor.type.scalar, sensor.type.size(), 0);
}

double RestTimeStep(EventKind event) {
  switch (event) {
    case EventKind::kStartOfTimeStep:
    case EventKind::kEndOfTimeStep:
      return 0.005;
    case EventKind::kStartOfPhysicsStep:
    case EventKind::kEndOfPhysicsStep:
      return 0.0002;
    default:
      return 0;
  }
}

}  // namespace compiler
