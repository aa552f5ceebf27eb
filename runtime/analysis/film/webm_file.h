// Encoded pictures as a WebM file. Its parts are elements, each an id, a size and its content
// (RFC 8794, RFC 9559); Debian has no library that writes them but Matroska's own, which is larger
// than this.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

class WebmFile {
 public:
  // Of one track of VP9, `size` pixels wide and high.
  WebmFile(int size, int pictures_per_second);

  // The next picture as the encoder gives it; the first is a key picture.
  void Add(std::string_view encoded, bool is_key);
  // The whole file.
  std::string Finish();

 private:
  // A key picture and those up to the next one.
  struct Cluster {
    int64_t time;  // [ms]
    std::string blocks;
  };
  int64_t TimeOf(int64_t picture) const { return picture * 1000 / pictures_per_second_; }
  std::string Info() const;
  std::string Tracks() const;

  int size_;
  int pictures_per_second_;
  int64_t pictures_ = 0;
  std::vector<Cluster> clusters_;
};

}  // namespace runtime
