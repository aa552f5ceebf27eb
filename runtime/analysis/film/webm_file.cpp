#include "runtime/analysis/film/webm_file.h"

#include <bit>

#include "runtime/analysis/film/big_endian.h"

namespace runtime {
namespace {

enum Id : uint32_t {
  kEbml = 0x1A45DFA3,
  kEbmlVersion = 0x4286,
  kEbmlReadVersion = 0x42F7,
  kEbmlMaxIdLength = 0x42F2,
  kEbmlMaxSizeLength = 0x42F3,
  kDocType = 0x4282,
  kDocTypeVersion = 0x4287,
  kDocTypeReadVersion = 0x4285,
  kSegment = 0x18538067,
  kInfo = 0x1549A966,
  kTimestampScale = 0x2AD7B1,
  kDuration = 0x4489,
  kMuxingApp = 0x4D80,
  kWritingApp = 0x5741,
  kTracks = 0x1654AE6B,
  kTrackEntry = 0xAE,
  kTrackNumber = 0xD7,
  kTrackUid = 0x73C5,
  kTrackType = 0x83,
  kCodecId = 0x86,
  kDefaultDuration = 0x23E383,
  kVideo = 0xE0,
  kPixelWidth = 0xB0,
  kPixelHeight = 0xBA,
  kCluster = 0x1F43B675,
  kTimestamp = 0xE7,
  kSimpleBlock = 0xA3,
  kCues = 0x1C53BB6B,
  kCuePoint = 0xBB,
  kCueTime = 0xB3,
  kCueTrackPositions = 0xB7,
  kCueTrack = 0xF7,
  kCueClusterPosition = 0xF1,
};

constexpr int64_t kTrack = 1;
constexpr size_t kLongestCluster = 30'000;  // [ms]; the times in a block have 16 bits

std::string IdBytes(Id id) {
  const int count = (std::bit_width(static_cast<uint32_t>(id)) + 7) / 8;
  return BigEndian(id, count);
}

// Always eight bytes long: the first bit of them that is set says so.
std::string SizeBytes(size_t size) { return BigEndian(uint64_t{1} << 56 | size, 8); }

std::string Element(Id id, std::string_view content) {
  return IdBytes(id) + SizeBytes(content.size()) + std::string(content);
}
std::string Number(Id id, int64_t value) {
  return Element(id, BigEndian(static_cast<uint64_t>(value), 8));
}
std::string Real(Id id, double value) {
  return Element(id, BigEndian(std::bit_cast<uint64_t>(value), 8));
}

std::string Header() {
  return Element(kEbml, Number(kEbmlVersion, 1) + Number(kEbmlReadVersion, 1) +
                            Number(kEbmlMaxIdLength, 4) + Number(kEbmlMaxSizeLength, 8) +
                            Element(kDocType, "webm") + Number(kDocTypeVersion, 4) +
                            Number(kDocTypeReadVersion, 2));
}

// Where in the segment the cluster of this time begins.
std::string CuePoint(int64_t time, size_t position) {
  return Element(kCuePoint,
                 Number(kCueTime, time) +
                     Element(kCueTrackPositions,
                             Number(kCueTrack, kTrack) +
                                 Number(kCueClusterPosition, static_cast<int64_t>(position))));
}

}  // namespace

WebmFile::WebmFile(int size, int pictures_per_second)
    : size_(size), pictures_per_second_(pictures_per_second) {}

void WebmFile::Add(std::string_view encoded, bool is_key) {
  const int64_t time = TimeOf(pictures_++);
  if (is_key || time - clusters_.back().time > static_cast<int64_t>(kLongestCluster)) {
    clusters_.push_back({time, Number(kTimestamp, time)});
  }
  Cluster& cluster = clusters_.back();
  std::string block = {static_cast<char>(0x80 | kTrack)};
  block += BigEndian(static_cast<uint64_t>(time - cluster.time), 2);
  block += static_cast<char>(is_key ? 0x80 : 0);
  block += encoded;
  cluster.blocks += Element(kSimpleBlock, block);
}

std::string WebmFile::Info() const {
  return Element(kInfo, Number(kTimestampScale, 1'000'000) +
                            Real(kDuration, static_cast<double>(TimeOf(pictures_))) +
                            Element(kMuxingApp, "taskc") + Element(kWritingApp, "taskc"));
}

std::string WebmFile::Tracks() const {
  return Element(
      kTracks,
      Element(kTrackEntry,
              Number(kTrackNumber, kTrack) + Number(kTrackUid, kTrack) + Number(kTrackType, 1) +
                  Element(kCodecId, "V_VP9") +
                  Number(kDefaultDuration, 1'000'000'000 / pictures_per_second_) +
                  Element(kVideo, Number(kPixelWidth, size_) + Number(kPixelHeight, size_))));
}

std::string WebmFile::Finish() {
  std::string segment = Info() + Tracks();
  std::string cues;
  for (const Cluster& cluster : clusters_) {
    cues += CuePoint(cluster.time, segment.size());
    segment += Element(kCluster, cluster.blocks);
  }
  segment += Element(kCues, cues);
  return Header() + Element(kSegment, segment);
}

}  // namespace runtime
