// What is around a robot, as a world file says it: the ground, and things on it. A task names such
// a file: `task kick for humanoid in "ball.toml"`; docs/worlds.md explains it.
//
// Units: m, kg, s, rad. World frame: x forward, y left, z up; a robot starts at the origin as its
// pose says. Without a world it is alone on flat ground.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "plugins/robot/robot_description.h"

namespace world {

using robot::Quaternion;
using robot::Vector3;

struct Plane {  // z = 0
  bool operator==(const Plane&) const = default;
};

// A plane through the origin that rises toward a direction.
struct Slope {
  double angle = 0;      // [rad]
  double direction = 0;  // from +x toward +y [rad]
  bool operator==(const Slope&) const = default;
};

// Stairs up toward +x from the plane z = 0, as wide as the world; the last step has no end.
struct Steps {
  double start = 0;   // x of the first riser
  double depth = 0;   // of a tread
  double height = 0;  // of a riser
  int count = 0;
  bool operator==(const Steps&) const = default;
};

// Hills on the plane z = 0: heights in equal distances, between which the ground is straight.
struct HeightMap {
  std::string file{};  // as the world names it
  int columns = 0;     // along +x, at least 2
  int rows = 0;        // along +y, at least 2
  double size_x = 0;
  double size_y = 0;
  double center_x = 0;
  double center_y = 0;
  std::vector<double> heights{};  // row by row, the one with the least y first; none below 0

  double At(int column, int row) const {
    return heights[static_cast<size_t>(row * columns + column)];
  }
  bool operator==(const HeightMap&) const = default;
};

struct Ground {
  std::variant<Plane, Slope, Steps, HeightMap> shape{};
  double friction = robot::kUnlimited;  // coefficient; of two that touch the smaller one counts

  bool operator==(const Ground&) const = default;
};

struct Thing {
  std::string name{};
  robot::LinkShape shape{};
  bool is_fixed = false;
  double mass = 0;  // of uniform density; of a fixed one 0
  double friction = robot::kUnlimited;
  // Where it is when an episode begins: its center, and the turn from its own frame to the world's.
  Vector3 position{};
  Quaternion orientation{1, 0, 0, 0};

  bool operator==(const Thing& other) const;
};

struct WorldDescription {
  std::string doc{};
  Ground ground{};
  std::vector<Thing> things{};

  bool operator==(const WorldDescription&) const = default;
};

// A file that a world names, or nothing where there is none.
using ReadFile = std::function<std::optional<std::string>(const std::filesystem::path&)>;

// Reads and checks the world in `text`, the contents of `file`; `read` is asked for the file of
// its height map, whose path is relative to that of `file`. Throws robot::DescriptionError.
WorldDescription ReadWorld(std::string_view text, const std::filesystem::path& file,
                           const ReadFile& read);

// A world file's name ends so, and no other file of a task does.
inline constexpr std::string_view kWorldEnding = ".toml";

// The world among a task's texts, each of which has a `file` and a `text`; nothing where there is
// none. Throws DescriptionError.
template <typename Sources>
std::optional<WorldDescription> WorldIn(const Sources& sources) {
  const auto read = [&](const std::filesystem::path& path) -> std::optional<std::string> {
    for (const auto& source : sources)
      if (path == source.file) return source.text;
    return std::nullopt;
  };
  for (const auto& source : sources) {
    if (std::string_view(source.file).ends_with(kWorldEnding))
      return ReadWorld(source.text, source.file, read);
  }
  return std::nullopt;
}

}  // namespace world
