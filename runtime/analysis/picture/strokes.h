// Straight lines that are drawn over a picture, as a diagram has them: nothing hides them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/analysis/picture/camera.h"
#include "runtime/analysis/picture/color.h"

namespace runtime {

struct Stroke {
  Eigen::Vector3d from, to;  // in the world [m]
  double width = 0;          // of the line in the picture, in parts of the picture's width
  uint32_t color = 0;        // 0xrrggbb
};

// What the strokes cover of a square picture, the later ones over the earlier ones.
class StrokeLayer {
 public:
  // `size`: of the picture [px]. A stroke that reaches behind the camera is left out.
  StrokeLayer(const Camera& camera, std::span<const Stroke> strokes, int size);

  // Of the pixel in this column and row, the top row first.
  Layer at(int x, int y) const {
    return pixels_.empty() ? Layer() : pixels_[static_cast<size_t>(y * size_ + x)];
  }

 private:
  void Draw(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
            const Light& light);

  int size_;
  std::vector<Layer> pixels_;  // [y][x]; empty without strokes
};

}  // namespace runtime
