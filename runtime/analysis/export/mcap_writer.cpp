#include "runtime/analysis/export/mcap_writer.h"

#include <zlib.h>

#include <span>

#include "runtime/analysis/export/little_endian.h"
#include "runtime/training/run/compression.h"

namespace runtime {
namespace {

constexpr std::string_view kMagic = "\x89MCAP0\r\n";
constexpr size_t kChunkSize = 1 << 20;
constexpr std::string_view kJson = "json";
constexpr std::string_view kJsonSchema = "jsonschema";
constexpr std::string_view kZstd = "zstd";
constexpr uint32_t kNoChecksum = 0;
constexpr uint64_t kNoOffsets = 0;

enum class Opcode : uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kDataEnd = 0x0F,
};

uint32_t Checksum(std::string_view bytes) {
  return static_cast<uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// The content of a record, field by field.
class Content {
 public:
  template <std::unsigned_integral Number>
  Content& Add(Number value) {
    AppendLittleEndian(value, bytes_);
    return *this;
  }
  Content& Add(const std::string& text) { return Add(std::string_view(text)); }
  Content& Add(std::string_view text) {
    AppendLittleEndian(static_cast<uint32_t>(text.size()), bytes_);
    bytes_ += text;
    return *this;
  }
  Content& Add(const McapWriter::Metadata& values) {
    Content pairs;
    for (const auto& [key, value] : values) pairs.Add(key).Add(value);
    return Add(pairs.bytes());
  }
  Content& AddRaw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

void Append(Opcode opcode, const Content& content, std::string& bytes) {
  AppendLittleEndian(static_cast<uint8_t>(opcode), bytes);
  AppendLittleEndian(uint64_t{content.bytes().size()}, bytes);
  bytes += content.bytes();
}

}  // namespace

McapWriter::McapWriter() : file_(kMagic) {
  constexpr std::string_view kProfile;
  constexpr std::string_view kLibrary = "taskc";
  Append(Opcode::kHeader, Content().Add(kProfile).Add(kLibrary), file_);
}

uint16_t McapWriter::AddChannel(const std::string& topic, const std::string& schema_name,
                                const std::string& schema) {
  const auto id = static_cast<uint16_t>(channels_.size());
  const auto schema_id = static_cast<uint16_t>(id + 1);  // 0 stands for no schema
  channels_.emplace_back();
  const size_t schemas_end = schema_records_.size();
  const size_t channels_end = channel_records_.size();
  Append(Opcode::kSchema, Content().Add(schema_id).Add(schema_name).Add(kJsonSchema).Add(schema),
         schema_records_);
  Append(Opcode::kChannel, Content().Add(id).Add(schema_id).Add(topic).Add(kJson).Add(Metadata()),
         channel_records_);
  chunk_.append(schema_records_, schemas_end);
  chunk_.append(channel_records_, channels_end);
  return id;
}

void McapWriter::AddMetadata(const std::string& name, const Metadata& values) {
  const uint64_t offset = file_.size();
  Append(Opcode::kMetadata, Content().Add(name).Add(values), file_);
  Append(Opcode::kMetadataIndex,
         Content().Add(offset).Add(uint64_t{file_.size() - offset}).Add(name), metadata_indexes_);
  ++metadata_;
}

void McapWriter::Write(uint16_t channel, uint64_t time, std::string_view json) {
  if (chunk_.size() > kChunkSize) FinishChunk();
  if (messages_++ == 0) start_ = time;
  if (is_chunk_without_messages_) chunk_start_ = time;
  is_chunk_without_messages_ = false;
  end_ = time;
  Channel& to = channels_[channel];
  to.in_chunk.push_back({time, chunk_.size()});
  Append(Opcode::kMessage,
         Content().Add(channel).Add(to.messages++).Add(time).Add(time).AddRaw(json), chunk_);
}

std::string McapWriter::Finish() {
  FinishChunk();
  Append(Opcode::kDataEnd, Content().Add(kNoChecksum), file_);
  std::string end = Summary();
  const uint64_t summary_start = file_.size();
  // The checksum is of all of the summary and of the footer up to itself.
  std::string footer;
  Append(Opcode::kFooter, Content().Add(summary_start).Add(kNoOffsets).Add(kNoChecksum), footer);
  end += footer.substr(0, footer.size() - sizeof(uint32_t));
  AppendLittleEndian(Checksum(end), end);
  return file_ + end + std::string(kMagic);
}

void McapWriter::FinishChunk() {
  if (chunk_.empty()) return;
  const uint64_t start = is_chunk_without_messages_ ? 0 : chunk_start_;
  const uint64_t end = is_chunk_without_messages_ ? 0 : end_;
  const uint64_t size = chunk_.size();
  const std::string compressed = Compress(std::as_bytes(std::span(chunk_)));
  const uint64_t offset = file_.size();
  Content chunk;
  chunk.Add(start).Add(end).Add(size).Add(Checksum(chunk_)).Add(kZstd);
  chunk.Add(uint64_t{compressed.size()}).AddRaw(compressed);
  Append(Opcode::kChunk, chunk, file_);
  const uint64_t chunk_end = file_.size();
  Content index;
  index.Add(start).Add(end).Add(offset).Add(chunk_end - offset).Add(AppendMessageIndexes());
  index.Add(file_.size() - chunk_end).Add(kZstd).Add(uint64_t{compressed.size()}).Add(size);
  Append(Opcode::kChunkIndex, index, chunk_indexes_);
  ++chunks_;
  chunk_.clear();
  is_chunk_without_messages_ = true;
}

std::string McapWriter::AppendMessageIndexes() {
  Content offsets;
  for (uint16_t id = 0; id < channels_.size(); ++id) {
    if (channels_[id].in_chunk.empty()) continue;
    Content places;
    for (const Place& place : channels_[id].in_chunk) places.Add(place.time).Add(place.offset);
    offsets.Add(id).Add(uint64_t{file_.size()});
    Append(Opcode::kMessageIndex, Content().Add(id).Add(places.bytes()), file_);
    channels_[id].in_chunk.clear();
  }
  return offsets.bytes();
}

std::string McapWriter::Summary() const {
  const auto count = static_cast<uint32_t>(channels_.size());
  constexpr uint32_t kAttachments = 0;
  Content counts;
  for (uint16_t id = 0; id < count; ++id) counts.Add(id).Add(uint64_t{channels_[id].messages});
  Content statistics;
  statistics.Add(messages_).Add(static_cast<uint16_t>(count)).Add(count).Add(kAttachments);
  statistics.Add(metadata_).Add(chunks_).Add(start_).Add(end_).Add(counts.bytes());
  std::string summary = schema_records_ + channel_records_;
  Append(Opcode::kStatistics, statistics, summary);
  return summary + chunk_indexes_ + metadata_indexes_;
}

}  // namespace runtime
