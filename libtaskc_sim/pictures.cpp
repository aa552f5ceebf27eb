#include "libtaskc_sim/pictures.h"

#include <algorithm>

#include "libtaskc_sim/failure.h"
#include "runtime/analysis/picture/background.h"
#include "runtime/analysis/picture/ground.h"
#include "runtime/analysis/picture/image.h"
#include "runtime/analysis/picture/posed_robot.h"
#include "runtime/analysis/picture/render.h"
#include "runtime/core/task/task_world.h"
#include "runtime/training/run/recorder.h"

namespace libtaskc_sim {
namespace {

using Eigen::Vector3d;
using runtime::Motion;

// How far the first link has gone, along the ground.
Vector3d WayBetween(const Motion& from, const Motion& to) {
  Vector3d way = to.position(0, 0) - from.position(0, 0);
  way.z() = 0;
  return way;
}

void AddFrame(const Motion& frame, const Vector3d& offset, Motion& motion) {
  for (const Vector3d& position : frame.positions) motion.positions.push_back(position + offset);
  motion.orientations.insert(motion.orientations.end(), frame.orientations.begin(),
                             frame.orientations.end());
}

// Those behind a joint or a mount that lets them turn; where nothing carries the robot, all.
std::vector<bool> TurningLinks(const robot::RobotDescription& robot) {
  std::vector<bool> turns(robot.links.size(), !robot.has_fixed_base);
  for (const robot::Branch& branch : robot.Branches()) {
    const auto index = static_cast<size_t>(std::max(branch.joint, branch.mount));
    const bool turns_here = branch.joint >= 0
                                ? robot.joints[index].kind != robot::JointKind::kSlider
                                : robot.mounts[index].kind == robot::MountKind::kBall;
    turns[static_cast<size_t>(branch.child)] =
        turns_here || turns[static_cast<size_t>(branch.parent)];
  }
  return turns;
}

// A frame that nobody sees, in which all links turn that can: what a picture is about does not
// depend on what has moved before it.
void AddTurned(const Motion& frame, const std::vector<bool>& turns, Motion& motion) {
  const size_t first = motion.orientations.size();
  AddFrame(frame, Vector3d::Zero(), motion);
  for (size_t i = 0; i < turns.size(); ++i) {
    if (!turns[i]) continue;
    Eigen::Quaterniond& orientation = motion.orientations[first + i];
    orientation = orientation * Eigen::Quaterniond(0, 1, 0, 0);  // half a turn
  }
}

void CopyColors(const runtime::Image& image, unsigned char* rgb) {
  for (size_t i = 0; i < image.bytes.size(); i += runtime::Image::kChannels) {
    rgb = std::copy_n(image.bytes.begin() + static_cast<ptrdiff_t>(i), 3, rgb);
  }
}

}  // namespace

const Pictures::Scenery& Pictures::TheScenery() {
  if (scenery_ != nullptr) return *scenery_;
  const std::unique_ptr<const world::WorldDescription> world =
      runtime::WorldOf(setup_.plugin->table());
  runtime::RecordedBody body =
      runtime::ParseBody(runtime::BodyJson(setup_.robot, world.get())).value();
  scenery_ = std::make_unique<const Scenery>(Scenery{
      body, body.links(), TurningLinks(setup_.robot), runtime::PaintsOf(body.parts, body.things),
      runtime::Terrain(world == nullptr ? world::Ground{} : world->ground)});
  return *scenery_;
}

Motion Pictures::Now(const runtime::DecisionProcess& process) const {
  const runtime::Environment& environment = process.environment();
  Motion motion{environment.time_step(), environment.pose_count(), {}, {}};
  constexpr size_t kFloats = runtime::Recorder::kFloatsPerLink;
  std::vector<float> poses(kFloats * static_cast<size_t>(motion.link_count));
  environment.CapturePose(poses);
  for (size_t i = 0; i < poses.size(); i += kFloats) {
    const float* pose = poses.data() + i;
    motion.positions.emplace_back(pose[0], pose[1], pose[2]);
    motion.orientations.emplace_back(pose[3], pose[4], pose[5], pose[6]);
  }
  return motion;
}

// As if the robot were still where it was at first: how far it has gone does not matter to the
// camera then.
runtime::Camera Pictures::Follow(const Motion& now, View& view) const {
  const Vector3d way = WayBetween(view.first, now);
  Motion both = view.first;
  AddFrame(now, -way, both);
  AddTurned(view.first, scenery_->turns, both);
  runtime::Camera camera = runtime::PlaceCameras(both, scenery_->robot, {0, 1}).back();
  Vector3d target = camera.target() + way;
  view.distance = std::max(view.distance, camera.distance);
  view.height = std::max(view.height, target.z());
  target.z() = view.height;
  camera.distance = view.distance;
  camera.position = target - camera.distance * camera.forward;
  return camera;
}

void Pictures::Draw(uint32_t environment, const runtime::DecisionProcess& process, int size,
                    unsigned char* rgb) {
  if (process.environment().link_count() == 0) {
    throw Failure(TASKC_SIM_ERROR_SETUP, "the task has no robot: there is nothing to draw");
  }
  const Scenery& scenery = TheScenery();
  const Motion now = Now(process);
  View& view = views_[environment];
  if (view.episode != process.number()) view = {process.number(), now, 0, 0};
  const runtime::Camera camera = Follow(now, view);
  const runtime::PosedRobot robot(scenery.body.parts, now, 0);
  const runtime::Ground ground(camera, {});
  runtime::Image image(size, size);
  runtime::Render({scenery.body.parts, scenery.paints, robot, scenery.terrain, ground, camera}, 0,
                  size, image);
  runtime::FillBackground(image);
  CopyColors(image, rgb);
}

}  // namespace libtaskc_sim
