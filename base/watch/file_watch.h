// Waits for files to change.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace watch {

// Watches the folders of the files rather than the files: many editors write a new file and put it
// in the old one's place.
class FileWatch {
 public:
  // This and Watch() throw std::system_error where the system has no more watches to give.
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  // From now on these files count; they need not be there.
  void Watch(const std::set<std::filesystem::path>& files);

  // Waits until one of them has changed and there is quiet again. Nothing where `stop`, a file
  // descriptor, can be read from: then waiting is to end. Returns what has changed.
  std::optional<std::set<std::filesystem::path>> Wait(int stop);

 private:
  void Take(std::set<std::filesystem::path>& changed);

  int notify_ = -1;
  std::map<int, std::filesystem::path> folders_;  // by inotify's number
  std::set<std::filesystem::path> files_;
};

}  // namespace watch
