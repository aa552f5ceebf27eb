#include "runtime/base/errand.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace runtime {
namespace {

constexpr size_t kLongestErrand = 1 << 16;  // bytes

// A message with room for the descriptors of an errand.
struct Packet {
  explicit Packet(void* bytes, size_t size) : part{bytes, size} {
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    header.msg_control = room.data();
    header.msg_controllen = room.size();
  }
  Packet(const Packet&) = delete;
  Packet& operator=(const Packet&) = delete;

  iovec part;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(Errand::kDescriptors * sizeof(int))> room{};
  msghdr header{};
};

// Each word ends with a zero.
std::vector<std::string> SplitWords(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\0'), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return words;
}

// Returns 0, or an errno.
int CopyAll(int file, int output) {
  char piece[65536];
  ssize_t size = 0;
  while ((size = read(file, piece, sizeof piece)) > 0) {
    for (ssize_t done = 0, count = 0; done < size; done += count) {
      count = write(output, piece + done, static_cast<size_t>(size - done));
      if (count <= 0) return errno;
    }
  }
  return size < 0 ? errno : 0;
}

bool IsPlugin(int file) {
  constexpr std::string_view kElf = "\177ELF";
  char begin[kElf.size()];
  return pread(file, begin, sizeof begin, 0) == sizeof begin &&
         std::string_view(begin, sizeof begin) == kElf;
}

// By the name that the file itself has, whatever link has led to it.
bool IsTable(int file) {
  std::error_code error;
  const auto name = std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", file), error);
  return name.extension() == ".csv";
}

}  // namespace

std::optional<Errand> ReceiveErrand(int socket) {
  std::string bytes(kLongestErrand, '\0');
  Packet packet(bytes.data(), bytes.size());
  ssize_t size = 0;
  do {
    size = recvmsg(socket, &packet.header, MSG_CMSG_CLOEXEC);
  } while (size < 0 && errno == EINTR);
  if (size <= 0) return std::nullopt;
  Errand errand;
  errand.words = SplitWords(std::string_view(bytes).substr(0, static_cast<size_t>(size)));
  const cmsghdr* attached = CMSG_FIRSTHDR(&packet.header);
  if (attached != nullptr && attached->cmsg_type == SCM_RIGHTS) {
    const size_t length =
        std::min(attached->cmsg_len - CMSG_LEN(0), Errand::kDescriptors * sizeof(int));
    std::memcpy(errand.descriptors.data(), CMSG_DATA(attached), length);
  }
  return errand;
}

bool SendErrand(int socket, const Errand& errand) {
  std::string bytes;
  for (const std::string& word : errand.words) bytes.append(word).push_back('\0');
  Packet packet(bytes.data(), bytes.size());
  cmsghdr* attached = CMSG_FIRSTHDR(&packet.header);
  attached->cmsg_level = SOL_SOCKET;
  attached->cmsg_type = SCM_RIGHTS;
  attached->cmsg_len = CMSG_LEN(sizeof errand.descriptors);
  std::memcpy(CMSG_DATA(attached), errand.descriptors.data(), sizeof errand.descriptors);
  return bytes.size() <= kLongestErrand && sendmsg(socket, &packet.header, MSG_NOSIGNAL) >= 0;
}

void CloseDescriptors(const Errand& errand) {
  for (const int descriptor : errand.descriptors) {
    if (descriptor >= 0) close(descriptor);
  }
}

// Whoever asks could read any file of ours if it were not looked at what it is.
int ReadForErrand(const Errand& errand) {
  const int file = open(errand.words[1].c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return errno;
  struct stat status {};
  if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return EINVAL;
  const bool is_plugin = errand.words[0] == kReadPlugin;
  if (is_plugin && !IsPlugin(file)) return ENOEXEC;
  if (!is_plugin && !IsTable(file)) return EACCES;
  return CopyAll(file, errand.descriptors[1]);
}

}  // namespace runtime
