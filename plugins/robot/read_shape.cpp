#include "plugins/robot/kind_names.h"
#include "plugins/robot/read_parts.h"

namespace robot {
namespace {

// Each reads what is special in one kind of shape.

void ReadBox(const TomlValue& link, LinkShape& shape) {
  const TomlValue size = link.At("size");
  shape.size = size.ToVector3();
  for (const TomlValue& extent : size.Items()) extent.PositiveNumber();
}

void ReadCylinder(const TomlValue& link, LinkShape& shape) {
  shape.axis = link.At("axis").IndexIn({"x", "y", "z"}, "axis");
  shape.radius = link.At("radius").PositiveNumber();
  shape.length = link.At("length").PositiveNumber();
}

void ReadCapsule(const TomlValue& link, LinkShape& shape) {
  shape.axis = link.At("axis").IndexIn({"x", "y", "z"}, "axis");
  shape.radius = link.At("radius").PositiveNumber();
  const TomlValue length = link.At("length");
  shape.length = length.Number();
  if (shape.length <= 2 * shape.radius) {
    length.Fail(length.what() + " does not exceed its two caps",
                "give the total length, more than twice the radius, or make it a sphere");
  }
}

void ReadSphere(const TomlValue& link, LinkShape& shape) {
  shape.radius = link.At("radius").PositiveNumber();
}

void ReadConvex(const TomlValue& link, LinkShape& shape) {
  constexpr size_t kMostPoints = 1000;
  const TomlValue points = link.At("points");
  for (const TomlValue& point : points.Items()) shape.points.push_back(point.ToVector3());
  if (shape.points.size() > kMostPoints) {
    points.Fail(fmt::format("{} are {}, and {} is the most", points.what(), shape.points.size(),
                            kMostPoints),
                "leave out what is not a corner: `trainer robot hull` does");
  }
  if (!IsSolid(shape.points)) {
    points.Fail(points.what() + " enclose no space",
                "give the corners of a body, at least four that do not lie in one plane");
  }
}

}  // namespace

ShapeKind ReadShapeKind(const TomlValue& part, std::span<const ShapeKind> kinds) {
  std::vector<std::string> names;
  for (const ShapeKind kind : kinds) names.emplace_back(NameOf(kind));
  return kinds[static_cast<size_t>(part.At("shape").IndexIn(names, "shape"))];
}

void ReadSize(const TomlValue& part, LinkShape& shape) {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return ReadBox(part, shape);
    case ShapeKind::kCapsule:
      return ReadCapsule(part, shape);
    case ShapeKind::kCylinder:
      return ReadCylinder(part, shape);
    case ShapeKind::kSphere:
      return ReadSphere(part, shape);
    case ShapeKind::kConvex:
      return ReadConvex(part, shape);
  }
}

LinkShape ReadShape(const TomlValue& link, const Vector3& center) {
  LinkShape shape;
  shape.kind = ReadShapeKind(link, kShapeKinds);
  link.AllowKeys(KeysOf(NameOf(shape.kind)));
  ReadSize(link, shape);
  if (const auto position = link.Find("shape_position")) {
    shape.position = position->ToVector3();
    for (int i = 0; i < 3; ++i) shape.position[i] -= center[i];
  }
  if (const auto orientation = link.Find("shape_orientation")) {
    shape.orientation = ReadOrientation(*orientation);
  }
  return shape;
}

}  // namespace robot
