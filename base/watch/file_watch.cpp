#include "base/watch/file_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>

namespace watch {
namespace {

// Editors write in several steps; so long nothing may happen before a change counts as complete.
constexpr int kQuietMilliseconds = 50;

[[noreturn]] void Fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

std::filesystem::path Normal(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).lexically_normal();
}

}  // namespace

FileWatch::FileWatch() : notify_(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
  if (notify_ < 0) Fail("cannot watch files");
}

FileWatch::~FileWatch() { close(notify_); }

void FileWatch::Watch(const std::set<std::filesystem::path>& files) {
  files_.clear();
  for (const std::filesystem::path& file : files) {
    const std::filesystem::path path = Normal(file);
    files_.insert(path);
    const std::filesystem::path folder = path.parent_path();
    // The same number again for a folder that is watched already.
    const int number = inotify_add_watch(notify_, folder.c_str(),
                                         IN_CLOSE_WRITE | IN_MOVED_TO | IN_DELETE | IN_MOVED_FROM);
    if (number < 0) Fail("cannot watch the folder `" + folder.string() + "`");
    folders_[number] = folder;
  }
}

std::optional<std::set<std::filesystem::path>> FileWatch::Wait(int stop) {
  std::set<std::filesystem::path> changed;
  while (true) {
    std::array<pollfd, 2> polled = {{{notify_, POLLIN, 0}, {stop, POLLIN, 0}}};
    const int ready = poll(polled.data(), polled.size(), changed.empty() ? -1 : kQuietMilliseconds);
    if (ready < 0 && errno != EINTR) Fail("cannot watch files");
    if (ready < 0) continue;
    if (polled[1].revents != 0) return std::nullopt;
    if (ready == 0) return changed;
    Take(changed);
  }
}

void FileWatch::Take(std::set<std::filesystem::path>& changed) {
  alignas(inotify_event) std::array<char, 16384> bytes;
  for (ssize_t size; (size = read(notify_, bytes.data(), bytes.size())) > 0;) {
    for (const char* at = bytes.data(); at < bytes.data() + size;) {
      const auto* event = reinterpret_cast<const inotify_event*>(at);
      at += sizeof(inotify_event) + event->len;
      const auto folder = folders_.find(event->wd);
      if (folder == folders_.end() || event->len == 0) continue;
      const std::filesystem::path file = folder->second / event->name;
      if (files_.contains(file)) changed.insert(file);
    }
  }
}

}  // namespace watch
