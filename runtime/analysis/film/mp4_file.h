// Encoded pictures as an MP4 file. Its parts are boxes, each a size, a type and its content
// (ISO/IEC 14496-12); how H.264 lies in them says ISO/IEC 14496-15. Debian has no small library
// that writes them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

class Mp4File {
 public:
  // Of one track of H.264, `size` pixels wide and high.
  Mp4File(int size, int pictures_per_second);

  // The next picture as the encoder gives it: units, each behind a start code of zeros and a one
  // (annex B of the standard). The first is a key picture, and has the sets of parameters with it.
  void Add(std::string_view encoded, bool is_key);
  // The whole file: what is known of the film comes before its pictures, so that it can be played
  // while it is read.
  std::string Finish();

 private:
  std::string MovieHeader() const;
  std::string TrackHeader() const;
  std::string MediaHeader() const;
  std::string SampleDescription() const;
  std::string SampleTable(uint32_t first) const;
  std::string Movie(uint32_t first) const;
  uint32_t duration() const;  // [1 / pictures_per_second s]

  int size_;
  int pictures_per_second_;
  std::string sequence_;                // set of parameters of the film
  std::string picture_;                 // of its pictures
  std::string pictures_;                // one after the other, each unit behind its length
  std::vector<uint32_t> sizes_;         // of the pictures [bytes]
  std::vector<uint32_t> key_pictures_;  // numbers, from 1
};

}  // namespace runtime
