#include "runtime/training/simulation/link_overlap.h"

#include <algorithm>
#include <vector>

namespace runtime {
namespace {

constexpr double kRounding = 1e-6;  // of a depth, when the whole robot is moved [m]

// Of each pair of links that overlap, the deepest point.
std::vector<LinkOverlap> OverlapsIn(const World& world) {
  const auto is_link = [&](int body) { return 0 <= body && body < world.body().link_count(); };
  std::vector<LinkOverlap> overlaps;
  for (const Contact& contact : world.collision().contacts()) {
    if (!is_link(contact.first) || !is_link(contact.second)) continue;
    const int first = std::min(contact.first, contact.second);
    const int second = std::max(contact.first, contact.second);
    const auto same = std::ranges::find_if(overlaps, [&](const LinkOverlap& overlap) {
      return overlap.first == first && overlap.second == second;
    });
    if (same == overlaps.end()) {
      overlaps.push_back({first, second, contact.geometry.depth});
    } else {
      same->depth = std::max(same->depth, contact.geometry.depth);
    }
  }
  return overlaps;
}

double DepthOf(const LinkOverlap& pair, const std::vector<LinkOverlap>& overlaps) {
  for (const LinkOverlap& overlap : overlaps) {
    if (overlap.first == pair.first && overlap.second == pair.second) return overlap.depth;
  }
  return 0;
}

}  // namespace

std::optional<LinkOverlap> FindOverlap(const robot::RobotDescription& robot, const Profile& profile,
                                       const robot::StartState& start, const World& world) {
  const std::vector<LinkOverlap> overlaps = OverlapsIn(world);
  if (overlaps.empty()) return std::nullopt;
  const World pose(robot, profile, start.from);
  const std::vector<LinkOverlap> usual = OverlapsIn(pose);
  std::optional<LinkOverlap> deepest;
  for (const LinkOverlap& overlap : overlaps) {
    const bool is_usual = overlap.depth <= DepthOf(overlap, usual) + kRounding;
    if (!is_usual && (!deepest || overlap.depth > deepest->depth)) deepest = overlap;
  }
  return deepest;
}

}  // namespace runtime
