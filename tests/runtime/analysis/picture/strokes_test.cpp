#include "runtime/analysis/picture/strokes.h"

#include <gtest/gtest.h>

namespace runtime {
namespace {

using Eigen::Vector3d;

constexpr int kPixels = 100;
constexpr uint32_t kRed = 0xff0000, kBlue = 0x0000ff;

// Looks along +y at the origin from ten meters before it; the picture shows `view` meters there.
const Camera kCamera{-10 * Vector3d::UnitY(), Vector3d::UnitX(), Vector3d::UnitZ(),
                     Vector3d::UnitY(), 10};
const double kView = kCamera.view();

double TotalCover(const StrokeLayer& layer) {
  double sum = 0;
  for (int i = 0; i < kPixels * kPixels; ++i) sum += layer.at(i % kPixels, i / kPixels).cover;
  return sum;
}

// From the left edge to the right one, through the middle.
TEST(StrokeLayer, DrawsALineAsWideAsItIsTold) {
  const std::vector<Stroke> strokes = {{{-kView, 0, 0}, {kView, 0, 0}, 0.05, kRed}};
  const StrokeLayer layer(kCamera, strokes, kPixels);
  EXPECT_NEAR(TotalCover(layer), kPixels * 0.05 * kPixels, 1);
  EXPECT_EQ(layer.at(3, kPixels / 2).cover, 1);
  EXPECT_EQ(layer.at(3, kPixels / 2).light, LightOf(kRed));
  EXPECT_EQ(layer.at(3, kPixels / 2 + 5).cover, 0);
}

// The upper left corner is above and to the left; what is farther away looks smaller.
TEST(StrokeLayer, DrawsPlacesWhereTheCameraSeesThem) {
  const Vector3d place(-0.25 * kView, 0, 0.25 * kView);
  for (const Vector3d& seen : {place, Vector3d(2 * place + 10 * Vector3d::UnitY())}) {
    const std::vector<Stroke> strokes = {{seen, seen, 0.04, kRed}};
    const StrokeLayer layer(kCamera, strokes, kPixels);
    EXPECT_EQ(layer.at(kPixels / 4, kPixels / 4).cover, 1);
    EXPECT_NEAR(TotalCover(layer), 3.14 * 4, 1.5);
  }
}

TEST(StrokeLayer, ALaterStrokeIsOverAnEarlierOne) {
  const std::vector<Stroke> strokes = {{{-1, 0, 0}, {1, 0, 0}, 0.05, kRed},
                                       {{0, 0, -1}, {0, 0, 1}, 0.05, kBlue}};
  const StrokeLayer layer(kCamera, strokes, kPixels);
  EXPECT_EQ(layer.at(kPixels / 2, kPixels / 2).light, LightOf(kBlue));
}

TEST(StrokeLayer, WhatIsOutsideOrBehindTheCameraIsNotDrawn) {
  const std::vector<Stroke> strokes = {{{9, 0, 9}, {9, 0, -9}, 0.05, kRed},
                                       {{0, 0, 0}, {0, -20, 0}, 0.05, kRed}};
  EXPECT_EQ(TotalCover(StrokeLayer(kCamera, strokes, kPixels)), 0);
  EXPECT_EQ(TotalCover(StrokeLayer(kCamera, {}, kPixels)), 0);
}

}  // namespace
}  // namespace runtime
