#include "runtime/analysis/picture/snapshot_strip.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/seal/sha256.h"
#include "runtime/training/run/body_json.h"
#include "tests/runtime/analysis/picture/decode_png.h"
#include "tests/runtime/analysis/picture/standing_ball.h"
#include "tests/runtime/analysis/report/sample_run.h"

namespace runtime {
namespace {

using testing::ElementsAre;

// A frame each 0.5 s.
Motion MotionOf(int frames) {
  return MotionThrough(std::vector<Eigen::Vector3d>(static_cast<size_t>(frames), {0, 0, 1}));
}

struct Crawl {
  std::vector<robot::Link> links = ParseBody(SampleRunRecord().body).value().parts;
  Motion motion = ReadMotion(SampleRecording(2, 0.3), static_cast<int>(links.size()));
};

TEST(Body, IsKeptWithTheShapesThatAreMoved) {
  robot::RobotDescription robot;
  robot.links = {{"drum", 1, {}, {robot::ShapeKind::kCylinder, {}, 0.1, 0.3, 0}},
                 {"slab", 1, {}, {robot::ShapeKind::kBox, {1, 2, 3}}}};
  robot.links[1].shape.position = {0.1, 0.2, -0.3};
  robot.links[1].shape.orientation = {0.6, 0, 0.8, 0};
  const std::vector<robot::Link> links = ParseBody(BodyJson(robot)).value().parts;
  EXPECT_EQ(links[0].shape.kind, robot::ShapeKind::kCylinder);
  EXPECT_EQ(links[0].shape.length, 0.3);
  EXPECT_FALSE(links[0].shape.IsMoved());
  EXPECT_EQ(links[1].shape.position, robot.links[1].shape.position);
  EXPECT_EQ(links[1].shape.orientation, robot.links[1].shape.orientation);
}

TEST(Body, SaysWhatALinkWeighsAndHangsOn) {
  robot::RobotDescription robot;
  const robot::LinkShape ball = {robot::ShapeKind::kSphere, {}, 0.1};
  robot.links = {{"trunk", 2.5, {}, ball},
                 {"arm", 0.5, {0.1, 0, 0.2}, ball},
                 {"rod", 0.25, {0.1, 0.3, 0.2}, ball}};
  robot.joints = {{"shoulder", 0, 1, {0, 1, 0}, {}, -0.5, 1.5},
                  {"slide",
                   1,
                   2,
                   {1, 0, 0},
                   {},
                   -robot::kUnlimited,
                   robot::kUnlimited,
                   robot::JointKind::kSlider,
                   0.02}};
  const auto body = nlohmann::json::parse(BodyJson(robot));
  EXPECT_EQ(body[0]["mass"], 2.5);
  EXPECT_FALSE(body[0].contains("joint"));
  const nlohmann::json& shoulder = body[1]["joint"];
  EXPECT_EQ(shoulder["name"], "shoulder");
  EXPECT_EQ(shoulder["kind"], "hinge");
  EXPECT_EQ(shoulder["parent"], 0);
  EXPECT_EQ(shoulder["axis"], (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(shoulder["stops"], (std::vector<double>{-0.5, 1.5}));
  const nlohmann::json& slide = body[2]["joint"];
  EXPECT_FALSE(slide.contains("stops"));
  EXPECT_EQ(slide["radius"], 0.02);
  EXPECT_EQ(slide["offset"], (std::vector<double>{0, 0.3, 0}));
}

TEST(Body, TellsThingsFromLinks) {
  robot::RobotDescription robot;
  robot.links = {{"drum", 1, {}, {robot::ShapeKind::kCylinder, {}, 0.1, 0.3, 0}}};
  world::WorldDescription world;
  world.things = {{.name = "ball", .shape = {.kind = robot::ShapeKind::kSphere, .radius = 0.2}}};
  const RecordedBody body = ParseBody(BodyJson(robot, &world)).value();
  EXPECT_EQ(body.things, 1u);
  ASSERT_EQ(body.parts.size(), 2u);
  EXPECT_EQ(body.parts[1].name, "ball");
  EXPECT_EQ(body.links().size(), 1u);
}

TEST(SnapshotTimes, SpanTheMotionInEqualSteps) {
  EXPECT_THAT(SnapshotTimes(MotionOf(9), {.count = 3}), ElementsAre(0, 2, 4));
  EXPECT_EQ(SnapshotTimes(MotionOf(100)).size(), 8u);
}

TEST(SnapshotTimes, AreThoseOfTheNearestFrames) {
  EXPECT_THAT(SnapshotTimes(MotionOf(6), {.count = 4}), ElementsAre(0, 1, 1.5, 2.5));
}

TEST(SnapshotTimes, StayWithinTheChosenPart) {
  const Motion motion = MotionOf(9);
  EXPECT_THAT(SnapshotTimes(motion, {.count = 3, .from = 1, .to = 3}), ElementsAre(1, 2, 3));
  EXPECT_THAT(SnapshotTimes(motion, {.count = 3, .from = 3, .to = 9}), ElementsAre(3, 3.5, 4));
  EXPECT_THAT(SnapshotTimes(motion, {.count = 2, .from = 9}), ElementsAre(4, 4));
}

TEST(SnapshotTimes, RepeatFramesWhereThereAreTooFew) {
  EXPECT_THAT(SnapshotTimes(MotionOf(1), {.count = 2}), ElementsAre(0, 0));
  EXPECT_THAT(SnapshotTimes(MotionOf(9), {.count = 1}), ElementsAre(0));
}

// The pixels of a crawl. Where they have changed on purpose, look at them (`trainer snapshots`),
// then write down what the test says they are.
TEST(SnapshotStrip, HasTheSamePixelsEverywhere) {
  const Crawl crawl;
  const Image image =
      DecodePng(SnapshotStrip(crawl.motion, crawl.links, {.count = 3, .height = 100}));
  EXPECT_EQ(image.width, 300);
  EXPECT_EQ(image.height, 100);
  EXPECT_EQ(seal::Sha256({reinterpret_cast<const char*>(image.bytes.data()), image.bytes.size()}),
            "123e58588cf741ada9f4142b9fd1063ec9b6d768189d340bb7e8aeff4673c1bc");
}

TEST(SnapshotStrip, IsTheSameFileEachTime) {
  const Crawl crawl;
  const StripOptions options{.count = 2, .height = 60};
  EXPECT_EQ(SnapshotStrip(crawl.motion, crawl.links, options),
            SnapshotStrip(crawl.motion, crawl.links, options));
}

// Whatever stands beside it.
TEST(SnapshotStrip, ShowsTheChosenPart) {
  const Motion motion = MotionThrough({{0, 0, 0.1}, {1, 0, 0.1}, {2, 0, 0.1}, {2, 0, 0.5}});
  const auto strip = [&](double from, double to) {
    return DecodePng(
        SnapshotStrip(motion, Ball(0.1), {.count = 1, .height = 60, .from = from, .to = to}));
  };
  EXPECT_EQ(strip(0.5, 0.5).bytes, strip(0.6, 0.6).bytes);
  EXPECT_NE(strip(0.5, 0.5).bytes, strip(1.5, 1.5).bytes);
}

TEST(SnapshotStrip, DrawsWhatASimulationThatDivergedLeaves) {
  const std::vector<Eigen::Vector3d> places = {
      {0, 0, 0.1}, {1e30, -1e30, 1e30}, {0, 0, -1e30}, {3e38, 3e38, -3e38}};
  const Image image =
      DecodePng(SnapshotStrip(MotionThrough(places), Ball(0.1), {.count = 4, .height = 32}));
  EXPECT_EQ(image.width, 4 * 32);
}

}  // namespace
}  // namespace runtime
