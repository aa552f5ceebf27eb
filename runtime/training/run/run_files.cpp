#include "runtime/training/run/run_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/file/read.h"
#include "base/seal/sha256.h"
#include "runtime/training/run/record_error.h"

namespace runtime {
namespace {

constexpr std::string_view kPluginPrefix = "plugin-";

// The first 16 digits of the hash are enough to tell versions of a plugin apart.
std::string PluginName(const std::string& bytes) {
  return fmt::format("{}{}.so", kPluginPrefix, seal::Sha256(bytes).substr(0, 16));
}

std::error_code LastError() { return {errno, std::generic_category()}; }

// Returns when the disk has it: a name may outlive a power cut that the bytes behind it do not.
std::error_code WriteToDisk(const std::filesystem::path& file, std::string_view bytes) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return LastError();
  std::error_code error;
  while (!error && !bytes.empty()) {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    if (count >= 0) {
      bytes.remove_prefix(static_cast<size_t>(count));
    } else if (errno != EINTR) {
      error = LastError();
    }
  }
  if (!error && fsync(descriptor) != 0) error = LastError();
  if (close(descriptor) != 0 && !error) error = LastError();
  return error;
}

std::filesystem::path FolderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

// The names in it, as far as its file system can do that.
void SyncFolder(const std::filesystem::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

bool IsKeptPlugin(std::string_view name) { return name.starts_with(kPluginPrefix); }

std::error_code MoveFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (!error) SyncFolder(FolderOf(to));
  return error;
}

std::error_code ReplaceFile(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::path part = file;
  part += fmt::format(".{}.part", ::getpid());
  std::error_code error = WriteToDisk(part, bytes);
  if (!error) error = MoveFile(part, file);
  std::error_code ignored;
  if (error) std::filesystem::remove(part, ignored);
  return error;
}

void WriteFile(const std::filesystem::path& file, const std::string& bytes) {
  const std::error_code error = ReplaceFile(file, bytes);
  if (!error) return;
  throw UserError(
      fmt::format("{}: cannot write this file: {}; check the disk and the folder's permissions",
                  file.string(), error.message()));
}

void WriteOutput(const std::filesystem::path& file, std::string_view what,
                 const std::string& bytes) {
  const std::error_code error = ReplaceFile(file, bytes);
  if (!error) return;
  const bool is_full = error == std::errc::no_space_on_device || error.value() == EDQUOT;
  throw UserError(fmt::format("{}: cannot write {}: {}; {}", file.string(), what, error.message(),
                              is_full ? "free some space"
                                      : "name another file with --output, in a folder where you "
                                        "may write"));
}

std::string ReadText(const std::filesystem::path& file) {
  file::Reading reading = file::Read(file);
  if (reading.problem.empty()) return std::move(reading.bytes);
  throw UserError(fmt::format("{}: cannot read this file: {}", file.string(), reading.problem));
}

std::filesystem::path RunDatabaseFile(const std::filesystem::path& folder) {
  return folder / "run.db";
}

void MakeRunFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  throw UserError(fmt::format("{}: cannot make this folder: {}; name another one with --out",
                              folder.string(), error.message()));
}

std::string KeepPlugin(const std::filesystem::path& plugin, const std::filesystem::path& folder) {
  const std::string bytes = ReadText(plugin);
  MakeRunFolder(folder);
  const std::string name = PluginName(bytes);
  std::error_code ignored;
  if (std::filesystem::exists(folder / name, ignored) && ReadText(folder / name) == bytes) {
    SyncFolder(folder);  // whoever wrote it may have been killed before
  } else {
    WriteFile(folder / name, bytes);
  }
  return name;
}

std::string KeptPluginName(const std::filesystem::path& plugin) {
  return PluginName(ReadText(plugin));
}

std::filesystem::path FindKeptPlugin(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path file = folder / name;
  if (!std::filesystem::exists(file)) {
    throw RecordError(
        fmt::format("{}: the run's plugin is gone, and without it the run cannot continue; restore "
                    "it, or start "
                    "another run by `trainer train`",
                    file.string()));
  }
  if (PluginName(ReadText(file)) != name) {
    throw RecordError(
        fmt::format("{}: the run's plugin was changed, so the run cannot continue with it; restore "
                    "the original, "
                    "or start another run by `trainer train`",
                    file.string()));
  }
  return file;
}

robot::RobotDescription ReadKeptRobot(const std::filesystem::path& folder,
                                      const std::string& description) {
  if (description.empty()) return {};
  const std::filesystem::path file = folder / "robot.toml";
  WriteFile(file, description);
  return robot::ReadRobot(file);
}

}  // namespace runtime
