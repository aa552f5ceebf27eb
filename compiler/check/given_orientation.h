// What a test that gives `base.orientation` says of the sensors that show the same in other forms.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/sensor_catalog.h"
#include "compiler/check/value.h"

namespace compiler {

// Follows the sensors that one test gives.
class GivenOrientation {
 public:
  // The sensors must outlive it.
  explicit GivenOrientation(const SensorCatalog& sensors) : sensors_(sensors) {}

  // Notes that the test sets `elements` (all, where there are none) of a sensor, and returns what
  // this implies: after an orientation `base.rotation` and its columns, but not those that the test
  // has given itself. A quaternion of length 0 implies nothing.
  std::vector<CheckedGiven> Give(uint32_t sensor, const std::vector<uint32_t>& elements,
                                 const Value& value);

 private:
  // A sensor that has the name and the type of a robot's.
  bool IsOfRobots(uint32_t sensor) const;

  const SensorCatalog& sensors_;
  std::set<std::string, std::less<>> given_;  // their names
  Value orientation_ = Reals{1, 0, 0, 0};
};

}  // namespace compiler
