#include "runtime/base/local_socket.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenTries{20};

[[noreturn]] void Throw(const std::filesystem::path& path, const std::string& what) {
  throw UserError(fmt::format("{}: {}", path.string(), what));
}

sockaddr_un AddressOf(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = path.string();
  if (name.size() >= sizeof address.sun_path) {
    Throw(path, fmt::format("the path of a socket has at most {} bytes: choose a shorter one",
                            sizeof address.sun_path - 1));
  }
  std::ranges::copy(name, address.sun_path);
  return address;
}

int MakeSocket(const std::filesystem::path& path) {
  const int descriptor = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) Throw(path, fmt::format("cannot make a socket: {}", std::strerror(errno)));
  return descriptor;
}

// 0, or why not.
int Connect(int descriptor, const sockaddr_un& address) {
  const auto* general = reinterpret_cast<const sockaddr*>(&address);
  return connect(descriptor, general, sizeof address) == 0 ? 0 : errno;
}

// A socket file that a program has left behind.
bool IsLeftBehind(const std::filesystem::path& path, const sockaddr_un& address) {
  std::error_code ignored;
  if (!std::filesystem::is_socket(path, ignored)) return false;
  const int probe = MakeSocket(path);
  const int error = Connect(probe, address);
  close(probe);
  return error == ECONNREFUSED;
}

}  // namespace

LocalSocket::LocalSocket(const std::filesystem::path& path, std::chrono::milliseconds patience)
    : descriptor_(-1) {
  const sockaddr_un address = AddressOf(path);
  const auto end = steady_clock::now() + patience;
  while (true) {
    const int descriptor = MakeSocket(path);
    const int error = Connect(descriptor, address);
    descriptor_ = descriptor;
    if (error == 0) return;
    close(descriptor);
    const bool may_come = error == ENOENT || error == ECONNREFUSED || error == EINTR;
    if (!may_come || steady_clock::now() >= end) {
      Throw(path, fmt::format("nobody answers at this socket: {}", std::strerror(error)));
    }
    std::this_thread::sleep_for(kBetweenTries);
  }
}

LocalSocket::LocalSocket(LocalSocket&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      unread_(std::move(other.unread_)),
      start_(other.start_) {}

LocalSocket::~LocalSocket() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool LocalSocket::Write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<size_t>(count));
  }
  return true;
}

void LocalSocket::Interrupt() const { shutdown(descriptor_, SHUT_RDWR); }

bool LocalSocket::Receive() {
  std::array<char, 65536> buffer;
  ssize_t count = 0;
  do {
    count = recv(descriptor_, buffer.data(), buffer.size(), 0);
  } while (count < 0 && errno == EINTR);
  if (count <= 0) return false;
  unread_.erase(0, std::exchange(start_, 0));
  unread_.append(buffer.data(), static_cast<size_t>(count));
  return true;
}

std::optional<std::string> LocalSocket::ReadLine() {
  size_t searched = start_;
  while (true) {
    const size_t end = unread_.find('\n', searched);
    if (end != std::string::npos) {
      std::string line = unread_.substr(start_, end - start_);
      start_ = end + 1;
      return line;
    }
    const size_t length = unread_.size() - start_;
    if (length > kLongestLine || !Receive()) return std::nullopt;
    searched = length;
  }
}

bool LocalSocket::Read(std::span<std::byte> bytes) {
  while (unread_.size() - start_ < bytes.size()) {
    if (!Receive()) return false;
  }
  std::memcpy(bytes.data(), unread_.data() + start_, bytes.size());
  start_ += bytes.size();
  return true;
}

LocalListener::LocalListener(std::filesystem::path path) : path_(std::move(path)), descriptor_(-1) {
  const sockaddr_un address = AddressOf(path_);
  if (IsLeftBehind(path_, address)) std::filesystem::remove(path_);
  descriptor_ = MakeSocket(path_);
  const auto* general = reinterpret_cast<const sockaddr*>(&address);
  constexpr int kMostWaiting = 16;
  if (bind(descriptor_, general, sizeof address) == 0 && listen(descriptor_, kMostWaiting) == 0)
    return;
  const int error = errno;
  close(descriptor_);
  Throw(path_, error == EADDRINUSE
                   ? "there is such a file already, or somebody listens there: choose another path"
                   : fmt::format("cannot listen there: {}", std::strerror(error)));
}

LocalListener::~LocalListener() {
  close(descriptor_);
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

std::optional<LocalSocket> LocalListener::Accept(std::chrono::milliseconds time) const {
  pollfd wait{.fd = descriptor_, .events = POLLIN, .revents = 0};
  if (poll(&wait, 1, static_cast<int>(time.count())) <= 0) return std::nullopt;
  const int descriptor = accept4(descriptor_, nullptr, nullptr, SOCK_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  return LocalSocket(descriptor);
}

}  // namespace runtime
