#include "plugins/host/plugin.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <span>
#include <string>
#include <utility>

#include "base/file/read.h"
#include "base/seal/seal.h"
#include "plugins/host/elf_file.h"
#include "plugins/host/plugin_check.h"
#include "plugins/host/plugin_error.h"

namespace host {
namespace {

constexpr size_t kLargestFile = size_t{256} << 20;  // bytes; a compiled task has some ten thousand

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return number_; }
  bool ok() const { return number_ >= 0; }
  int Release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

[[noreturn]] void Refuse(PluginDefect defect, const std::filesystem::path& file,
                         const std::string& reason) {
  throw PluginError(defect, fmt::format("{}: {}", file.string(), reason));
}

[[noreturn]] void RefuseByErrno(const std::filesystem::path& file, const char* action) {
  Refuse(PluginDefect::kUnreadable, file, fmt::format("{}: {}", action, std::strerror(errno)));
}

std::string ReadWhole(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored) &&
      std::filesystem::file_size(file, ignored) > kLargestFile) {
    Refuse(PluginDefect::kUnreadable, file, "is too large for a compiled task");
  }
  file::Reading reading = file::Read(file, kLargestFile);
  if (!reading.problem.empty())
    Refuse(PluginDefect::kUnreadable, file, "cannot be read: " + reading.problem);
  return std::move(reading.bytes);
}

// Anonymous memory that holds `content` and that nothing can change any more.
int PrivateCopy(const std::filesystem::path& file, std::span<const std::byte> content) {
  Descriptor copy(memfd_create(file.filename().c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!copy.ok()) RefuseByErrno(file, "cannot be copied to memory");
  while (!content.empty()) {
    const ssize_t count = write(copy.get(), content.data(), content.size());
    if (count < 0) RefuseByErrno(file, "cannot be copied to memory");
    content = content.subspan(static_cast<size_t>(count));
  }
  if (fcntl(copy.get(), F_ADD_SEALS, F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW) != 0) {
    RefuseByErrno(file, "cannot be sealed in memory");
  }
  return copy.Release();
}

// Before the loader sees it: the code of a shared object runs already while it is loaded.
void CheckSeal(const std::filesystem::path& file, const std::string& bytes) {
  switch (seal::StateOf(bytes)) {
    case seal::State::kIntact:
      return;
    case seal::State::kBroken:
      Refuse(PluginDefect::kDamaged, file,
             "is damaged: it has changed since it was built; build the task with `taskc build`");
    case seal::State::kAbsent:
      Refuse(PluginDefect::kUnsealed, file,
             "has no seal: taskc has not built it, and its code is not run; build the task with "
             "`taskc build`, or, if you trust it, seal it with `taskc seal`");
  }
}

}  // namespace

Plugin::Plugin(const std::filesystem::path& file, const std::filesystem::path& name)
    : name_(name.empty() ? file : name) {
  const std::string bytes = ReadWhole(file);
  const std::span<const std::byte> content = std::as_bytes(std::span(bytes));
  if (const auto defect = ElfDefect(content)) {
    Refuse(PluginDefect::kNotATask, name_, *defect + "; build the task with `taskc build`");
  }
  CheckSeal(name_, bytes);
  copy_ = PrivateCopy(name_, content);
  try {
    Load();
  } catch (...) {
    Unload();
    throw;
  }
}

void Plugin::Load() {
  copy_path_ = fmt::format("/proc/{}/fd/{}", getpid(), copy_);
  handle_ = dlopen(copy_path_.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) {
    Refuse(PluginDefect::kDamaged, name_,
           fmt::format("cannot be loaded: {}; build the task with `taskc build`", dlerror()));
  }
  const auto entry = reinterpret_cast<taskc_plugin_entry>(dlsym(handle_, TASKC_PLUGIN_ENTRY));
  if (entry == nullptr) {
    Refuse(PluginDefect::kNotATask, name_,
           fmt::format("is not a compiled task: it does not export `{}`; build the task with "
                       "`taskc build`",
                       TASKC_PLUGIN_ENTRY));
  }
  table_ = entry();
  CheckPlugin(name_, table_);
}

void Plugin::Unload() {
  if (handle_ != nullptr) dlclose(handle_);
  // A library that does not go away when it is closed (one with unique symbols, say) would be found
  // again by its name: then the name must never be used again.
  if (void* still_loaded = dlopen(copy_path_.c_str(), RTLD_LAZY | RTLD_NOLOAD)) {
    dlclose(still_loaded);
  } else {
    close(copy_);
  }
}

Plugin::~Plugin() { Unload(); }

}  // namespace host
