#include "runtime/training/simulation/mjcf_surroundings.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/world/ground.h"

namespace runtime {
namespace {

constexpr const char* kPlane = "ground plane";
constexpr const char* kHills = "ground hills";

std::string StepName(size_t step) { return fmt::format("ground step {}", step + 1); }

const world::HeightMap* HillsOf(const Surroundings& around) {
  const world::WorldDescription* world = around.description();
  return world == nullptr ? nullptr : std::get_if<world::HeightMap>(&world->ground.shape);
}

std::vector<world::Block> StepsOf(const Surroundings& around) {
  const world::WorldDescription* world = around.description();
  return world == nullptr ? std::vector<world::Block>() : world::BlocksOf(world->ground);
}

// MuJoCo stretches heights so that the lowest is 0 and the highest 1, and says these in meters.
struct HeightRange {
  explicit HeightRange(const world::HeightMap& map)
      : low(*std::ranges::min_element(map.heights)),
        size(*std::ranges::max_element(map.heights) - low) {}

  double low;
  double size;
};

// Of all that the ground is made of.
std::vector<std::string> GroundNames(const Surroundings& around) {
  std::vector<std::string> names = {kPlane};
  for (size_t i = 0; i < StepsOf(around).size(); ++i) names.push_back(StepName(i));
  if (HillsOf(around) != nullptr) names.emplace_back(kHills);
  return names;
}

template <typename Value>
void AddBytes(Value value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string MjcfNameOf(const world::Thing& thing) { return fmt::format("thing {}", thing.name); }

std::string HillsFile(const Surroundings& around) {
  const world::HeightMap* map = HillsOf(around);
  std::string bytes;
  if (map == nullptr) return bytes;
  const HeightRange range(*map);
  AddBytes<int32_t>(map->rows, bytes);
  AddBytes<int32_t>(map->columns, bytes);
  for (const double height : map->heights) AddBytes(static_cast<float>(height - range.low), bytes);
  return bytes;
}

void AppendAssets(const Surroundings& around, MjcfText& text) {
  const world::HeightMap* map = HillsOf(around);
  if (map == nullptr) return;
  constexpr double kLevel = 1e-3;  // what MuJoCo is told of hills that are all level, and not used
  const double size = HeightRange(*map).size;
  Append(text, "<hfield name='{}' file='{}' size='{} {} {} {}'/>\n", kHills, kHillsFile,
         map->size_x / 2, map->size_y / 2, size > 0 ? size : kLevel, kGroundDepth);
}

void AppendGround(const Surroundings& around, MjcfText& text) {
  const world::WorldDescription* world = around.description();
  const robot::Quaternion turn =
      world == nullptr ? robot::Quaternion{1, 0, 0, 0} : world::TurnOf(world->ground);
  Append(text, "<geom name='{}' type='plane' size='1 1 1' quat='{} {} {} {}'/>\n", kPlane, turn[0],
         turn[1], turn[2], turn[3]);
  const std::vector<world::Block> steps = StepsOf(around);
  for (size_t i = 0; i < steps.size(); ++i) {
    const world::Block& step = steps[i];
    const double height = step.height + kGroundDepth;
    const robot::LinkShape box{.kind = robot::ShapeKind::kBox,
                               .size = {step.high_x - step.low_x, world::kWidth, height}};
    AppendShapeAt(StepName(i), box, {(step.low_x + step.high_x) / 2, 0, step.height - height / 2},
                  {1, 0, 0, 0}, text);
  }
  if (const world::HeightMap* map = HillsOf(around)) {
    Append(text, "<geom name='{0}' type='hfield' hfield='{0}' pos='{1} {2} {3}'/>\n", kHills,
           map->center_x, map->center_y, HeightRange(*map).low);
  }
}

void AppendThings(const Surroundings& around, const RobotBody& body, MjcfText& text) {
  for (size_t i = 0; i < around.things().size(); ++i) {
    const world::Thing& thing = around.things()[i];
    const std::string name = MjcfNameOf(thing);
    if (thing.is_fixed) {
      AppendShapeAt(name, thing.shape, thing.position, thing.orientation, text);
    } else {
      Append(text, "<body name='{0}'><freejoint name='{0}'/>", name);
      AppendInertia(name, body.body(around.BodyOf(i)), text);
      AppendShape(name, thing.shape, text);
      Append(text, "</body>");
    }
    Append(text, "\n");
  }
}

void AppendPairs(const robot::RobotDescription& robot, const Surroundings& around, MjcfText& text) {
  const std::vector<std::string> ground = GroundNames(around);
  const auto on_ground = [&](const std::string& name, double friction) {
    for (const std::string& part : ground) {
      AppendPair(part, name, std::min(friction, around.friction()), text);
    }
  };
  const size_t first_movable = robot.has_fixed_base ? 1 : 0;
  for (size_t i = first_movable; i < robot.links.size(); ++i) {
    on_ground(robot.links[i].name, robot.links[i].friction);
  }
  const std::span<const world::Thing> things = around.things();
  for (size_t i = 0; i < things.size(); ++i) {
    const world::Thing& thing = things[i];
    const std::string name = MjcfNameOf(thing);
    if (!thing.is_fixed) on_ground(name, thing.friction);
    for (size_t link = thing.is_fixed ? first_movable : 0; link < robot.links.size(); ++link) {
      AppendPair(robot.links[link].name, name, std::min(robot.links[link].friction, thing.friction),
                 text);
    }
    for (size_t j = 0; j < i; ++j) {
      if (thing.is_fixed && things[j].is_fixed) continue;
      AppendPair(MjcfNameOf(things[j]), name, std::min(things[j].friction, thing.friction), text);
    }
  }
}

}  // namespace runtime
