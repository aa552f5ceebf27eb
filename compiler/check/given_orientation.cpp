#include "compiler/check/given_orientation.h"

#include <array>
#include <cmath>
#include <string_view>

#include "compiler/check/type.h"
#include "plugins/robot/rotation.h"
#include "plugins/robot/sensors.h"

namespace compiler {
namespace {

constexpr std::string_view kOrientation = "base.orientation";

// Sensors made of elements of the rotation matrix, which is row by row.
struct Form {
  std::string_view sensor;
  std::vector<uint32_t> elements;
};
const std::array<Form, 4>& Forms() {
  static const std::array<Form, 4> forms = {{{"base.rotation", {0, 1, 2, 3, 4, 5, 6, 7, 8}},
                                             {"base.forward", {0, 3, 6}},
                                             {"base.left", {1, 4, 7}},
                                             {"base.up", {2, 5, 8}}}};
  return forms;
}

CheckedExpression Literal(const Reals& elements, const Type& type) {
  BuiltinCall call{Builtin::kVector, {}};
  for (const double element : elements)
    call.arguments.push_back(std::make_unique<CheckedExpression>(
        CheckedExpression{{}, kRealType, {}, Constant{element}}));
  return {{}, type, {}, std::move(call)};
}

}  // namespace

std::vector<CheckedGiven> GivenOrientation::Give(uint32_t sensor,
                                                 const std::vector<uint32_t>& elements,
                                                 const Value& value) {
  const std::string& name = sensors_.list()[sensor].name;
  given_.insert(name);
  if (name != kOrientation || !IsOfRobots(sensor)) return {};
  Assign(AssignOperator::kSet, elements, value, orientation_);
  const auto& q = std::get<Reals>(orientation_);
  const auto matrix = robot::RotationMatrix({q[0], q[1], q[2], q[3]});
  if (!std::isfinite(matrix[0])) return {};
  std::vector<CheckedGiven> implied;
  for (const Form& form : Forms()) {
    const auto other = sensors_.Find(form.sensor);
    if (!other || !IsOfRobots(*other) || given_.contains(form.sensor)) continue;
    Reals numbers;
    for (const uint32_t element : form.elements) numbers.push_back(matrix[element]);
    implied.push_back({.target = CheckedGiven::kSensor,
                       .index = *other,
                       .elements = {},
                       .value = Literal(numbers, sensors_.list()[*other].type),
                       .is_implied = true});
  }
  return implied;
}

bool GivenOrientation::IsOfRobots(uint32_t sensor) const {
  const CheckedSensor& checked = sensors_.list()[sensor];
  const robot::SensorDescription* known = robot::FindSensor(checked.name);
  return known != nullptr && known->type == ToString(checked.type);
}

}  // namespace compiler
