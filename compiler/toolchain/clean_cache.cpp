#include "compiler/toolchain/clean_cache.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "base/cache/entry_name.h"
#include "base/seal/seal.h"
#include "compiler/toolchain/plugin_cache.h"

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

// Nothing here follows a link, and other processes may remove any file meanwhile.
fs::file_type TypeOf(const fs::directory_entry& entry) {
  std::error_code ignored;
  return entry.symlink_status(ignored).type();
}

uintmax_t SizeOfFile(const fs::directory_entry& file) {
  std::error_code error;
  const uintmax_t size = file.file_size(error);
  return error ? 0 : size;
}

// We make no folders in folders: a deeper one is not ours.
uintmax_t SizeOfFolder(const fs::path& folder) {
  uintmax_t size = 0;
  std::error_code ignored;
  for (const fs::directory_entry& part : fs::directory_iterator(folder, ignored)) {
    if (TypeOf(part) == fs::file_type::regular) size += SizeOfFile(part);
  }
  return size;
}

// Others also give libraries a hash for a name.
bool HasSeal(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string end(seal::kSize, '\0');
  stream.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  return stream.read(end.data(), static_cast<std::streamsize>(end.size())) && seal::IsSeal(end);
}

// The bytes that it takes; nothing where it is not ours to remove.
std::optional<uintmax_t> SizeOfOurs(const fs::directory_entry& entry, cache::EntryKind kind) {
  const fs::file_type type = TypeOf(entry);
  if (type == fs::file_type::directory && kind != cache::EntryKind::kFile) {
    return SizeOfFolder(entry.path());
  }
  if (type != fs::file_type::regular || kind == cache::EntryKind::kEvidence) return std::nullopt;
  if (kind == cache::EntryKind::kFile && !HasSeal(entry.path())) return std::nullopt;
  return SizeOfFile(entry);
}

}  // namespace

void NoteUse(const fs::path& plugin) {
  std::error_code ignored;  // a cache that cannot be written is still good to read
  fs::last_write_time(plugin, fs::file_time_type::clock::now(), ignored);
}

void CleanCache(const fs::path& folder, uintmax_t limit) {
  const fs::file_time_type now = fs::file_time_type::clock::now();
  std::vector<Entry> finished;
  uintmax_t size = 0;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const cache::EntryKind kind = cache::KindOf(entry.path().filename().string());
    if (kind == cache::EntryKind::kForeign) continue;
    const std::optional<uintmax_t> bytes = SizeOfOurs(entry, kind);
    std::error_code error;
    const fs::file_time_type used = entry.last_write_time(error);
    if (!bytes || error) continue;
    if (kind == cache::EntryKind::kUnfinished) {
      if (now - used > kLongestBuild) RemoveEntry(entry.path());
      continue;
    }
    size += *bytes;
    finished.push_back({entry.path(), *bytes, used});
  }
  std::ranges::sort(finished, {}, &Entry::used);
  for (const Entry& entry : finished) {
    if (size <= limit || now - entry.used < kLongestUse) return;
    if (RemoveEntry(entry.path)) size -= entry.size;
  }
}

}  // namespace compiler
