// What is known, at one place of a callback, of all that a task can read.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bounds/interval.h"

namespace compiler {

// A value with more elements than this gets one interval for all of them.
inline constexpr uint32_t kTrackedElements = 64;

struct Values {
  std::vector<Box> sensors;
  std::vector<Box> params;
  std::vector<Box> memory;
  std::vector<Box> locals;     // of the event, or of the function
  std::vector<Box> arguments;  // inside a function
  Interval reward = Exactly(0);
  Interval time_step{0, kInfinity};

  bool operator==(const Values&) const = default;
};

// All values of both, element by element. A local that is not known yet has no elements.
Box Join(const Box& a, const Box& b);
std::vector<Box> Join(const std::vector<Box>& a, const std::vector<Box>& b);
Values Join(const Values& a, const Values& b);

// The box of `elements`, or of all of them together where they are too many.
Box MakeBox(std::vector<Interval> elements);
// One interval around all elements.
Interval Hull(const Box& box);

}  // namespace compiler
