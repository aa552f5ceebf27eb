#include "runtime/training/simulation/solid_shape.h"

#include <cstdlib>
#include <numbers>

namespace runtime {
namespace {

// ODE's capsules and cylinders lie along z: the turn that lays one along its axis.
void RotationOfAxis(const robot::LinkShape& shape, dMatrix3 rotation) {
  const bool has_axis =
      shape.kind == robot::ShapeKind::kCapsule || shape.kind == robot::ShapeKind::kCylinder;
  dRSetIdentity(rotation);
  if (has_axis && shape.axis == 0) dRFromAxisAndAngle(rotation, 0, 1, 0, std::numbers::pi / 2);
  if (has_axis && shape.axis == 1) dRFromAxisAndAngle(rotation, 1, 0, 0, std::numbers::pi / 2);
}

}  // namespace

void ToRotation(const robot::Quaternion& quaternion, dMatrix3 rotation) {
  const dQuaternion q = {quaternion[0], quaternion[1], quaternion[2], quaternion[3]};
  dQtoR(q, rotation);
}

dMass MassOfShape(const robot::LinkShape& shape, double total) {
  dMass mass;
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      dMassSetBoxTotal(&mass, total, shape.size[0], shape.size[1], shape.size[2]);
      break;
    case robot::ShapeKind::kCapsule:
      dMassSetCapsuleTotal(&mass, total, shape.axis + 1, shape.radius,
                           shape.length - 2 * shape.radius);
      break;
    case robot::ShapeKind::kCylinder:
      dMassSetCylinderTotal(&mass, total, shape.axis + 1, shape.radius, shape.length);
      break;
    case robot::ShapeKind::kSphere:
      dMassSetSphereTotal(&mass, total, shape.radius);
      break;
    case robot::ShapeKind::kConvex:
      std::abort();  // says its inertia itself
  }
  return mass;
}

OdeGeom GeomOf(const robot::LinkShape& shape) {
  switch (shape.kind) {
    case robot::ShapeKind::kBox:
      return OdeGeom(dCreateBox(nullptr, shape.size[0], shape.size[1], shape.size[2]));
    case robot::ShapeKind::kCapsule:
      return OdeGeom(dCreateCapsule(nullptr, shape.radius, shape.length - 2 * shape.radius));
    case robot::ShapeKind::kCylinder:
      return OdeGeom(dCreateCylinder(nullptr, shape.radius, shape.length));
    case robot::ShapeKind::kSphere:
      return OdeGeom(dCreateSphere(nullptr, shape.radius));
    case robot::ShapeKind::kConvex:
      break;
  }
  std::abort();
}

ConvexGeom::ConvexGeom(const std::vector<robot::Vector3>& points) : hull_(HullOf(points)) {
  for (const HullFace& face : hull_.faces) {
    planes_.insert(planes_.end(),
                   {face.normal.x(), face.normal.y(), face.normal.z(), face.distance});
    polygons_.push_back(3);
    for (const int corner : face.corners) polygons_.push_back(static_cast<unsigned>(corner));
  }
}

OdeGeom ConvexGeom::Make() const {
  return OdeGeom(dCreateConvex(nullptr, planes_.data(), static_cast<unsigned>(hull_.faces.size()),
                               hull_.corners.front().data(),
                               static_cast<unsigned>(hull_.corners.size()), polygons_.data()));
}

void PlaceShape(const robot::LinkShape& shape, dGeomID geom) {
  dMatrix3 along;
  RotationOfAxis(shape, along);
  const bool is_along_z = along[0] == 1 && along[5] == 1;
  if (is_along_z && !shape.IsMoved()) return;
  if (!shape.IsMoved()) return dGeomSetOffsetRotation(geom, along);
  dMatrix3 turn;
  dMatrix3 rotation;
  ToRotation(shape.orientation, turn);
  dMultiply0(rotation, turn, along, 3, 3, 3);
  dGeomSetOffsetPosition(geom, shape.position[0], shape.position[1], shape.position[2]);
  dGeomSetOffsetRotation(geom, rotation);
}

void FixShape(const robot::LinkShape& shape, const robot::Vector3& position,
              const robot::Quaternion& orientation, dGeomID geom) {
  dMatrix3 along;
  dMatrix3 turn;
  dMatrix3 rotation;
  RotationOfAxis(shape, along);
  ToRotation(orientation, turn);
  dMultiply0(rotation, turn, along, 3, 3, 3);
  dGeomSetPosition(geom, position[0], position[1], position[2]);
  dGeomSetRotation(geom, rotation);
}

}  // namespace runtime
