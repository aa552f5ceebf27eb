#include "runtime/analysis/picture/strokes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace runtime {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kThinnest = 1;  // a line is no fainter than this [px]

// In pixels from the picture's upper left corner.
std::optional<Vector2d> PixelOf(const Camera& camera, const Vector3d& place, int size) {
  const Vector3d to = place - camera.position;
  const double depth = to.dot(camera.forward);
  if (!(depth > 0)) return std::nullopt;
  const double scale = 0.5 / (Camera::kHalfWidth * depth);
  return size * Vector2d(0.5 + scale * to.dot(camera.right), 0.5 - scale * to.dot(camera.up));
}

double DistanceTo(const Vector2d& from, const Vector2d& to, const Vector2d& point) {
  const Vector2d along = to - from;
  const double squared = along.squaredNorm();
  const double part = squared > 0 ? std::clamp((point - from).dot(along) / squared, 0., 1.) : 0.;
  return (point - from - part * along).norm();
}

// The pixels, of `size`, that a line between two coordinates may cover.
struct PixelRange {
  int first, last;

  PixelRange(double a, double b, double reach, int size)
      : first(static_cast<int>(std::clamp(std::min(a, b) - reach, 0., 1. * size))),
        last(static_cast<int>(std::clamp(std::max(a, b) + reach + 1, 0., 1. * size))) {}
};

}  // namespace

StrokeLayer::StrokeLayer(const Camera& camera, std::span<const Stroke> strokes, int size)
    : size_(size) {
  if (strokes.empty()) return;
  pixels_.resize(static_cast<size_t>(size) * static_cast<size_t>(size));
  for (const Stroke& stroke : strokes) {
    const std::optional<Vector2d> from = PixelOf(camera, stroke.from, size);
    const std::optional<Vector2d> to = PixelOf(camera, stroke.to, size);
    if (from && to)
      Draw(*from, *to, std::max(kThinnest, stroke.width * size), LightOf(stroke.color));
  }
}

void StrokeLayer::Draw(const Vector2d& from, const Vector2d& to, double width, const Light& light) {
  const double reach = width / 2 + 0.5;  // and half a pixel, in which it fades
  const PixelRange columns(from.x(), to.x(), reach, size_);
  const PixelRange rows(from.y(), to.y(), reach, size_);
  for (int y = rows.first; y < rows.last; ++y) {
    for (int x = columns.first; x < columns.last; ++x) {
      const double distance = DistanceTo(from, to, Vector2d(x + 0.5, y + 0.5));
      const double cover = std::clamp(reach - distance, 0., 1.);
      Layer& pixel = pixels_[static_cast<size_t>(y * size_ + x)];
      if (cover > 0) pixel = Layer::Of(light, cover).Over(pixel);
    }
  }
}

}  // namespace runtime
