#include "runtime/analysis/export/tensorboard.h"

#include <array>
#include <cmath>

#include "runtime/analysis/export/event.pb.h"
#include "runtime/analysis/export/little_endian.h"

namespace runtime {
namespace {

constexpr std::array<uint32_t, 256> CrcTable() {
  std::array<uint32_t, 256> table{};
  for (uint32_t i = 0; i < table.size(); ++i) {
    uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = value >> 1 ^ (value & 1 ? 0x82F63B78 : 0);
    table[i] = value;
  }
  return table;
}

// Files that hold checksums of files that hold checksums are no trouble then.
uint32_t Masked(uint32_t crc) { return (crc >> 15 | crc << 17) + 0xA282EAD8; }

// A TFRecord: length, checksum of the length, bytes, checksum of the bytes.
void AppendRecord(const tensorboard::Event& event, std::string& file) {
  const std::string bytes = event.SerializeAsString();
  std::string length;
  AppendLittleEndian(uint64_t{bytes.size()}, length);
  file += length;
  AppendLittleEndian(Masked(Crc32c(length)), file);
  file += bytes;
  AppendLittleEndian(Masked(Crc32c(bytes)), file);
}

tensorboard::Event EventOf(const EpisodeTable& table, size_t index) {
  tensorboard::Event event;
  event.set_wall_time(table.end_times[index]);
  event.set_step(table.episodes[index].number);
  for (const EpisodeColumn& column : table.columns) {
    if (std::isnan(column.values[index])) continue;
    tensorboard::Summary::Value& value = *event.mutable_summary()->add_value();
    value.set_tag(column.name);
    value.set_simple_value(static_cast<float>(column.values[index]));
  }
  return event;
}

}  // namespace

uint32_t Crc32c(std::string_view bytes) {
  static constexpr std::array<uint32_t, 256> kTable = CrcTable();
  uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) crc = crc >> 8 ^ kTable[(crc ^ static_cast<uint8_t>(byte)) & 0xFF];
  return ~crc;
}

std::string TensorBoardEvents(const EpisodeTable& table) {
  std::string file;
  tensorboard::Event version;
  version.set_wall_time(table.end_times.empty() ? 0 : table.end_times.front());
  version.set_file_version("brain.Event:2");
  AppendRecord(version, file);
  for (size_t i = 0; i < table.episodes.size(); ++i) AppendRecord(EventOf(table, i), file);
  return file;
}

}  // namespace runtime
