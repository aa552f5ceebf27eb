#include "runtime/training/simulation/convex_ground.h"

#include <algorithm>
#include <limits>

namespace runtime {
namespace {

struct Plane {
  explicit Plane(dGeomID plane) {
    dVector4 params;
    dGeomPlaneGetParams(plane, params);
    normal = ToEigen(params);
    offset = params[3];
  }
  double Depth(const Vector3& place) const { return offset - normal.dot(place); }

  Vector3 normal;
  double offset;
};

Vector3 InWorld(dGeomID geom, const Vector3& corner) {
  dVector3 place;
  dGeomGetRelPointPos(geom, corner.x(), corner.y(), corner.z(), place);
  return ToEigen(place);
}

double DistanceFrom(std::span<const dContactGeom> contacts, const Vector3& place) {
  double least = std::numeric_limits<double>::infinity();
  for (const dContactGeom& contact : contacts)
    least = std::min(least, (ToEigen(contact.pos) - place).squaredNorm());
  return least;
}

dContactGeom ContactAt(const Vector3& place, const Plane& plane, dGeomID convex, dGeomID ground) {
  dContactGeom contact{};
  std::copy_n(place.data(), 3, contact.pos);
  std::copy_n(plane.normal.data(), 3, contact.normal);
  contact.depth = plane.Depth(place);
  contact.g1 = convex;
  contact.g2 = ground;
  contact.side1 = contact.side2 = -1;
  return contact;
}

}  // namespace

int CornersBelow(dGeomID plane, dGeomID convex, std::span<const Vector3> corners,
                 std::span<dContactGeom> found) {
  const Plane ground(plane);
  size_t count = 0;
  while (count < found.size()) {
    double best = 0;
    Vector3 chosen = Vector3::Zero();
    for (const Vector3& corner : corners) {
      const Vector3 place = InWorld(convex, corner);
      const double depth = ground.Depth(place);
      if (depth <= 0) continue;
      const double worth = count == 0 ? depth : DistanceFrom(found.first(count), place);
      if (worth > best) {
        best = worth;
        chosen = place;
      }
    }
    if (best == 0) break;
    found[count++] = ContactAt(chosen, ground, convex, plane);
  }
  return static_cast<int>(count);
}

}  // namespace runtime
