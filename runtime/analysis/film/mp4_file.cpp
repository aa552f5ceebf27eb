#include "runtime/analysis/film/mp4_file.h"

#include "runtime/analysis/film/big_endian.h"

namespace runtime {
namespace {

enum UnitType : uint8_t { kSequenceParameters = 7, kPictureParameters = 8 };

constexpr uint32_t kVideoTrack = 1;
constexpr uint32_t kOne = 0x00010000;  // in 16 bits of fraction

std::string U8(uint64_t value) { return BigEndian(value, 1); }
std::string U16(uint64_t value) { return BigEndian(value, 2); }
std::string U32(uint64_t value) { return BigEndian(value, 4); }
std::string Zeros(size_t count) { return std::string(count, '\0'); }

std::string Box(std::string_view type, std::string_view content) {
  return U32(8 + content.size()).append(type).append(content);
}
// One with a version, here always 0, and flags.
std::string FullBox(std::string_view type, uint32_t flags, std::string_view content) {
  return Box(type, U32(flags).append(content));
}

// Neither turned nor moved.
std::string IdentityMatrix() {
  return U32(kOne) + Zeros(12) + U32(kOne) + Zeros(12) + U32(0x40000000);
}

// What stands between the start codes, in their order.
std::vector<std::string_view> UnitsOf(std::string_view encoded) {
  using namespace std::string_view_literals;
  constexpr std::string_view kStart = "\0\0\1"sv;
  std::vector<std::string_view> units;
  size_t start = encoded.find(kStart);
  while (start != std::string_view::npos) {
    const size_t begin = start + kStart.size();
    start = encoded.find(kStart, begin);
    std::string_view unit = encoded.substr(begin, start - begin);
    // Zeros at the end belong to the next start code: no unit ends in one.
    unit = unit.substr(0, unit.find_last_not_of('\0') + 1);
    if (!unit.empty()) units.push_back(unit);
  }
  return units;
}

uint8_t TypeOf(std::string_view unit) { return static_cast<uint8_t>(unit[0]) & 0x1F; }

}  // namespace

Mp4File::Mp4File(int size, int pictures_per_second)
    : size_(size), pictures_per_second_(pictures_per_second) {}

void Mp4File::Add(std::string_view encoded, bool is_key) {
  const size_t before = pictures_.size();
  for (const std::string_view unit : UnitsOf(encoded)) {
    switch (TypeOf(unit)) {
      case kSequenceParameters:
        sequence_ = unit;
        break;
      case kPictureParameters:
        picture_ = unit;
        break;
      default:
        pictures_.append(U32(unit.size())).append(unit);
    }
  }
  sizes_.push_back(static_cast<uint32_t>(pictures_.size() - before));
  if (is_key) key_pictures_.push_back(static_cast<uint32_t>(sizes_.size()));
}

uint32_t Mp4File::duration() const { return static_cast<uint32_t>(sizes_.size()); }

std::string Mp4File::MovieHeader() const {
  return FullBox("mvhd", 0,
                 Zeros(8) + U32(static_cast<uint32_t>(pictures_per_second_)) + U32(duration()) +
                     U32(kOne) + U16(0x0100) + Zeros(10) + IdentityMatrix() + Zeros(24) +
                     U32(kVideoTrack + 1));
}

std::string Mp4File::TrackHeader() const {
  constexpr uint32_t kIsPlayed = 3;  // enabled, and part of the movie
  const auto pixels = static_cast<uint32_t>(size_) * kOne;
  return FullBox("tkhd", kIsPlayed,
                 Zeros(8) + U32(kVideoTrack) + Zeros(4) + U32(duration()) + Zeros(16) +
                     IdentityMatrix() + U32(pixels) + U32(pixels));
}

std::string Mp4File::MediaHeader() const {
  constexpr uint32_t kNoLanguage = 0x55C4;
  return FullBox("mdhd", 0,
                 Zeros(8) + U32(static_cast<uint32_t>(pictures_per_second_)) + U32(duration()) +
                     U16(kNoLanguage) + U16(0)) +
         FullBox("hdlr", 0, Zeros(4) + "vide" + Zeros(12) + "film" + Zeros(1));
}

std::string Mp4File::SampleDescription() const {
  const auto side = static_cast<uint32_t>(size_);
  constexpr uint32_t kResolution = 0x00480000;  // 72 dots per inch, as is written everywhere
  const std::string parameters =
      Box("avcC", U8(1) + sequence_.substr(1, 3) + U8(0xFC | 3) + U8(0xE0 | 1) +
                      U16(sequence_.size()) + sequence_ + U8(1) + U16(picture_.size()) + picture_);
  const std::string color = Box("colr", "nclx" + U16(6) + U16(6) + U16(6) + U8(0));  // BT.601
  const std::string entry =
      Box("avc1", Zeros(6) + U16(1) + Zeros(16) + U16(side) + U16(side) + U32(kResolution) +
                      U32(kResolution) + Zeros(4) + U16(1) + Zeros(32) + U16(24) + U16(0xFFFF) +
                      parameters + color);
  return FullBox("stsd", 0, U32(1) + entry);
}

// The pictures lie one after the other from byte `first` of the file on.
std::string Mp4File::SampleTable(uint32_t first) const {
  std::string sizes;
  for (const uint32_t size : sizes_) sizes += U32(size);
  std::string keys;
  for (const uint32_t key : key_pictures_) keys += U32(key);
  const uint32_t count = duration();
  return Box("stbl", SampleDescription() + FullBox("stts", 0, U32(1) + U32(count) + U32(1)) +
                         FullBox("stss", 0, U32(key_pictures_.size()) + keys) +
                         FullBox("stsc", 0, U32(1) + U32(1) + U32(count) + U32(1)) +
                         FullBox("stsz", 0, U32(0) + U32(count) + sizes) +
                         FullBox("stco", 0, U32(1) + U32(first)));
}

std::string Mp4File::Movie(uint32_t first) const {
  constexpr uint32_t kIsHere = 1;  // in this file
  const std::string data = Box("dinf", FullBox("dref", 0, U32(1) + FullBox("url ", kIsHere, "")));
  const std::string media = Box("minf", FullBox("vmhd", 1, Zeros(8)) + data + SampleTable(first));
  return Box("moov",
             MovieHeader() + Box("trak", TrackHeader() + Box("mdia", MediaHeader() + media)));
}

std::string Mp4File::Finish() {
  const std::string type = Box("ftyp", "isom" + U32(0x200) + "isomiso2avc1mp41");
  // As long as it will be, whatever number stands in it.
  const size_t first = type.size() + Movie(0).size() + Box("mdat", "").size();
  return type + Movie(static_cast<uint32_t>(first)) + Box("mdat", pictures_);
}

}  // namespace runtime
