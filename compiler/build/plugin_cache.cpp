#include "compiler/build/plugin_cache.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "compiler/build/file_io.h"
#include "compiler/hash/sha256.h"
#include "compiler/source/diagnostic.h"

namespace compiler {
namespace {

constexpr std::string_view kSealMark = "\ntaskc sha-256 ";
constexpr size_t kHashDigits = 64;

[[noreturn]] void FailToCreate(const std::filesystem::path& cache, const std::string& reason) {
  throw CallError(fmt::format(
      "cannot write to the cache folder `{}`: {}; choose another with --cache DIR or the "
      "environment variable TASKC_CACHE",
      cache.string(), reason));
}

std::string_view Environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

std::filesystem::path DefaultCacheFolder() {
  if (auto folder = Environment("TASKC_CACHE"); !folder.empty()) return folder;
  if (auto folder = Environment("XDG_CACHE_HOME"); !folder.empty()) {
    return std::filesystem::path(folder) / "taskc";
  }
  if (auto folder = Environment("HOME"); !folder.empty()) {
    return std::filesystem::path(folder) / ".cache" / "taskc";
  }
  throw CallError(
      "no place for the cache: HOME is not set; name a folder with --cache DIR or the environment "
      "variable TASKC_CACHE");
}

std::string Seal(std::string plugin) {
  std::string hash = Sha256(plugin);
  return std::move(plugin.append(kSealMark).append(hash));
}

bool IsIntact(const std::filesystem::path& file) {
  std::optional<std::string> sealed = ReadWholeFile(file);
  size_t seal_size = kSealMark.size() + kHashDigits;
  if (!sealed || sealed->size() < seal_size) return false;
  std::string_view plugin(*sealed);
  std::string_view seal = plugin.substr(plugin.size() - seal_size);
  plugin.remove_suffix(seal_size);
  return seal.starts_with(kSealMark) && seal.substr(kSealMark.size()) == Sha256(plugin);
}

BuildFolder::BuildFolder(const std::filesystem::path& cache) {
  std::error_code error;
  std::filesystem::create_directories(cache, error);
  if (error) FailToCreate(cache, error.message());
  std::string name = cache / "building-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) FailToCreate(cache, std::strerror(errno));
  path_ = name;
}

BuildFolder::~BuildFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

void BuildFolder::KeepAs(const std::filesystem::path& name) {
  std::error_code error;
  std::filesystem::remove_all(name, error);
  std::filesystem::rename(path_, name, error);
  if (error) FailToCreate(name, error.message());
  path_.clear();
}

}  // namespace compiler
