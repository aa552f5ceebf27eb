#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "plugins/world/world_description.h"

namespace runtime {

// The shapes of the robot's links and of the things in its world (null: none), for who draws the
// recordings, in the order of their poses there: a JSON list with one object for each,
// {"name", "shape": "box"|"capsule"|"cylinder"|"sphere"|"convex", "size": [x, y, z], "radius",
// "length", "axis": 0|1|2} and, where the shape is not around the link's center or turned,
// "position": [x, y, z], "orientation": [w, x, y, z]; of a convex one "points": [[x, y, z], ...];
// of a thing "thing": true; of a link its "mass" [kg] and the "joint" that it hangs on, if any:
// {"name", "kind": "hinge"|"continuous"|"slider", "parent": link index, "axis": [x, y, z], "stops":
// [low, high] where it has any}, of a slider also its pinion's "radius" [m] and the "offset" of the
// link from its parent in the zero pose. What these say is said in robot_description.h.
std::string BodyJson(const robot::RobotDescription& robot,
                     const world::WorldDescription* world = nullptr);

// What moves in the recordings.
struct RecordedBody {
  std::vector<robot::Link> parts;  // with names and shapes and nothing else
  size_t things = 0;               // how many of them, at the end, are none of the robot's links

  std::vector<robot::Link> links() const {
    return {parts.begin(), parts.end() - static_cast<ptrdiff_t>(things)};
  }
};

// What BodyJson() has written; nothing where the text is not such a list, or has a shape that no
// link can have.
std::optional<RecordedBody> ParseBody(const std::string& json);

}  // namespace runtime
