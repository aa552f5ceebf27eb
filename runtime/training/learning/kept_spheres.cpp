#include "runtime/training/learning/kept_spheres.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <optional>
#include <string>

#include "base/cache/cache_folder.h"
#include "base/cache/entry_name.h"
#include "base/file/read.h"
#include "base/seal/seal.h"
#include "base/seal/sha256.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

// All that the spheres depend on.
std::string KeyOf(const robot::NetDescription& net, uint64_t seed) {
  const std::string inputs =
      fmt::format("version {} units {} seed {} low {:a} high {:a}", kPackingVersion, net.units,
                  seed, fmt::join(net.low, " "), fmt::join(net.high, " "));
  return seal::Sha256(inputs).substr(0, 32);
}

// The centers' elements and then the radius, sealed.
std::string ToBytes(const Spheres& spheres) {
  const size_t size = static_cast<size_t>(spheres.centers.size()) * sizeof(double);
  std::string bytes(size + sizeof(double), '\0');
  std::memcpy(bytes.data(), spheres.centers.data(), size);
  std::memcpy(bytes.data() + size, &spheres.radius, sizeof(double));
  return seal::Seal(std::move(bytes));
}

std::optional<Spheres> FromBytes(const std::string& bytes, const robot::NetDescription& net) {
  Spheres spheres;
  spheres.centers.resize(static_cast<Eigen::Index>(net.low.size()), net.units);
  const size_t size = static_cast<size_t>(spheres.centers.size()) * sizeof(double);
  if (seal::StateOf(bytes) != seal::State::kIntact || bytes.size() < size + sizeof(double)) {
    return std::nullopt;
  }
  std::memcpy(spheres.centers.data(), bytes.data(), size);
  std::memcpy(&spheres.radius, bytes.data() + size, sizeof(double));
  return spheres;
}

// Nobody ever sees half a file. A cache that cannot be written to costs time only.
void Keep(const fs::path& folder, const std::string& key, const std::string& bytes) {
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  std::string temporary = folder / cache::UnfinishedName("net", key);
  const int descriptor = mkstemp(temporary.data());
  if (descriptor < 0) return;
  const bool written =
      write(descriptor, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  close(descriptor);
  if (written) fs::rename(temporary, folder / cache::NetName(key), ignored);
  fs::remove(temporary, ignored);
}

}  // namespace

Spheres KeptSpheres(const robot::NetDescription& net, uint64_t seed) {
  const std::optional<fs::path> folder = cache::NetFolder();
  if (!folder) return PackSpheres(net, seed);
  const std::string key = KeyOf(net, seed);
  const std::string kept = file::Read(*folder / cache::NetName(key)).bytes;
  if (std::optional<Spheres> spheres = FromBytes(kept, net)) return *std::move(spheres);
  Spheres spheres = PackSpheres(net, seed);
  Keep(*folder, key, ToBytes(spheres));
  return spheres;
}

}  // namespace runtime
