#include "runtime/analysis/picture/render.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace runtime {
namespace {

using Eigen::Vector3d;

constexpr int kGrid = 3;  // samples of a pixel in each direction
constexpr int kSamples = kGrid * kGrid;

// Where the lamp is, seen from the robot: to the left of the camera, in front and above.
constexpr double kLampLeft = 0.75, kLampFront = 0.62, kLampAbove = 1.6;
constexpr double kLampRadius = 0.075;  // as seen from there, in radians: softens shadows
constexpr int kParts = 4 * kSamples;   // of the lamp, each seen or not
constexpr uint32_t kShadowColor = 0x10161c;
constexpr double kShadowCover = 0.3, kContactCover = 0.5, kSlopeCover = 0.35;

// The directions to the parts of a lamp, evenly over its disc, from the middle outwards: each a
// golden angle from the one before.
std::array<Vector3d, kParts> PartsOfLamp(const Vector3d& lamp) {
  constexpr double kCosine = -0.7373688780783197, kSine = 0.6754902942615238;
  const Vector3d a = lamp.cross(Vector3d::UnitZ()).normalized();
  const Vector3d b = lamp.cross(a);
  std::array<Vector3d, kParts> parts;
  double u = 1, v = 0;
  for (int i = 0; i < kParts; ++i) {
    const double radius = kLampRadius * std::sqrt((i + 0.5) / kParts);
    parts[static_cast<size_t>(i)] = (lamp + radius * (u * a + v * b)).normalized();
    const double turned = kCosine * u - kSine * v;
    v = kSine * u + kCosine * v;
    u = turned;
  }
  return parts;
}

// From the middle of a pixel to its sample `i`, in pixels.
Eigen::Vector2d SampleOffset(int i) {
  const int column = i % kGrid;
  const int row = i / kGrid;
  return {(column + 0.5) / kGrid - 0.5, (row + 0.5) / kGrid - 0.5};
}

// The part of the floor in a pixel: a parallelogram.
struct FloorPatch {
  Vector3d middle, du, dv;  // the sides are du and dv [m]

  Vector3d Sample(int i) const {
    return middle + SampleOffset(i).x() * du + SampleOffset(i).y() * dv;
  }
};

class Renderer {
 public:
  explicit Renderer(const Scene& scene) : scene_(scene) {
    const Camera& camera = scene.camera;
    const Vector3d front = camera.right.cross(Vector3d::UnitZ());  // level, to the camera
    lamp_ = (-kLampLeft * camera.right + kLampFront * front + kLampAbove * Vector3d::UnitZ())
                .normalized();
    parts_ = PartsOfLamp(lamp_);
    for (size_t i = 0; i < scene.links.size(); ++i) all_.push_back(i);
  }

  // The pixel of width `step` around (x, y); see Camera::RayThrough.
  Layer Pixel(double x, double y, double step) {
    const Ray ray = scene_.camera.RayThrough(x, y);
    const Layer floor = Floor(ray, x, y, step);
    scene_.robot.FindNear(ray, 0, 2 * step * Camera::kHalfWidth, near_);
    if (near_.empty()) return floor;
    openness_link_ = PosedRobot::kNone;
    Layer sum;
    for (int i = 0; i < kSamples; ++i) {
      const Eigen::Vector2d offset = step * SampleOffset(i);
      const Ray through = scene_.camera.RayThrough(x + offset.x(), y + offset.y());
      const Layer sample = Sample(through, PartOfLamp(i * kParts / kSamples), floor);
      sum.light += sample.light / kSamples;
      sum.cover += sample.cover / kSamples;
    }
    return sum;
  }

 private:
  const Vector3d& PartOfLamp(int i) const { return parts_[static_cast<size_t>(i)]; }

