#include "runtime/training/run/recorded_ground.h"

#include <nlohmann/json.hpp>

#include "plugins/world/ground.h"

namespace runtime {

world::Ground GroundOf(const RunRecord& run) {
  if (run.tasks.empty()) return {};
  try {
    const auto world = world::WorldIn(run.tasks.front().sources);
    return world ? world->ground : world::Ground{};
  } catch (const robot::DescriptionError&) {
    return {};
  }
}

nlohmann::json GroundJson(const world::Ground& ground) {
  nlohmann::json json = {{"normal", world::NormalOf(ground)}, {"blocks", nlohmann::json::array()}};
  for (const world::Block& block : world::BlocksOf(ground)) {
    json["blocks"].push_back(
        {{"low_x", block.low_x}, {"high_x", block.high_x}, {"height", block.height}});
  }
  if (const auto* map = std::get_if<world::HeightMap>(&ground.shape)) {
    json["hills"] = {{"columns", map->columns},
                     {"rows", map->rows},
                     {"size", {map->size_x, map->size_y}},
                     {"center", {map->center_x, map->center_y}},
                     {"heights", map->heights}};
  }
  return json;
}

}  // namespace runtime
