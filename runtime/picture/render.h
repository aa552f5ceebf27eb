#pragma once

#include <vector>

#include "runtime/picture/camera.h"
#include "runtime/picture/ground.h"
#include "runtime/picture/image.h"
#include "runtime/picture/posed_robot.h"

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
