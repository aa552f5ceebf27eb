#include "runtime/analysis/picture/subject.h"

#include <algorithm>
#include <numeric>

#include "runtime/analysis/picture/shapes.h"

namespace runtime {
namespace {

constexpr double kStill = 1e-4;     // less is no way [m]
constexpr double kStraight = 1e-3;  // less is no turn: of the elements of a quaternion
constexpr int kMostFramesRead = 200;

template <class IsOther>
bool AnyFrame(const Motion& motion, IsOther is_other) {
  const int step = 1 + motion.frame_count() / kMostFramesRead;
  for (int frame = step; frame < motion.frame_count(); frame += step) {
    if (is_other(frame)) return true;
  }
  return is_other(motion.frame_count() - 1);
}

bool Moves(const Motion& motion, int link) {
  return AnyFrame(motion, [&](int frame) {
    return (motion.position(frame, link) - motion.position(0, link)).norm() > kStill;
  });
}

bool Turns(const Motion& motion, int link) {
  return AnyFrame(motion, [&](int frame) {
    const auto& now = motion.orientation(frame, link).coeffs();
    return (now - motion.orientation(0, link).coeffs()).cwiseAbs().maxCoeff() > kStraight;
  });
}

bool Touch(const Motion& motion, const std::vector<robot::Link>& links, int a, int b) {
  const double reach = BoundingRadiusOfLink(links[static_cast<size_t>(a)].shape) +
                       BoundingRadiusOfLink(links[static_cast<size_t>(b)].shape);
  return (motion.position(0, a) - motion.position(0, b)).norm() <= reach;
}

}  // namespace

std::vector<int> SubjectOf(const Motion& motion, const std::vector<robot::Link>& links) {
  std::vector<int> all(links.size());
  std::iota(all.begin(), all.end(), 0);
  if (Moves(motion, 0) || Turns(motion, 0)) return all;
  std::vector<int> subject;
  std::ranges::copy_if(all, std::back_inserter(subject),
                       [&](int link) { return Turns(motion, link); });
  if (subject.empty()) return all;
  for (size_t next = 0; next < subject.size(); ++next) {
    for (const int link : all) {
      const bool is_in = std::ranges::find(subject, link) != subject.end();
      if (!is_in && Touch(motion, links, subject[next], link)) subject.push_back(link);
    }
  }
  std::ranges::sort(subject);
  return subject;
}

}  // namespace runtime
