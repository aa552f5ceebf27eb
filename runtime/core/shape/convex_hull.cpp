#include "runtime/core/shape/convex_hull.h"

#include <libqhull_r/qhull_ra.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <memory>
#include <utility>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Qhull's memory, as long as a hull is read from it.
class Qhull {
 public:
  explicit Qhull(const std::vector<robot::Vector3>& points)
      : out_(std::fopen("/dev/null", "w")), coordinates_(points) {
    QHULL_LIB_CHECK
    qh_zero(&qh_, out_.get());
    // Triangles; nothing is moved to make it simpler.
    std::string command = "qhull Qt";
    failed_ = qh_new_qhull(&qh_, 3, static_cast<int>(points.size()), coordinates_.front().data(),
                           False, command.data(), nullptr, out_.get()) != 0;
  }
  ~Qhull() {
    qh_freeqhull(&qh_, qh_ALL);
    int current = 0;
    int total = 0;
    qh_memfreeshort(&qh_, &current, &total);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  bool failed() const { return failed_; }
  qhT* get() { return &qh_; }
  const robot::Vector3& coordinates(int point) const {
    return coordinates_[static_cast<size_t>(point)];
  }

 private:
  struct Close {
    void operator()(FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<FILE, Close> out_;
  std::vector<robot::Vector3> coordinates_;
  qhT qh_;
  bool failed_ = false;
};

// A triangle may be so thin that its corners do not tell its plane; Qhull knows it from its
// neighbors in the same plane.
HullFace FaceOf(const std::vector<Vector3d>& corners, std::array<int, 3> indices,
                const facetT& facet) {
  const auto corner = [&](size_t i) -> const Vector3d& {
    return corners[static_cast<size_t>(indices[i])];
  };
  const Vector3d normal = Vector3d(facet.normal);
  const Vector3d turn = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  if (turn.dot(normal) < 0) std::swap(indices[1], indices[2]);
  return {indices, normal, -facet.offset};
}

}  // namespace

ConvexHull HullOf(const std::vector<robot::Vector3>& points) {
  const UserError not_solid("the points of a convex shape enclose no space");
  if (!robot::IsSolid(points)) throw not_solid;
  Qhull qhull(points);
  if (qhull.failed()) throw not_solid;
  qhT* qh = qhull.get();
  ConvexHull hull;
  std::vector<int> numbers(points.size(), -1);  // of each point among the corners
  const auto number = [&](const vertexT* vertex) {
    const int point = qh_pointid(qh, vertex->point);
    int& index = numbers[static_cast<size_t>(point)];
    if (index < 0) {
      index = static_cast<int>(hull.corners.size());
      hull.corners.push_back(Vector3d(qhull.coordinates(point).data()));
    }
    return index;
  };
  facetT* facet = nullptr;
  FORALLfacets {
    std::array<int, 3> indices{};
    for (int i = 0; i < 3; ++i)
      indices[static_cast<size_t>(i)] = number(SETelemt_(facet->vertices, i, vertexT));
    hull.faces.push_back(FaceOf(hull.corners, indices, *facet));
  }
  return hull;
}

HullMass MassOf(const ConvexHull& hull) {
  const Vector3d& inside = hull.corners.front();
  double volume = 0;
  Vector3d first = Vector3d::Zero();   // integral of x over the volume
  Matrix3d second = Matrix3d::Zero();  // of x x'
  for (const HullFace& face : hull.faces) {
    std::array<Vector3d, 3> to;
    for (size_t i = 0; i < 3; ++i)
      to[i] = hull.corners[static_cast<size_t>(face.corners[i])] - inside;
    const Vector3d sum = to[0] + to[1] + to[2];
    const double part = to[0].dot(to[1].cross(to[2])) / 6;
    volume += part;
    first += part / 4 * sum;
    second += part / 20 * sum * sum.transpose();
    for (const Vector3d& each : to) second += part / 20 * each * each.transpose();
  }
  const Vector3d center = first / volume;
  const Matrix3d spread = second / volume - center * center.transpose();
  return {volume, inside + center, spread.trace() * Matrix3d::Identity() - spread};
}

}  // namespace runtime
