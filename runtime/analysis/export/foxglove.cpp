#include "runtime/analysis/export/foxglove.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "runtime/core/shape/convex_hull.h"

namespace runtime {
namespace {

using nlohmann::json;

const json kColor = {{"r", 0.8}, {"g", 0.82}, {"b", 0.86}, {"a", 1}};

json Point(const Eigen::Vector3d& p) { return {{"x", p.x()}, {"y", p.y()}, {"z", p.z()}}; }

json Rotation(const Eigen::Quaterniond& q) {
  return {{"x", q.x()}, {"y", q.y()}, {"z", q.z()}, {"w", q.w()}};
}

json Time(double seconds) {
  const auto nanoseconds = std::llround(1e9 * seconds);
  return {{"sec", nanoseconds / 1'000'000'000}, {"nsec", nanoseconds % 1'000'000'000}};
}

json Primitive(const Eigen::Vector3d& size, const Eigen::Vector3d& position,
               const Eigen::Quaterniond& orientation = Eigen::Quaterniond::Identity()) {
  return {{"pose", {{"position", Point(position)}, {"orientation", Rotation(orientation)}}},
          {"size", Point(size)},
          {"color", kColor}};
}

Eigen::Vector3d PositionOf(const robot::LinkShape& shape) {
  return Eigen::Vector3d(shape.position.data());
}

Eigen::Quaterniond OrientationOf(const robot::LinkShape& shape) {
  const auto& [w, x, y, z] = shape.orientation;
  return {w, x, y, z};
}

json Sphere(double radius, const Eigen::Vector3d& position) {
  return Primitive(Eigen::Vector3d::Constant(2 * radius), position);
}

// A cylinder's own axis is z.
void AddCylinder(const robot::LinkShape& shape, double length, json& entity) {
  const Eigen::Quaterniond along = Eigen::Quaterniond::FromTwoVectors(
      Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Unit(shape.axis));
  json cylinder = Primitive({2 * shape.radius, 2 * shape.radius, length}, PositionOf(shape),
                            OrientationOf(shape) * along);
  cylinder["bottom_scale"] = 1;
  cylinder["top_scale"] = 1;
  entity["cylinders"].push_back(cylinder);
}

void AddCapsule(const robot::LinkShape& shape, json& entity) {
  const double length = shape.length - 2 * shape.radius;
  const Eigen::Vector3d end =
      0.5 * length * (OrientationOf(shape) * Eigen::Vector3d::Unit(shape.axis));
  AddCylinder(shape, length, entity);
  entity["spheres"].push_back(Sphere(shape.radius, PositionOf(shape) + end));
  entity["spheres"].push_back(Sphere(shape.radius, PositionOf(shape) - end));
}

// A list of triangles, each corner for itself.
void AddConvex(const robot::LinkShape& shape, json& entity) {
  const ConvexHull hull = HullOf(shape.points);
  json points = json::array();
  for (const HullFace& face : hull.faces) {
    for (const int corner : face.corners)
      points.push_back(Point(hull.corners[static_cast<size_t>(corner)]));
  }
  entity["triangles"].push_back(
      {{"pose",
        {{"position", Point(PositionOf(shape))}, {"orientation", Rotation(OrientationOf(shape))}}},
       {"points", points},
       {"color", kColor},
       {"colors", json::array()},
       {"indices", json::array()}});
}

void AddShape(const robot::LinkShape& shape, json& entity) {
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      entity["cubes"].push_back(Primitive({shape.size[0], shape.size[1], shape.size[2]},
                                          PositionOf(shape), OrientationOf(shape)));
      return;
    case robot::ShapeKind::kCapsule:
      AddCapsule(shape, entity);
      return;
    case robot::ShapeKind::kCylinder:
      AddCylinder(shape, shape.length, entity);
      return;
    case robot::ShapeKind::kSphere:
      entity["spheres"].push_back(Sphere(shape.radius, PositionOf(shape)));
      return;
    case robot::ShapeKind::kConvex:
      AddConvex(shape, entity);
      return;
  }
}

json EntityOf(const robot::Link& link) {
  json entity = {{"timestamp", Time(0)}, {"frame_id", link.name},
                 {"id", link.name},      {"lifetime", Time(0)},  // for good
                 {"frame_locked", true}, {"metadata", json::array()}};
  for (const char* kind :
       {"arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"})
    entity[kind] = json::array();
  AddShape(link.shape, entity);
  return entity;
}

}  // namespace

const char* const kSceneUpdateSchema =
    R"({"type":"object","properties":{"deletions":{"type":"array","items":{"type":"object"}},)"
    R"("entities":{"type":"array","items":{"type":"object"}}}})";
const char* const kTransformsSchema =
    R"({"type":"object","properties":{"transforms":{"type":"array","items":{"type":"object",)"
    R"("properties":{"timestamp":{"type":"object"},"parent_frame_id":{"type":"string"},)"
    R"("child_frame_id":{"type":"string"},"translation":{"type":"object"},)"
    R"("rotation":{"type":"object"}}}}}})";

json SceneUpdate(const std::vector<robot::Link>& links) {
  json entities = json::array();
  for (const robot::Link& link : links) entities.push_back(EntityOf(link));
  return {{"deletions", json::array()}, {"entities", entities}};
}

json FrameTransforms(const Motion& motion, int frame, const std::vector<robot::Link>& links) {
  json transforms = json::array();
  for (int link = 0; link < motion.link_count; ++link) {
    transforms.push_back({{"timestamp", Time(frame * motion.frame_interval)},
                          {"parent_frame_id", "world"},
                          {"child_frame_id", links[static_cast<size_t>(link)].name},
                          {"translation", Point(motion.position(frame, link))},
                          {"rotation", Rotation(motion.orientation(frame, link))}});
  }
  return {{"transforms", transforms}};
}

}  // namespace runtime
