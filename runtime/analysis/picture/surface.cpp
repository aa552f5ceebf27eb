#include "runtime/analysis/picture/surface.h"

#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

using Eigen::Vector3d;

// As --left, --right, --trunk, --plate and --thing of the pages (web/src/style/theme.css).
constexpr uint32_t kLeft = 0x3b82c8, kRight = 0xe8832e, kTrunk = 0xaeb6bd, kPlate = 0x2a3138,
                   kThing = 0xc9a227;
constexpr double kJointDarkness = 0.55;

constexpr double kLamp = 0.66, kFill = 0.1, kSky = 0.62, kBounce = 0.3;  // strengths
constexpr double kGloss = 0.16;

// Whether `word` stands in `name` between underscores or ends.
bool HasWord(std::string_view name, std::string_view word) {
  const size_t at = name.find(word);
  if (at == std::string_view::npos) return false;
  const size_t end = at + word.size();
  return (at == 0 || name[at - 1] == '_') && (end == name.size() || name[end] == '_');
}

bool IsOnPlate(const robot::LinkShape& box, const Vector3d& place) {
  const Vector3d size(box.size.data());
  if (place.x() < 0.499 * size.x()) return false;
  // A rectangle with round corners, somewhat above the middle.
  const double half_width = 0.31 * size.y(), half_height = 0.17 * size.z();
  const double radius = 0.4 * std::min(half_width, half_height);
  const double y = std::max(0., std::abs(place.y()) - half_width + radius);
  const double z = std::max(0., std::abs(place.z() - 0.16 * size.z()) - half_height + radius);
  return y * y + z * z < radius * radius;
}

}  // namespace

Side SideOf(std::string_view link) {
  if (HasWord(link, "left")) return Side::kLeft;
  if (HasWord(link, "right")) return Side::kRight;
  return Side::kTrunk;
}

std::vector<Paint> PaintsOf(const std::vector<robot::Link>& links, size_t things) {
  std::vector<Paint> paints;
  for (size_t i = 0; i < links.size(); ++i) {
    if (i + things >= links.size()) {
      paints.push_back({LightOf(kThing), false});
      continue;
    }
    const bool is_box = links[i].shape.kind == robot::ShapeKind::kBox && !links[i].shape.IsMoved();
    const bool is_ball = links[i].shape.kind == robot::ShapeKind::kSphere;
    const Side side = SideOf(links[i].name);
    if (side == Side::kTrunk) {
      paints.push_back({LightOf(kTrunk), is_box && (i == 0 || links[i].name == "head")});
    } else {
      const Light light = LightOf(side == Side::kLeft ? kLeft : kRight);
      paints.push_back({is_ball ? kJointDarkness * light : light, false});
    }
  }
  return paints;
}

Light ColorAt(const Paint& paint, const robot::LinkShape& shape, const Vector3d& place) {
  return paint.has_plate && IsOnPlate(shape, place) ? LightOf(kPlate) : paint.light;
}

Light Shade(const Light& color, const Vector3d& normal, const Illumination& light) {
  const double upward = 0.5 + 0.5 * normal.z();
  double strength = (kBounce + (kSky - kBounce) * upward) * light.openness +
                    kFill * std::max(0., normal.dot(light.to_fill)) * light.openness;
  Light gloss = Light::Zero();
  if (light.is_lit) {
    strength += kLamp * std::max(0., normal.dot(light.to_lamp));
    const Vector3d halfway = (light.to_lamp + light.to_eye).normalized();
    double shine = std::max(0., normal.dot(halfway));
    for (int i = 0; i < 5; ++i) shine *= shine;  // to the 32nd power
    gloss = Light::Constant(kGloss * shine);
  }
  return strength * color + gloss;
}

}  // namespace runtime
