#include "base/file/read.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>

namespace file {
namespace {

struct Descriptor {
  ~Descriptor() {
    if (number >= 0) close(number);
  }
  const int number;
};

std::string_view KindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a named pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

Reading Refusal(mode_t mode) {
  return {"", "it is " + std::string(KindOf(mode)) + "; name a regular file"};
}

// The file's size is only a hint: it may grow or shrink meanwhile.
Reading ReadUpTo(int descriptor, size_t limit) {
  Reading reading;
  char piece[65536];
  while (reading.bytes.size() < limit) {
    const size_t wanted = std::min(sizeof piece, limit - reading.bytes.size());
    const ssize_t size = read(descriptor, piece, wanted);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return {"", std::strerror(errno)};
    if (size == 0) break;
    reading.bytes.append(piece, static_cast<size_t>(size));
  }
  return reading;
}

}  // namespace

Reading Read(const std::filesystem::path& file, size_t limit) {
  struct stat status {};
  // O_NONBLOCK: or else the call itself would wait for the writer of a pipe.
  const Descriptor source{open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
  if (source.number < 0) {
    const int reason = errno;
    // A socket cannot be opened at all, and in a sandbox nothing that lies outside.
    if (stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
      return Refusal(status.st_mode);
    return {"", std::strerror(reason)};
  }
  if (fstat(source.number, &status) != 0) return {"", std::strerror(errno)};
  if (!S_ISREG(status.st_mode)) return Refusal(status.st_mode);
  return ReadUpTo(source.number, limit);
}

}  // namespace file
