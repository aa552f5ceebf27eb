#pragma once

#include <vector>

#include "runtime/analysis/picture/camera.h"
#include "runtime/analysis/picture/ground.h"
#include "runtime/analysis/picture/image.h"
#include "runtime/analysis/picture/posed_robot.h"

namespace runtime {

// What is to be seen in a picture.
struct Scene {
  const std::vector<robot::Link>& links;
  const PosedRobot& robot;
  const Ground& ground;
  const Camera& camera;
};

// Draws the scene into the square of `size` pixels whose upper left corner is at (left, 0).
void Render(const Scene& scene, int left, int size, Image& image);

}  // namespace runtime
