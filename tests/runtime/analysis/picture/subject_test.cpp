#include "runtime/analysis/picture/subject.h"

#include <gmock/gmock.h>

#include "runtime/analysis/picture/camera.h"

namespace runtime {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;

// A rail high up, a carriage below it that slides along x, and a leg of two balls far below these
// which the carriage leads and whose second ball turns.
struct Led {
  std::vector<robot::Link> links = std::vector<robot::Link>(4);
  Motion motion;

  explicit Led(double leg_height, bool base_is_fixed = true) {
    for (robot::Link& link : links) link.shape.radius = 0.1;
    motion.frame_interval = 0.02;
    motion.link_count = 4;
    for (int frame = 0; frame <= 100; ++frame) {
      const double x = 0.02 * frame;
      motion.positions.insert(motion.positions.end(), {{base_is_fixed ? 0 : x, 0, 3},
                                                       {x, 0, 2.85},
                                                       {x, 0, leg_height},
                                                       {x, 0, leg_height - 0.15}});
      for (int link = 0; link < 4; ++link) {
        const double angle = link == 3 ? 0.01 * frame : 0;
        motion.orientations.emplace_back(Eigen::AngleAxisd(angle, Vector3d::UnitY()));
      }
    }
  }
  std::vector<int> subject() const { return SubjectOf(motion, links); }
};

TEST(SubjectOf, IsTheWholeRobotThatMovesFreely) {
  EXPECT_THAT(Led(1, false).subject(), ElementsAre(0, 1, 2, 3));
}

TEST(SubjectOf, IsWhatTurnsAndWhatTouchesIt) { EXPECT_THAT(Led(1).subject(), ElementsAre(2, 3)); }

TEST(SubjectOf, IsTheWholeRobotThatHangsTogether) {
  EXPECT_THAT(Led(2.7).subject(), ElementsAre(0, 1, 2, 3));
}

TEST(SubjectOf, IsTheWholeRobotWhereNothingTurns) {
  Led led(1);
  for (Eigen::Quaterniond& orientation : led.motion.orientations) orientation.setIdentity();
  EXPECT_THAT(led.subject(), ElementsAre(0, 1, 2, 3));
}

TEST(PlaceCameras, FollowWhatIsLedAwayFromAFixedBase) {
  const Led led(0.4);
  const std::vector<Camera> cameras = PlaceCameras(led.motion, led.links, {0, 100});
  EXPECT_NEAR(cameras[1].target().x() - cameras[0].target().x(), 2, 1e-9);
  EXPECT_LT(cameras[0].view(), 0.7);  // of what is 0.35 m tall
}

}  // namespace
}  // namespace runtime
