#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "plugins/world/thing_sensors.h"
#include "plugins/world/world_description.h"

namespace world {
namespace {

WorldDescription Yard() {
  std::ostringstream text;
  text << std::ifstream(WORLDS "/yard.toml").rdbuf();
  return ReadWorld(text.str(), "yard.toml", [](const auto&) { return std::nullopt; });
}

TEST(World, HasItsGroundAndItsThings) {
  const WorldDescription yard = Yard();
  EXPECT_EQ(yard.doc, "A ball and a post on a slope.");
  const Slope slope = std::get<Slope>(yard.ground.shape);
  EXPECT_DOUBLE_EQ(slope.angle, std::numbers::pi / 18);
  EXPECT_DOUBLE_EQ(slope.direction, std::numbers::pi / 2);
  EXPECT_EQ(yard.ground.friction, 0.8);
  ASSERT_EQ(yard.things.size(), 2u);
  const Thing& ball = yard.things[0];
  EXPECT_EQ(ball.name, "ball");
  EXPECT_EQ(ball.shape.kind, robot::ShapeKind::kSphere);
  EXPECT_EQ(ball.shape.radius, 0.1);
  EXPECT_EQ(ball.mass, 0.4);
  EXPECT_EQ(ball.friction, 0.5);
  EXPECT_FALSE(ball.is_fixed);
  const Thing& post = yard.things[1];
  EXPECT_TRUE(post.is_fixed);
  EXPECT_EQ(post.position, (Vector3{2, 0, 0.5}));
  EXPECT_EQ(post.friction, robot::kUnlimited);
}

// The ball's center is one radius from the slope, which rises toward +y.
TEST(World, PutsDownAThingThatHasTwoNumbers) {
  const Thing ball = Yard().things[0];
  const double angle = std::numbers::pi / 18;
  EXPECT_DOUBLE_EQ(ball.position[0], 1);
  EXPECT_NEAR(ball.position[1], -0.1 * std::sin(angle), 1e-15);
  EXPECT_NEAR(ball.position[2], 0.1 * std::cos(angle), 1e-15);
  EXPECT_NEAR(ball.orientation[0], std::cos(angle / 2), 1e-15);
  EXPECT_NEAR(ball.orientation[1], std::sin(angle / 2), 1e-15);
}

TEST(World, OffersSensorsOfEachThing) {
  const std::vector<ThingSensor> sensors = SensorsOf(Yard());
  ASSERT_EQ(sensors.size(), 10u);
  EXPECT_EQ(sensors[0].name, "ball.position");
  EXPECT_EQ(sensors[0].type, "vec3");
  EXPECT_EQ(sensors[0].at_rest.size(), 3u);
  EXPECT_EQ(sensors[4].name, "contact_with.ball");
  EXPECT_EQ(sensors[4].type, "bool[link]");
  EXPECT_EQ(sensors[6].name, "post.orientation");
  EXPECT_EQ(sensors[6].thing, 1u);
}

TEST(World, IsEqualToOneThatSaysTheSame) {
  WorldDescription other = Yard();
  EXPECT_EQ(other, Yard());
  other.things[0].mass = 0.5;
  EXPECT_NE(other, Yard());
}

TEST(World, MayBeEmpty) {
  const WorldDescription world = ReadWorld("", "w.toml", nullptr);
  EXPECT_TRUE(std::holds_alternative<Plane>(world.ground.shape));
  EXPECT_TRUE(world.things.empty());
}

}  // namespace
}  // namespace world
