#include "runtime/analysis/film/film.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "runtime/analysis/film/mp4_file.h"
#include "runtime/analysis/film/webm_file.h"
#include "runtime/analysis/film/yuv.h"
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

// The content of the box of this type: its first four bytes are its size, the next four its type.
std::string BoxIn(const std::string& bytes, const std::string& type) {
  const size_t at = bytes.find(type);
  if (at == std::string::npos) return "";
  size_t size = 0;
  for (size_t i = at - 4; i < at; ++i) size = size << 8 | static_cast<uint8_t>(bytes[i]);
  return bytes.substr(at + 4, size - 8);
}

TEST(Mp4File, HoldsItsBoxesAndItsPictures) {
  using namespace std::string_literals;
  const std::string start = "\0\0\0\1"s;
  const std::string sequence = "gd\0(seq"s;
  const std::string parameters = "hpic"s;
  Mp4File file(480, 25);
  file.Add(start + sequence + start + parameters + start + "efirst", true);
  file.Add(start + "asecond", false);
  file.Add(start + sequence + start + parameters + start + "ethird", true);
  const std::string bytes = file.Finish();
  EXPECT_EQ(bytes.substr(4, 8), "ftypisom");
  EXPECT_EQ(BoxIn(bytes, "mdat"), "\0\0\0\6efirst"s + "\0\0\0\7asecond"s + "\0\0\0\6ethird"s);
  // Version, profile and level, lengths of four bytes, one set of each kind with its length.
  EXPECT_EQ(BoxIn(bytes, "avcC"), "\1d\0(\xFF\xE1\0\7"s + sequence + "\1\0\4"s + parameters);
  EXPECT_EQ(BoxIn(bytes, "stsz"), "\0\0\0\0\0\0\0\0\0\0\0\3\0\0\0\xA\0\0\0\xB\0\0\0\xA"s);
  EXPECT_EQ(BoxIn(bytes, "stss"), "\0\0\0\0\0\0\0\2\0\0\0\1\0\0\0\3"s);  // key pictures
  const std::string offset = BoxIn(bytes, "stco").substr(8);
  size_t first = 0;
  for (const char byte : offset) first = first << 8 | static_cast<uint8_t>(byte);
  EXPECT_EQ(bytes.substr(first, 5), "\0\0\0\6e"s);
  EXPECT_EQ(BoxIn(bytes, "mdhd").substr(12, 8), "\0\0\0\x19\0\0\0\3"s);  // 25 a second, 3 of them
}

TEST(Yuv, IsOfStudioRange) {
  Image picture(2, 2);
  const auto fill = [&](uint8_t r, uint8_t g, uint8_t b) {
    for (int i = 0; i < 4; ++i) {
      uint8_t* const pixel = picture.pixel(i % 2, i / 2);
      pixel[0] = r, pixel[1] = g, pixel[2] = b, pixel[3] = 255;
    }
  };
  uint8_t luma[4], blue, red;
  const YuvPlanes planes = {{luma, 2}, {&blue, 1}, {&red, 1}};
  fill(255, 255, 255);
  WriteYuv(picture, planes);
  EXPECT_EQ((std::array{int{luma[0]}, int{luma[3]}, int{blue}, int{red}}),
            (std::array{235, 235, 128, 128}));
  fill(0, 0, 0);
  WriteYuv(picture, planes);
  EXPECT_EQ((std::array{int{luma[0]}, int{blue}, int{red}}), (std::array{16, 128, 128}));
  fill(255, 0, 0);
  WriteYuv(picture, planes);
  EXPECT_EQ((std::array{int{luma[0]}, int{blue}, int{red}}), (std::array{81, 90, 240}));
}

}  // namespace
}  // namespace runtime
