#include "compiler/bounds/values.h"

#include <algorithm>
#include <utility>

namespace compiler {

Box Join(const Box& a, const Box& b) {
  if (a.size() == 0) return b;
  if (b.size() == 0 || a.IsCopyOf(b)) return a;
  if (a.size() == 1 && b.size() == 1) return Box(Join(a[0], b[0]));
  std::vector<Interval> elements(std::max(a.size(), b.size()));
  for (size_t i = 0; i < elements.size(); ++i) elements[i] = Join(a[i], b[i]);
  return Box(std::move(elements));
}

std::vector<Box> Join(const std::vector<Box>& a, const std::vector<Box>& b) {
  std::vector<Box> boxes(a.size());
  for (size_t i = 0; i < a.size(); ++i) boxes[i] = Join(a[i], b[i]);
  return boxes;
}

Values Join(const Values& a, const Values& b) {
  return {.sensors = Join(a.sensors, b.sensors),
          .params = Join(a.params, b.params),
          .memory = Join(a.memory, b.memory),
          .locals = Join(a.locals, b.locals),
          .arguments = Join(a.arguments, b.arguments),
          .reward = Join(a.reward, b.reward),
          .time_step = Join(a.time_step, b.time_step)};
}

Box MakeBox(std::vector<Interval> elements) {
  Box box(std::move(elements));
  return box.size() > kTrackedElements ? Box(Hull(box)) : box;
}

Interval Hull(const Box& box) {
  Interval hull = kNothing;
  for (const Interval& element : box.elements()) hull = Join(hull, element);
  return hull;
}

}  // namespace compiler
