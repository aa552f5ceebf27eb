// Pictures of the environments' robots as they are now.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "runtime/analysis/behavior/motion.h"
#include "runtime/analysis/picture/camera.h"
#include "runtime/analysis/picture/surface.h"
#include "runtime/analysis/picture/terrain.h"
#include "runtime/trainer/environment/decision_process.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/body_json.h"

namespace libtaskc_sim {

class Pictures {
 public:
  // `setup` outlives this object.
  explicit Pictures(const runtime::TaskSetup& setup) : setup_(setup) {}

  // `environment`: the number of `process`, which was reset. `rgb`: [size][size][3], the top row
  // first. Throws Failure where there is no robot.
  void Draw(uint32_t environment, const runtime::DecisionProcess& process, int size,
            unsigned char* rgb);

 private:
  // What all pictures have in common; made for the first one.
  struct Scenery {
    runtime::RecordedBody body;
    std::vector<robot::Link> robot;  // the links, without things
    std::vector<bool> turns;         // which of them can
    std::vector<runtime::Paint> paints;
    runtime::Terrain terrain;
  };
  // Of one environment in one episode. The camera looks from one side, goes along with the robot,
  // and backs away where that reaches farther than before.
  struct View {
    int64_t episode = 0;
    runtime::Motion first;  // one frame
    double distance = 0;    // of the camera from what it looks at [m]
    double height = 0;      // of that [m]
  };

  const Scenery& TheScenery();
  runtime::Motion Now(const runtime::DecisionProcess& process) const;
  runtime::Camera Follow(const runtime::Motion& now, View& view) const;

  const runtime::TaskSetup& setup_;
  std::unique_ptr<const Scenery> scenery_;
  std::map<uint32_t, View> views_;
};

}  // namespace libtaskc_sim
