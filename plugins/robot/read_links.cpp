#include <utility>

#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

constexpr size_t kMostLinks = 250;

// Whether  root' M root > least  for all directions.
bool IsAbove(double least, const Inertia& m) {
  const double xx = m.xx - least, yy = m.yy - least, zz = m.zz - least;
  return xx > 0 && xx * yy - m.xy * m.xy > 0 &&
         xx * (yy * zz - m.yz * m.yz) - m.xy * (m.xy * zz - m.yz * m.xz) +
                 m.xz * (m.xy * m.yz - yy * m.xz) >
             0;
}

// A body's moments of inertia are positive, and no principal one exceeds the other two together:
// the integrals of x^2, y^2, z^2 and of their products are a matrix like that as well.
bool IsOfABody(const Inertia& m) {
  const double half = (m.xx + m.yy + m.zz) / 2;
  constexpr double kRounding = 1e-6;  // of what other programs have written; a disk has no height
  const Inertia second = {half - m.xx, half - m.yy, half - m.zz, -m.xy, -m.xz, -m.yz};
  return IsAbove(0, m) && IsAbove(-kRounding * half, second);
}

Inertia ReadInertia(const TomlValue& value) {
  const bool is_full = value.Items().size() != 3;
  std::vector<double> numbers = value.Numbers(is_full ? 6 : 3);
  numbers.resize(6, 0);
  const Inertia inertia = {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]};
  if (!IsOfABody(inertia)) {
    value.Fail(value.what() + " is that of no body",
               "moments of inertia are positive, and none exceeds the other two together: write "
               "[xx, yy, zz] or [xx, yy, zz, xy, xz, yz] in kg m^2");
  }
  return inertia;
}

Link ReadLink(const TomlValue& named, std::string name) {
  Link link;
  link.name = std::move(name);
  link.position = named.At("position").ToVector3();
  link.shape = ReadShape(named, link.position);
  link.mass = named.At("mass").PositiveNumber();
  if (const auto friction = named.Find("friction")) link.friction = friction->NumberNotBelowZero();
  if (const auto inertia = named.Find("inertia")) link.inertia = ReadInertia(*inertia);
  if (!link.inertia && link.shape.kind == ShapeKind::kConvex) {
    named.Fail(fmt::format("{} is convex, and its inertia is missing", named.what()),
               "add `inertia`, about the center of mass; `trainer robot hull` computes it");
  }
  if (!link.inertia && link.shape.position != Vector3{}) {
    named.At("shape_position")
        .Fail(fmt::format("the shape of {} is not around its center of mass, so that its inertia "
                          "is not known",
                          named.what()),
              "add `inertia`, about the center of mass");
  }
  return link;
}

}  // namespace

std::vector<Link> ReadLinks(const TomlValue& root) {
  std::vector<Link> links;
  const TomlValue list = root.At("links");
  const std::vector<TomlValue> items = list.Items();
  if (items.size() > kMostLinks) {
    list.Fail(fmt::format("the robot has {} links, and {} is the most", items.size(), kMostLinks),
              "make one link of what does not move against each other");
  }
  for (const TomlValue& value : items) {
    const TomlValue name = value.At("name");
    const std::string text = name.Name();
    CheckIsNew(name, text, "link", links);
    const TomlValue named = value.Called(fmt::format("link `{}`", text));
    links.push_back(ReadLink(named, text));
    if (links.size() == 1 && links.front().position != Vector3{}) {
      named.At("position")
          .Fail(fmt::format("the base link `{}` is not at the origin", text),
                "give all positions relative to the center of the first link");
    }
  }
  if (links.empty()) list.Fail("the robot has no link", "describe at least its base");
  return links;
}

std::vector<std::array<int, 2>> ReadContactExclusions(const TomlValue& root,
                                                      const RobotDescription& robot) {
  std::vector<std::array<int, 2>> pairs;
  const auto list = root.Find("contact_exclusions");
  if (!list) return pairs;
  const std::vector<std::string> links = NamesOf(robot.links);
  for (const TomlValue& pair : list->Items()) {
    const std::vector<TomlValue> names = pair.Items();
    if (names.size() != 2) {
      pair.Fail(pair.what() + " is not a pair of links", "write [\"LINK\", \"LINK\"]");
    }
    pairs.push_back({names[0].IndexIn(links, "link"), names[1].IndexIn(links, "link")});
  }
  return pairs;
}

}  // namespace robot
