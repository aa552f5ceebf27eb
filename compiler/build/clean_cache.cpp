#include "compiler/build/clean_cache.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace compiler {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::hours kLongestBuild{1};
constexpr std::chrono::minutes kLongestUse{1};

struct Entry {
  fs::path path;
  uintmax_t size = 0;
  fs::file_time_type used;
};

// Of a file, or of all files in a folder; other processes may remove any of them meanwhile.
uintmax_t SizeOf(const fs::directory_entry& entry) {
  std::error_code ignored;
  if (!entry.is_directory(ignored)) {
    const uintmax_t size = entry.file_size(ignored);
    return ignored ? 0 : size;
  }
  uintmax_t size = 0;
  for (const fs::directory_entry& part : fs::directory_iterator(entry, ignored)) {
    size += SizeOf(part);
  }
  return size;
}

// "building-x7Qp2a", or "crawling-0123abcd.so.x7Qp2a": half of a file that was to be renamed.
bool IsUnfinished(const fs::path& path) {
  const std::string name = path.filename();
  const size_t ending = name.find(".so.");
  return name.starts_with("building-") || ending != std::string::npos;
}

std::vector<Entry> EntriesOf(const fs::path& cache) {
  std::vector<Entry> entries;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(cache, ignored)) {
    const fs::file_time_type used = entry.last_write_time(ignored);
    if (!ignored) entries.push_back({entry.path(), SizeOf(entry), used});
  }
  return entries;
}

bool Remove(const Entry& entry) {
  std::error_code error;
  fs::remove_all(entry.path, error);
  return !error;
}

}  // namespace

void NoteUse(const fs::path& plugin) {
  std::error_code ignored;  // a cache that cannot be written is still good to read
  fs::last_write_time(plugin, fs::file_time_type::clock::now(), ignored);
}

void CleanCache(const fs::path& cache, uintmax_t limit) {
  const fs::file_time_type now = fs::file_time_type::clock::now();
  std::vector<Entry> finished;
  uintmax_t size = 0;
  for (Entry& entry : EntriesOf(cache)) {
    if (IsUnfinished(entry.path)) {
      if (now - entry.used > kLongestBuild) Remove(entry);
      continue;
    }
    size += entry.size;
    finished.push_back(std::move(entry));
  }
  std::ranges::sort(finished, {}, &Entry::used);
  for (const Entry& entry : finished) {
    if (size <= limit || now - entry.used < kLongestUse) return;
    if (Remove(entry)) size -= entry.size;
  }
}

}  // namespace compiler
