#include "runtime/live/server/control_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr const char* kName = "control.json";
constexpr const char* kPartName = "control.json.part";

bool Write(const Descriptor& folder, const std::string& text) {
  unlinkat(folder.get(), kPartName, 0);  // of a trainer that was killed
  const Descriptor file(openat(folder.get(), kPartName,
                               O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                               S_IRUSR | S_IWUSR));
  if (!file.is_open()) return false;
  const ssize_t size = write(file.get(), text.data(), text.size());
  return size == static_cast<ssize_t>(text.size()) &&
         renameat(folder.get(), kPartName, folder.get(), kName) == 0;
}

}  // namespace

std::string NewToken() {
  std::array<unsigned char, 32> bytes;
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw UserError(fmt::format("the system provides no random numbers: {}", std::strerror(errno)));
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

ControlFile::ControlFile(const Descriptor& folder, uint16_t port, const std::string& token)
    : folder_(folder) {
  const nlohmann::ordered_json json = {
      {"url", fmt::format("http://127.0.0.1:{}/", port)}, {"token", token}, {"pid", getpid()}};
  if (Write(folder, json.dump(2) + "\n")) return;
  throw UserError(
      fmt::format("cannot write {} in the run's folder: {}", kName, std::strerror(errno)));
}

ControlFile::~ControlFile() { unlinkat(folder_.get(), kName, 0); }

}  // namespace runtime
