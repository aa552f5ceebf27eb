// A file of timestamped messages: MCAP, version 0 (https://mcap.dev/spec), which Foxglove, Rerun
// and the tools of ROS open. Messages are JSON, in chunks compressed with zstd, with an index.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

class McapWriter {
 public:
  using Metadata = std::map<std::string, std::string>;

  McapWriter();

  // `schema` is a JSON schema of the messages. Channels come before all messages.
  uint16_t AddChannel(const std::string& topic, const std::string& schema_name,
                      const std::string& schema);
  void AddMetadata(const std::string& name, const Metadata& values);
  // `time` in nanoseconds; messages come in the order of time.
  void Write(uint16_t channel, uint64_t time, std::string_view json);

  // The whole file. Call once, at the end.
  std::string Finish();

 private:
  struct Place {
    uint64_t time;
    uint64_t offset;  // in the uncompressed chunk
  };
  struct Channel {
    uint32_t messages = 0;
    std::vector<Place> in_chunk;
  };

  void FinishChunk();
  // The index of each channel's messages in the chunk; returns where in the file they are.
  std::string AppendMessageIndexes();
  std::string Summary() const;

  std::string file_;
  std::vector<Channel> channels_;
  uint64_t messages_ = 0;
  uint64_t start_ = 0;  // of the first message and the last
  uint64_t end_ = 0;

  std::string chunk_;  // uncompressed
  bool is_chunk_without_messages_ = true;
  uint64_t chunk_start_ = 0;  // of its first message
  uint32_t chunks_ = 0;
  uint32_t metadata_ = 0;

  // Records of the summary.
  std::string schema_records_;
  std::string channel_records_;
  std::string chunk_indexes_;
  std::string metadata_indexes_;
};

}  // namespace runtime
