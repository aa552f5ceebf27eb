#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

// The keys of a link that belong to its shape depend on the shape's kind.
LinkShape ReadShape(const TomlValue& link) {
  LinkShape shape;
  switch (link.At("shape").IndexIn({"box", "capsule", "sphere"}, "shape")) {
    case 0: {
      link.AllowKeys(KeysOf("box"));
      shape.kind = ShapeKind::kBox;
      const TomlValue size = link.At("size");
      shape.size = size.ToVector3();
      for (const TomlValue& extent : size.Items()) extent.PositiveNumber();
      break;
    }
    case 1: {
      link.AllowKeys(KeysOf("capsule"));
      shape.kind = ShapeKind::kCapsule;
      shape.axis = link.At("axis").IndexIn({"x", "y", "z"}, "axis");
      shape.radius = link.At("radius").PositiveNumber();
      const TomlValue length = link.At("length");
      shape.length = length.Number();
      if (shape.length <= 2 * shape.radius) {
        length.Fail(length.what() + " does not exceed its two caps",
                    "give the total length, more than twice the radius, or make it a sphere");
      }
      break;
    }
    default:
      link.AllowKeys(KeysOf("sphere"));
      shape.kind = ShapeKind::kSphere;
      shape.radius = link.At("radius").PositiveNumber();
  }
  return shape;
}

}  // namespace

std::vector<Link> ReadLinks(const TomlValue& root) {
  std::vector<Link> links;
  const TomlValue list = root.At("links");
  for (const TomlValue& value : list.Items()) {
    Link link;
    const TomlValue name = value.At("name");
    link.name = name.Name();
    CheckIsNew(name, link.name, "link", links);
    const TomlValue named = value.Called(fmt::format("link `{}`", link.name));
    link.shape = ReadShape(named);
    link.mass = named.At("mass").PositiveNumber();
    const TomlValue position = named.At("position");
    link.position = position.ToVector3();
    if (links.empty() && link.position != Vector3{}) {
      position.Fail(fmt::format("the base link `{}` is not at the origin", link.name),
                    "give all positions relative to the center of the first link");
    }
    links.push_back(std::move(link));
  }
  if (links.empty()) list.Fail("the robot has no link", "describe at least its base");
  return links;
}

}  // namespace robot
