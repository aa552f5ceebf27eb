// Files that users name, read whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

namespace file {

struct Reading {
  std::string bytes;
  // Why they could not be read, with the remedy where there is one: "No such file or directory",
  // "it is a named pipe; name a regular file". Empty: they were.
  std::string problem;
};

// The first `limit` bytes of a file, links followed. Only regular files are read: the reader of a
// named pipe waits for a writer, perhaps forever, and a device may have no end.
Reading Read(const std::filesystem::path& file, size_t limit = std::numeric_limits<size_t>::max());

}  // namespace file