  Layer Floor(const Ray& ray, double x, double y, double step) {
    const Ray right = scene_.camera.RayThrough(x + step, y);
    const Ray up = scene_.camera.RayThrough(x, y + step);
    const std::optional<Hit> hit = scene_.terrain.FirstHit(ray);
    const std::optional<Hit> beside = scene_.terrain.FirstHit(right);
    const std::optional<Hit> above = scene_.terrain.FirstHit(up);
    if (!hit || !beside || !above) return {};
    const Vector3d middle = ray.At(hit->distance);
    const FloorPatch patch = {middle, right.At(beside->distance) - middle,
                              up.At(above->distance) - middle};
    const double open = scene_.robot.Openness(middle, hit->normal, PosedRobot::kNone);
    const double cover = 1 - (1 - kContactCover * (1 - open)) * (1 - kShadowCover * Shadow(patch)) *
                                 (1 - Shade(hit->normal, middle));
    return Layer::Of(LightOf(kShadowColor), cover)
        .Over(scene_.ground.Look(middle.head<2>(), patch.du.head<2>(), patch.dv.head<2>()));
  }

  // How much darker ground is that does not face up.
  double Shade(const Vector3d& normal, const Vector3d& place) const {
    const double part = std::max(0., normal.dot(lamp_)) / lamp_.z();
    return kSlopeCover * std::max(0., 1 - part) * scene_.ground.Presence(place.head<2>());
  }

  // How much of the lamp the robot hides from a piece of the floor.
  double Shadow(const FloorPatch& patch) {
    scene_.robot.FindNear({patch.middle, lamp_}, patch.du.norm() + patch.dv.norm(), kLampRadius,
                          casters_);
    if (casters_.empty()) return 0;
    const double outer = Shadow(patch, kParts - kSamples);  // tells most places that are all in or
    if (outer == 0 || outer == 1) return outer;             // all out of the shadow
    return Shadow(patch, 0);
  }
  // Of the parts of the lamp from `first` on.
  double Shadow(const FloorPatch& patch, int first) const {
    int hidden = 0;
    for (int i = first; i < kParts; ++i) {
      const Ray ray = {patch.Sample(i % kSamples), PartOfLamp(i)};
      hidden += scene_.robot.IsBlocked(casters_, ray, PosedRobot::kNone);
    }
    return static_cast<double>(hidden) / (kParts - first);
  }

  Layer Sample(const Ray& ray, const Vector3d& lamp, const Layer& floor) {
    const std::optional<RobotHit> hit = scene_.robot.FirstHitOf(near_, ray);
    const bool is_under_floor = hit && scene_.terrain.Hides(ray, hit->hit.distance);
    return hit && !is_under_floor ? Robot(*hit, ray, lamp) : floor;
  }

  Layer Robot(const RobotHit& hit, const Ray& ray, const Vector3d& lamp) {
    const Vector3d place = ray.At(hit.hit.distance);
    const Vector3d& normal = hit.hit.normal;
    Illumination light;
    light.to_lamp = lamp;
    light.to_eye = -ray.direction;
    light.to_fill = scene_.camera.right;
    light.is_lit = normal.dot(lamp) > 0 && !scene_.robot.IsBlocked(all_, {place, lamp}, hit.link);
    light.openness = Openness(hit.link, place, normal);
    const Light color = ColorAt(scene_.paints[hit.link], scene_.links[hit.link].shape, hit.place);
    return Layer::Of(runtime::Shade(color, normal, light), 1);
  }

  // One for all samples of a pixel that show the same link: it changes little.
  double Openness(size_t link, const Vector3d& place, const Vector3d& normal) {
    if (openness_link_ != link) {
      openness_link_ = link;
      openness_ = scene_.robot.Openness(place, normal, link);
    }
    return openness_;
  }

  const Scene& scene_;
  Vector3d lamp_;  // direction to its middle
  std::array<Vector3d, kParts> parts_;
  std::vector<size_t> all_;      // links
  std::vector<size_t> near_;     // what the present pixel may show
  std::vector<size_t> casters_;  // what may cast a shadow into it
  size_t openness_link_ = PosedRobot::kNone;
  double openness_ = 1;
};

}  // namespace

void Render(const Scene& scene, int left, int size, Image& image) {
  Renderer renderer(scene);
  const StrokeLayer strokes(scene.camera, scene.strokes, size);
  const double step = 1. / size;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Layer pixel = renderer.Pixel((x + 0.5) * step, 1 - (y + 0.5) * step, step);
      StorePixel(strokes.at(x, y).Over(pixel), image.pixel(left + x, y));
    }
  }
}

}  // namespace runtime
