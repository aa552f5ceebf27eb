#include "runtime/import/body_parts.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "runtime/core/shape/convex_hull.h"
#include "runtime/core/shape/extreme_points.h"

namespace runtime {
namespace {

using Vector = Eigen::Vector3d;
using RowMatrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// What the importer has asked MuJoCo to give in place of no mass, and a little more.
constexpr double kNoMass = 1e-8;  // [kg]

Eigen::Matrix3d OfPoint(double mass, const Vector& arm) {
  return mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
}

// The shape with its volume; nothing for what cannot be part of a link.
std::optional<ShapePart> ShapeOf(int type, const Vector& size) {
  using std::numbers::pi;
  ShapePart part;
  robot::LinkShape& shape = part.shape;
  switch (type) {
    case mjGEOM_SPHERE:
      shape = {.kind = robot::ShapeKind::kSphere, .radius = size[0]};
      part.volume = 4. / 3 * pi * std::pow(size[0], 3);
      return part;
    case mjGEOM_CAPSULE:
      shape = {
          .kind = robot::ShapeKind::kCapsule, .radius = size[0], .length = 2 * (size[0] + size[1])};
      part.volume = pi * size[0] * size[0] * (2 * size[1] + 4. / 3 * size[0]);
      return part;
    case mjGEOM_CYLINDER:
      shape = {.kind = robot::ShapeKind::kCylinder, .radius = size[0], .length = 2 * size[1]};
      part.volume = 2 * pi * size[0] * size[0] * size[1];
      return part;
    case mjGEOM_ELLIPSOID: {
      // The capsule as long as it, and in the middle as thick as it is on average.
      int axis = 0;
      size.maxCoeff(&axis);
      const double radius = (size.sum() - size[axis]) / 2;
      part = *ShapeOf(mjGEOM_CAPSULE, {radius, std::max(size[axis] - radius, 1e-6), 0});
      shape.axis = axis;
      part.approximated = "an ellipsoid, as a capsule";
      return part;
    }
    case mjGEOM_MESH:
      part = *ShapeOf(mjGEOM_BOX, size);
      part.approximated = "a mesh, as the box that has its inertia";
      return part;
    case mjGEOM_BOX:
      shape = {.kind = robot::ShapeKind::kBox, .size = {2 * size[0], 2 * size[1], 2 * size[2]}};
      part.volume = 8 * size.prod();
      return part;
    default:
      return std::nullopt;
  }
}

// The mesh's convex hull, in place of the box.
void TakeMesh(const mjModel& model, int mesh, ShapePart& part) {
  constexpr int kDirections = 64;
  part.mesh = NameIn(model, mjOBJ_MESH, mesh);
  const std::vector<robot::Vector3> points =
      ToArrays(ExtremePoints(VerticesOf(model, mesh), kDirections));
  if (!robot::IsSolid(points)) return;  // the box is what is left of it
  part.shape = {.kind = robot::ShapeKind::kConvex, .points = points};
  part.volume = MassOf(HullOf(points)).volume;
  part.approximated = fmt::format("a mesh, as the convex hull of {} corners", points.size());
}

// Some files have inertias that no body has: none is larger than the other two together, and none
// is nothing. The smallest grows until that holds.
Vector RaisedWhereSmallest(Vector principal) {
  constexpr double kFlat = 1e-3;  // of the largest: thinner than what robots are made of
  int least = 0;
  const double largest = principal.maxCoeff();
  principal.minCoeff(&least);
  const double others = principal.sum() - largest - principal[least];
  principal[least] = std::max({principal[least], (1 + kFlat) * largest - others, kFlat * largest});
  return principal;
}

}  // namespace

bool IsPossible(const mjModel& model, int body) {
  Vector principal(model.body_inertia + 3 * body);
  std::ranges::sort(principal);
  return principal[0] + principal[1] > (1 - 1e-6) * principal[2] &&
         principal[0] > 1e-4 * principal[2];
}

void MassPart::Add(const MassPart& other) {
  const double sum = mass + other.mass;
  if (sum <= 0) return;
  const Vector middle = (mass * center + other.mass * other.center) / sum;
  const double sign = other.mass < 0 ? -1 : 1;
  inertia += OfPoint(mass, center - middle) + sign * other.inertia +
             OfPoint(other.mass, other.center - middle);
  mass = sum;
  center = middle;
}

MassPart MassOf(const mjModel& model, const mjData& data, int body) {
  if (model.body_mass[body] <= kNoMass) return {};
  const Eigen::Matrix3d axes = Eigen::Map<const RowMatrix>(data.ximat + 9 * body);
  Vector principal(model.body_inertia + 3 * body);
  if (!IsPossible(model, body)) principal = RaisedWhereSmallest(principal);
  return {model.body_mass[body], Vector(data.xipos + 3 * body),
          axes * principal.asDiagonal() * axes.transpose()};
}

std::vector<Vector> VerticesOf(const mjModel& model, int mesh) {
  std::vector<Vector> vertices;
  const float* first = model.mesh_vert + 3 * model.mesh_vertadr[mesh];
  for (int i = 0; i < model.mesh_vertnum[mesh]; ++i)
    vertices.push_back(Eigen::Vector3f(first + 3 * i).cast<double>());
  return vertices;
}

std::vector<ShapePart> ShapesOf(const mjModel& model, const mjData& data, int body) {
  std::vector<ShapePart> shapes;
  for (int i = 0; i < model.body_geomnum[body]; ++i) {
    const int geom = model.body_geomadr[body] + i;
    if (model.geom_contype[geom] == 0 && model.geom_conaffinity[geom] == 0) continue;
    auto shape = ShapeOf(model.geom_type[geom], Vector(model.geom_size + 3 * geom));
    if (!shape) continue;
    shape->position = Vector(data.geom_xpos + 3 * geom);
    shape->orientation =
        Eigen::Quaterniond(Eigen::Matrix3d(Eigen::Map<const RowMatrix>(data.geom_xmat + 9 * geom)));
    if (model.geom_type[geom] == mjGEOM_MESH) TakeMesh(model, model.geom_dataid[geom], *shape);
    shape->friction = model.geom_friction[3 * geom];
    shape->contype = model.geom_contype[geom];
    shape->conaffinity = model.geom_conaffinity[geom];
    shapes.push_back(*std::move(shape));
  }
  return shapes;
}

ShapePart BoxOf(const MassPart& part) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(part.inertia);
  const Vector& i = solver.eigenvalues();
  const auto extent = [&](int axis) {
    return std::sqrt(std::max(6 / part.mass * (i.sum() - 2 * i[axis]), 1e-6));
  };
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  ShapePart box = *ShapeOf(mjGEOM_BOX, Vector(extent(0), extent(1), extent(2)) / 2);
  box.position = part.center;
  box.orientation = Eigen::Quaterniond(axes);
  return box;
}

robot::Vector3 ToArray(const Vector& v) { return {v[0], v[1], v[2]}; }

std::vector<robot::Vector3> ToArrays(const std::vector<Vector>& points) {
  std::vector<robot::Vector3> arrays;
  for (const Vector& point : points) arrays.push_back(ToArray(point));
  return arrays;
}

robot::Inertia ToInertia(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

std::string NameIn(const mjModel& model, mjtObj type, int index) {
  const char* name = mj_id2name(&model, type, index);
  return name == nullptr ? "" : name;
}

}  // namespace runtime
