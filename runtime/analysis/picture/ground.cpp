#include "runtime/analysis/picture/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace runtime {
namespace {

constexpr double kFine = 0.1, kCoarse = 0.5;  // between lines [m]
constexpr double kSmoothing = 0.3;            // half the time over which the trail is averaged [s]
constexpr double kDisc = 0.52;                // radius, of what a picture shows
constexpr double kLine = 0.0042;              // width, of what a picture shows
constexpr uint32_t kDiscColor = 0x8b98a5, kLineColor = 0x6d7b88, kTrailColor = 0x4f86c6;
constexpr double kDiscCover = 0.16, kFineCover = 0.22, kCoarseCover = 0.6, kTrailCover = 0.9;

// Mean over the frames around `frame`, fewer toward both ends of the motion, so that the trail
// starts and ends where the link does.
Point SmoothPlace(const Motion& motion, int link, int frame) {
  const int last = motion.frame_count() - 1;
  const int half = std::min({static_cast<int>(std::floor(
                                 std::min(kSmoothing / motion.frame_interval + 0.5, double(last)))),
                             frame, last - frame});
  Point sum = Point::Zero();
  for (int i = frame - half; i <= frame + half; ++i) sum += motion.position(i, link).head<2>();
  return sum / (2 * half + 1);
}

// How much of the stretch of `width` around `place` is covered by lines, `spacing` apart.
double LinesCover(double place, double width, double spacing, double line) {
  if (width >= spacing) return line / spacing;
  const double from_line = place - spacing * std::floor(place / spacing + 0.5);
  const double low = std::max(from_line - width / 2, -line / 2);
  const double high = std::min(from_line + width / 2, line / 2);
  return std::max(0., high - low) / width;
}

double GridCover(const Point& place, const Point& width, double spacing, double line) {
  const double x = LinesCover(place.x(), width.x(), spacing, line);
  const double y = LinesCover(place.y(), width.y(), spacing, line);
  return x + y - x * y;
}

double SquaredDistance(const Point& place, const Point& a, const Point& b) {
  const Point along = b - a;
  const double squared = along.squaredNorm();
  const double part = squared > 0 ? std::clamp((place - a).dot(along) / squared, 0., 1.) : 0;
  return (place - a - part * along).squaredNorm();
}

// 1 within `radius`, 0 outside, and in between over `blur`.
double DiscCover(double distance, double radius, double blur) {
  return std::clamp((radius - distance) / blur + 0.5, 0., 1.);
}

}  // namespace

Trail TrailOf(const Motion& motion, int link, const std::vector<int>& frames, size_t picture) {
  Trail trail;
  for (int frame = 0; frame <= frames[picture]; ++frame) {
    trail.points.push_back(SmoothPlace(motion, link, frame));
  }
  for (size_t i = 0; i <= picture; ++i) {
    trail.marks.push_back(trail.points[static_cast<size_t>(frames[i])]);
  }
  return trail;
}

Ground::Ground(const Camera& camera, const Trail& trail)
    : middle_(camera.target().head<2>()),
      radius_(kDisc * camera.view()),
      line_(kLine * camera.view()) {
  for (const Point& point : trail.points) {
    if ((point - middle_).norm() > 2 * radius_) continue;
    if (trail_.points.empty() || (point - trail_.points.back()).norm() > line_) {
      trail_.points.push_back(point);
    }
  }
  for (const Point& mark : trail.marks) {
    if ((mark - middle_).norm() < radius_) trail_.marks.push_back(mark);
  }
}

double Ground::Presence(const Point& place) const {
  const double part = std::min(1., (place - middle_).squaredNorm() / (radius_ * radius_));
  return (1 - part) * (1 - part);
}

double Ground::TrailCover(const Point& place, double blur) const {
  double from_line = std::numeric_limits<double>::infinity();  // squared, as the next
  double from_mark = from_line;
  for (size_t i = 1; i < trail_.points.size(); ++i) {
    from_line = std::min(from_line, SquaredDistance(place, trail_.points[i - 1], trail_.points[i]));
  }
  for (const Point& mark : trail_.marks) {
    from_mark = std::min(from_mark, (place - mark).squaredNorm());
  }
  return std::max(DiscCover(std::sqrt(from_line), line_, blur),
                  DiscCover(std::sqrt(from_mark), 4 * line_, blur));
}

Layer Ground::Look(const Point& place, const Point& du, const Point& dv) const {
  const double presence = Presence(place);
  if (presence == 0) return {};
  const Point width = du.cwiseAbs() + dv.cwiseAbs();
  const double fine = kFineCover * GridCover(place, width, kFine, line_);
  const double coarse = kCoarseCover * GridCover(place, width, kCoarse, line_);
  const double trail = kTrailCover * TrailCover(place, 0.5 * (width.x() + width.y()));
  return Layer::Of(LightOf(kTrailColor), presence * trail)
      .Over(Layer::Of(LightOf(kLineColor), presence * std::max(fine, coarse)))
      .Over(Layer::Of(LightOf(kDiscColor), presence * kDiscCover));
}

}  // namespace runtime
