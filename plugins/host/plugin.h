// A compiled task in memory.
#pragma once

#include <taskc/plugin.h>

#include <filesystem>
#include <string>

namespace host {

// The loaded shared object of one task, unloaded with this object: everything that `table()` points
// to ends then.
//
// The dynamic loader tells files apart by name and inode. It would give the old code for a new file
// under a loaded name, and crash when a loaded file is overwritten in place. So what is loaded is a
// private copy in anonymous memory: the file itself may be rebuilt, moved or deleted at any time,
// and each Plugin holds what the file held when it was made. Debuggers find the copy under /proc.
class Plugin {
 public:
  // Throws PluginError, naming the file and the remedy, for a file that is missing, damaged, cut
  // off, without a seal (base/seal/seal.h), no compiled task, built for another version of the ABI,
  // or described by a senseless table. No code of a file without an intact seal is run.
  // `name`: what messages call it instead, where the file is nothing that the user knows.
  explicit Plugin(const std::filesystem::path& file, const std::filesystem::path& name = {});
  ~Plugin();
  Plugin(const Plugin&) = delete;
  Plugin& operator=(const Plugin&) = delete;

  // As messages call it.
  const std::filesystem::path& name() const { return name_; }
  const taskc_plugin& table() const { return *table_; }
  // A file with the bytes that were loaded, whatever has become of the original. It goes with this
  // object.
  std::filesystem::path copy() const { return copy_path_; }

 private:
  void Load();
  void Unload();

  std::filesystem::path name_;
  int copy_ = -1;          // descriptor of the private copy
  std::string copy_path_;  // under which the loader knows it
  void* handle_ = nullptr;
  const taskc_plugin* table_ = nullptr;
};

}  // namespace host
