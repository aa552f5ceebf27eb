#include "runtime/import/mesh_hull.h"

#include <fmt/format.h>

#include "runtime/base/user_error.h"
#include "runtime/core/shape/convex_hull.h"
#include "runtime/core/shape/extreme_points.h"
#include "runtime/import/body_parts.h"
#include "runtime/import/load_model.h"
#include "runtime/import/robot_toml.h"

namespace runtime {
namespace {

// In the frame of the file; MuJoCo itself has moved them into one of its own.
std::vector<Eigen::Vector3d> VerticesInFile(const mjModel& model) {
  const Eigen::Vector3d place(model.geom_pos);
  const Eigen::Quaterniond turn(model.geom_quat[0], model.geom_quat[1], model.geom_quat[2],
                                model.geom_quat[3]);
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3d& vertex : VerticesOf(model, 0))
    vertices.push_back(place + turn * vertex);
  return vertices;
}

}  // namespace

MeshHull HullOfMesh(const MeshOptions& options) {
  const MujocoModel model = LoadMesh(options.file, options.scale);
  const std::vector<Eigen::Vector3d> vertices = VerticesInFile(*model);
  MeshHull mesh;
  mesh.vertices = static_cast<int>(vertices.size());
  mesh.link.name = options.file.stem().string();
  mesh.link.mass = options.mass;
  robot::LinkShape& shape = mesh.link.shape;
  shape.kind = robot::ShapeKind::kConvex;
  shape.points = ToArrays(ExtremePoints(vertices, options.directions));
  if (!robot::IsSolid(shape.points)) {
    throw UserError(
        fmt::format("{}: the mesh encloses no space; give it a thickness, or make it a "
                    "box",
                    options.file.string()));
  }
  const HullMass mass = MassOf(HullOf(shape.points));
  mesh.volume = mass.volume;
  mesh.link.position = ToArray(mass.center);
  mesh.link.inertia = ToInertia(options.mass * mass.inertia);
  for (robot::Vector3& point : shape.points) {
    for (size_t i = 0; i < 3; ++i) point[i] -= mesh.link.position[i];
  }
  mesh.text = LinkText(mesh.link);
  return mesh;
}

}  // namespace runtime
