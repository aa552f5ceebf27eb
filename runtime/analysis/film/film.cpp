#include "runtime/analysis/film/film.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <numeric>
#include <thread>

#include "runtime/analysis/picture/background.h"
#include "runtime/analysis/picture/ground.h"
#include "runtime/analysis/picture/posed_robot.h"
#include "runtime/analysis/picture/render.h"
#include "runtime/analysis/picture/subject.h"

namespace runtime {
namespace {

constexpr double kSmoothing = 0.4;  // half the time over which the camera's way is averaged [s]

// The pose of a link at a time between two frames, which are close to each other.
void AddPose(const Motion& motion, double time, int link, Motion& out) {
  const double frame = std::clamp(time / motion.frame_interval, 0., motion.frame_count() - 1.);
  const int before = static_cast<int>(frame);
  const int after = std::min(before + 1, motion.frame_count() - 1);
  const double part = frame - before;
  out.positions.push_back((1 - part) * motion.position(before, link) +
                          part * motion.position(after, link));
  const Eigen::Vector4d a = motion.orientation(before, link).coeffs();
  const Eigen::Vector4d b = motion.orientation(after, link).coeffs();
  const double sign = a.dot(b) < 0 ? -1 : 1;  // q and -q are the same orientation
  const Eigen::Vector4d between = (1 - part) * a + sign * part * b;
  out.orientations.emplace_back(Eigen::Vector4d(between / between.norm()));
}

// A frame for each picture.
Motion Resampled(const Motion& motion, const FilmOptions& options) {
  const double from = std::clamp(options.from, 0., motion.duration());
  const double to = std::clamp(options.to, from, motion.duration());
  Motion film;
  film.frame_interval = options.speed / Film::kPicturesPerSecond;
  film.link_count = motion.link_count;
  for (int i = 0; from + i * film.frame_interval <= to + 1e-9; ++i) {
    for (int link = 0; link < motion.link_count; ++link) {
      AddPose(motion, from + i * film.frame_interval, link, film);
    }
  }
  return film;
}

std::vector<int> AllFrames(const Motion& motion) {
  std::vector<int> frames(static_cast<size_t>(motion.frame_count()));
  std::iota(frames.begin(), frames.end(), 0);
  return frames;
}

// Without the swaying of limbs: each place the mean of those around, fewer toward both ends.
std::vector<Camera> Smoothed(const std::vector<Camera>& cameras, int half) {
  std::vector<Camera> smooth = cameras;
  const int last = static_cast<int>(cameras.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    const int reach = std::min({half, i, last - i});
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = i - reach; k <= i + reach; ++k) sum += cameras[static_cast<size_t>(k)].position;
    smooth[static_cast<size_t>(i)].position = sum / (2 * reach + 1);
  }
  return smooth;
}

}  // namespace

Film::Film(const Motion& motion, const std::vector<robot::Link>& links, const FilmOptions& options)
    : motion_(Resampled(motion, options)),
      links_(links),
      paints_(PaintsOf(links, options.things)),
      terrain_(options.ground),
      size_(options.size) {
  const std::vector<robot::Link> robot_links(links.begin(),
                                             links.end() - static_cast<ptrdiff_t>(options.things));
  followed_ = SubjectOf(motion_, robot_links).front();
  const int half = static_cast<int>(std::floor(kSmoothing / motion_.frame_interval));
  cameras_ = Smoothed(PlaceCameras(motion_, robot_links, AllFrames(motion_)), half);
}

Image Film::Picture(size_t index) const {
  const int frame = static_cast<int>(index);
  const PosedRobot robot(links_, motion_, frame);
  const Ground ground(cameras_[index], TrailOf(motion_, followed_, {frame}, 0));
  Image image(size_, size_);
  Render({links_, paints_, robot, terrain_, ground, cameras_[index]}, 0, size_, image);
  FillBackground(image);
  return image;
}

void Film::Draw(const std::function<void(const Image&)>& take) const {
  const size_t at_once = std::max(1u, std::thread::hardware_concurrency());
  for (size_t next = 0; next < cameras_.size(); next += at_once) {
    std::vector<std::future<Image>> pictures;
    for (size_t i = next; i < std::min(next + at_once, cameras_.size()); ++i) {
      pictures.push_back(std::async(std::launch::async, [this, i] { return Picture(i); }));
    }
    for (std::future<Image>& picture : pictures) take(picture.get());
  }
}

}  // namespace runtime
