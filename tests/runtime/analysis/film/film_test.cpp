#include "runtime/analysis/film/film.h"

#include <gtest/gtest.h>

#include "runtime/analysis/film/webm_file.h"
#include "tests/runtime/analysis/picture/standing_ball.h"

namespace runtime {
namespace {

// A ball that rolls along x at 1 m/s, a frame each 0.5 s.
Motion Rolling(int frames) {
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < frames; ++i) places.emplace_back(0.5 * i, 0, 0.1);
  return MotionThrough(places);
}

TEST(Film, LastsAsLongAsTheMotionAtItsSpeed) {
  const Motion motion = Rolling(5);  // of 2 s
  const std::vector<robot::Link> links = Ball(0.1);
  EXPECT_EQ(Film(motion, links, {}).picture_count(), 51);
  EXPECT_EQ(Film(motion, links, {.speed = 0.5}).picture_count(), 101);
  EXPECT_EQ(Film(motion, links, {.speed = 4}).picture_count(), 13);
  EXPECT_EQ(Film(motion, links, {.from = 1, .to = 1.2}).picture_count(), 6);
  EXPECT_EQ(Film(motion, links, {.from = 9}).picture_count(), 1);
}

TEST(Film, DrawsOpaquePicturesInTheirOrder) {
  const Motion motion = Rolling(3);
  const std::vector<robot::Link> links = Ball(0.1);
  const Film film(motion, links, {.size = 20, .speed = 5});
  std::vector<Image> pictures;
  film.Draw([&](const Image& picture) { pictures.push_back(picture); });
  ASSERT_EQ(static_cast<int>(pictures.size()), film.picture_count());
  for (const Image& picture : pictures) {
    EXPECT_EQ(picture.width, 20);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(picture.pixel(i, i)[3], 255);
    EXPECT_GT(picture.pixel(0, 19)[0], 0xd8);   // the floor
    EXPECT_LT(picture.pixel(10, 10)[0], 0xd0);  // the ball: the camera goes along
  }
  std::vector<Image> again;
  film.Draw([&](const Image& picture) { again.push_back(picture); });
  for (size_t i = 0; i < pictures.size(); ++i) EXPECT_EQ(pictures[i].bytes, again[i].bytes);
}

TEST(WebmFile, HoldsItsElementsAndItsPictures) {
  WebmFile file(480, 25);
  file.Add("first", true);
  file.Add("second", false);
  file.Add("third", true);
  const std::string bytes = file.Finish();
  EXPECT_EQ(bytes.substr(0, 4), "\x1A\x45\xDF\xA3");
  for (const char* part : {"webm", "V_VP9", "first", "second", "third"}) {
    EXPECT_NE(bytes.find(part), std::string::npos) << part;
  }
  // The second picture comes 40 ms after its cluster's key picture, and is none itself.
  const size_t second = bytes.find("second");
  EXPECT_EQ(bytes.substr(second - 4, 4), std::string("\x81\0\x28\0", 4));
  const size_t third = bytes.find("third");
  EXPECT_EQ(bytes.substr(third - 4, 4), std::string("\x81\0\0\x80", 4));
  // The whole rest is the segment.
  const size_t segment = bytes.find("\x18\x53\x80\x67");
  size_t size = 0;
  for (int i = 1; i < 8; ++i) {
    size = size << 8 | static_cast<uint8_t>(bytes[segment + 4 + static_cast<size_t>(i)]);
  }
  EXPECT_EQ(segment + 12 + size, bytes.size());
}

}  // namespace
}  // namespace runtime
