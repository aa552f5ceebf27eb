#include "runtime/learning/kept_spheres.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "plugins/cache/cache_folder.h"
#include "plugins/seal/seal.h"
#include "plugins/seal/sha256.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

// All that the spheres depend on.
std::string NameOf(const robot::NetDescription& net, uint64_t seed) {
  const std::string inputs =
      fmt::format("version {} units {} seed {} low {:a} high {:a}", kPackingVersion, net.units,
                  seed, fmt::join(net.low, " "), fmt::join(net.high, " "));
  return "net-" + seal::Sha256(inputs).substr(0, 32);
}

// The centres' elements and then the radius, sealed.
std::string ToBytes(const Spheres& spheres) {
  const size_t size = static_cast<size_t>(spheres.centres.size()) * sizeof(double);
  std::string bytes(size + sizeof(double), '\0');
  std::memcpy(bytes.data(), spheres.centres.data(), size);
  std::memcpy(bytes.data() + size, &spheres.radius, sizeof(double));
  return seal::Seal(std::move(bytes));
}

std::optional<Spheres> FromBytes(const std::string& bytes, const robot::NetDescription& net) {
  Spheres spheres;
  spheres.centres.resize(static_cast<Eigen::Index>(net.low.size()), net.units);
  const size_t size = static_cast<size_t>(spheres.centres.size()) * sizeof(double);
  if (seal::StateOf(bytes) != seal::State::kIntact || bytes.size() < size + sizeof(double)) {
    return std::nullopt;
  }
  std::memcpy(spheres.centres.data(), bytes.data(), size);
  std::memcpy(&spheres.radius, bytes.data() + size, sizeof(double));
  return spheres;
}

std::string ReadFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Nobody ever sees half a file. A cache that cannot be written to costs time only.
void Keep(const fs::path& path, const std::string& bytes) {
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  std::string temporary = path.parent_path() / "building-net-XXXXXX";
  const int descriptor = mkstemp(temporary.data());
  if (descriptor < 0) return;
  const bool written =
      write(descriptor, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size());
  close(descriptor);
  if (written) fs::rename(temporary, path, ignored);
  fs::remove(temporary, ignored);
}

}  // namespace

Spheres KeptSpheres(const robot::NetDescription& net, uint64_t seed) {
  const std::optional<fs::path> folder = cache::DefaultFolder();
  if (!folder) return PackSpheres(net, seed);
  const fs::path path = *folder / NameOf(net, seed);
  if (std::optional<Spheres> kept = FromBytes(ReadFile(path), net)) return *std::move(kept);
  Spheres spheres = PackSpheres(net, seed);
  Keep(path, ToBytes(spheres));
  return spheres;
}

}  // namespace runtime
