#include <fmt/format.h>

#include <array>
#include <numbers>

#include "plugins/world/heightmap.h"
#include "plugins/world/read_parts.h"
#include "plugins/world/world_keys.h"

namespace world {
namespace {

using robot::TomlValue;

constexpr double kSteepest = 80;  // [deg]
constexpr int kMostSteps = 100;
constexpr double kRadian = std::numbers::pi / 180;

struct Source {
  const std::filesystem::path& file;
  const ReadFile& read;
};

// Each reads what is special in one kind of ground.

void ReadPlane(const TomlValue&, const Source&, Ground& ground) { ground.shape = Plane{}; }

void ReadSlope(const TomlValue& value, const Source&, Ground& ground) {
  Slope slope;
  const TomlValue angle = value.At("angle_deg");
  const double degrees = angle.Number();
  if (degrees < 0 || degrees > kSteepest) {
    angle.Fail(fmt::format("a slope of {} degrees", degrees),
               fmt::format("give 0 to {}; which way it rises is `direction_deg`", kSteepest));
  }
  slope.angle = kRadian * degrees;
  if (const auto direction = value.Find("direction_deg"))
    slope.direction = kRadian * direction->Number();
  ground.shape = slope;
}

void ReadSteps(const TomlValue& value, const Source&, Ground& ground) {
  Steps steps;
  steps.start = value.At("start").Number();
  steps.depth = value.At("depth").PositiveNumber();
  steps.height = value.At("height").PositiveNumber();
  const TomlValue count = value.At("count");
  steps.count = count.Count();
  if (steps.count > kMostSteps)
    count.Fail(fmt::format("{} steps", steps.count),
               fmt::format("give at most {}; the last step has no end", kMostSteps));
  ground.shape = steps;
}

void ReadHeightMap(const TomlValue& value, const Source& source, Ground& ground) {
  const TomlValue file = value.At("file");
  const std::filesystem::path path = (source.file.parent_path() / file.Text()).lexically_normal();
  const std::optional<std::string> bytes = source.read(path);
  if (!bytes) {
    file.Fail(fmt::format("there is no file `{}`", path.string()),
              "a path is relative to the folder of the world's file");
  }
  HeightMap map;
  map.file = file.Text();
  const TomlValue size = value.At("size");
  const std::vector<double> extents = size.Numbers(2);
  for (const TomlValue& extent : size.Items()) extent.PositiveNumber();
  map.size_x = extents[0];
  map.size_y = extents[1];
  if (const auto center = value.Find("center")) {
    const std::vector<double> place = center->Numbers(2);
    map.center_x = place[0];
    map.center_y = place[1];
  }
  const auto height = value.Find("height");
  const HeightGrid grid = ParseHeights(*bytes);
  if (!grid.problem.empty())
    file.Fail(fmt::format("`{}` is no height map: {}", map.file, grid.problem),
              "it is a CSV file of heights in meters, or a PGM picture");
  const bool is_picture = grid.white > 0;
  if (is_picture && !height)
    value.Fail("the height of what is white is not known", "add `height`, in meters");
  if (!is_picture && height)
    height->Fail("a file of numbers says its heights itself", "leave out `height`");
  const double factor = height ? height->PositiveNumber() : 1;
  map.columns = grid.columns;
  map.rows = grid.rows;
  for (const double number : grid.values) map.heights.push_back(factor * number);
  ground.shape = std::move(map);
}

struct GroundKind {
  const char* name;
  void (*read)(const TomlValue&, const Source&, Ground&);
};
constexpr std::array kGroundKinds = {GroundKind{"plane", ReadPlane}, GroundKind{"slope", ReadSlope},
                                     GroundKind{"steps", ReadSteps},
                                     GroundKind{"heightmap", ReadHeightMap}};

}  // namespace

Ground ReadGround(const TomlValue& root, const std::filesystem::path& file, const ReadFile& read) {
  Ground ground;
  const auto found = root.Find("ground");
  if (!found) return ground;
  const TomlValue value = found->Called("`ground`");
  std::vector<std::string> names;
  for (const GroundKind& kind : kGroundKinds) names.emplace_back(kind.name);
  const GroundKind& kind = kGroundKinds[value.At("kind").IndexIn(names, "kind of ground")];
  value.AllowKeys(KeysOf(kind.name));
  kind.read(value, {file, read}, ground);
  if (const auto friction = value.Find("friction"))
    ground.friction = friction->NumberNotBelowZero();
  return ground;
}

}  // namespace world
