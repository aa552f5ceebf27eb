#include "runtime/live/server/control_socket.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

constexpr const char* kSocketName = "control.sock";
constexpr timeval kConnectTimeout = {5, 0};  // where more clients wait than the system lets wait

sockaddr_un AddressIn(const Descriptor& folder) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  fmt::format_to_n(address.sun_path, sizeof(address.sun_path) - 1, "/proc/self/fd/{}/{}",
                   folder.get(), kSocketName);
  return address;
}

// 0, or the error's number.
int Connect(const Descriptor& socket, const Descriptor& folder) {
  const sockaddr_un address = AddressIn(folder);
  const auto* generic = reinterpret_cast<const sockaddr*>(&address);
  return connect(socket.get(), generic, sizeof(address)) == 0 ? 0 : errno;
}

Descriptor NewSocket(int flags) { return Descriptor(socket(AF_UNIX, SOCK_STREAM | flags, 0)); }

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& what) {
  throw UserError(fmt::format("{}: {}", (path / kSocketName).string(), what));
}

// Makes room for a new socket.
void RemoveStale(const Descriptor& folder, const std::filesystem::path& path) {
  struct stat status {};
  if (fstatat(folder.get(), kSocketName, &status, AT_SYMLINK_NOFOLLOW) != 0) return;
  if (!S_ISSOCK(status.st_mode)) {
    Fail(path, "clients find the trainer by a socket of this name; move this file away");
  }
  // In the sandbox nobody can ask (EPERM). There the lock of the run's folder has to be enough.
  const int error = Connect(NewSocket(SOCK_CLOEXEC | SOCK_NONBLOCK), folder);
  if (error != ECONNREFUSED && error != EPERM) {
    Fail(path, "another trainer listens here; end it, or choose another folder with `--out`");
  }
  unlinkat(folder.get(), kSocketName, 0);
}

Descriptor Listen(const Descriptor& folder, const std::filesystem::path& path) {
  Descriptor socket = NewSocket(SOCK_CLOEXEC | SOCK_NONBLOCK);
  fchmod(socket.get(), S_IRUSR | S_IWUSR);  // before it has a name: nobody else ever gets in
  const sockaddr_un address = AddressIn(folder);
  if (bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
      listen(socket.get(), SOMAXCONN) != 0) {
    Fail(path, fmt::format("cannot listen for clients: {}", std::strerror(errno)));
  }
  return socket;
}

}  // namespace

Descriptor OpenRunFolder(const std::filesystem::path& folder) {
  Descriptor descriptor(open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!descriptor.is_open()) {
    throw UserError(
        fmt::format("{}: cannot open this folder: {}", folder.string(), std::strerror(errno)));
  }
  return descriptor;
}

Descriptor ConnectToTrainer(const Descriptor& folder) {
  Descriptor socket = NewSocket(SOCK_CLOEXEC);
  setsockopt(socket.get(), SOL_SOCKET, SO_SNDTIMEO, &kConnectTimeout, sizeof(kConnectTimeout));
  if (Connect(socket, folder) != 0) return {};
  return socket;
}

ControlSocket::ControlSocket(const Descriptor& folder, const std::filesystem::path& path)
    : folder_(folder) {
  RemoveStale(folder, path);
  listener_ = Listen(folder, path);
}

ControlSocket::~ControlSocket() { unlinkat(folder_.get(), kSocketName, 0); }

}  // namespace runtime
