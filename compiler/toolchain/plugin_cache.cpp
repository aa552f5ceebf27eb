#include "compiler/toolchain/plugin_cache.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>

#include "base/cache/cache_folder.h"
#include "base/seal/seal.h"
#include "compiler/source/diagnostic.h"
#include "compiler/toolchain/file_io.h"

namespace compiler {
namespace {

[[noreturn]] void FailToCreate(const std::filesystem::path& cache, const std::string& reason) {
  throw CallError(fmt::format(
      "cannot write to the cache folder `{}`: {}; choose another with --cache DIR or the "
      "environment variable TASKC_CACHE",
      cache.string(), reason));
}

}  // namespace

std::filesystem::path DefaultCacheFolder() {
  if (auto folder = cache::DefaultFolder()) return *folder;
  throw CallError(
      "no place for the cache: HOME is not set; name a folder with --cache DIR or the environment "
      "variable TASKC_CACHE");
}

bool IsIntact(const std::filesystem::path& file) {
  const std::optional<std::string> content = ReadWholeFile(file);
  return content && seal::StateOf(*content) == seal::State::kIntact;
}

bool RemoveEntry(const std::filesystem::path& entry) {
  std::error_code error;
  if (std::filesystem::is_directory(std::filesystem::symlink_status(entry, error))) {
    for (const auto& part : std::filesystem::directory_iterator(entry, error)) {
      std::error_code ignored;
      if (!std::filesystem::is_directory(part.symlink_status(ignored))) {
        std::filesystem::remove(part, ignored);
      }
    }
  }
  std::filesystem::remove(entry, error);
  return !error;
}

BuildFolder::BuildFolder(const std::filesystem::path& cache, const std::string& pattern) {
  std::error_code error;
  std::filesystem::create_directories(cache, error);
  if (error) FailToCreate(cache, error.message());
  std::string name = cache / pattern;
  if (mkdtemp(name.data()) == nullptr) FailToCreate(cache, std::strerror(errno));
  path_ = name;
}

BuildFolder::~BuildFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

void BuildFolder::KeepAs(const std::filesystem::path& name) {
  std::error_code error;
  RemoveEntry(name);
  std::filesystem::rename(path_, name, error);
  if (error) FailToCreate(name, error.message());
  path_.clear();
}

void BuildFolder::KeepFile(const std::filesystem::path& file,
                           const std::filesystem::path& name) const {
  std::error_code error;
  std::filesystem::rename(file, name, error);
  if (error) FailToCreate(name, error.message());
}

}  // namespace compiler
