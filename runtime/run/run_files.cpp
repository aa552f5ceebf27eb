#include "runtime/run/run_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "plugins/file/read.h"
#include "plugins/seal/sha256.h"
#include "runtime/module/user_error.h"

namespace runtime {
namespace {

// The first 16 digits of the hash are enough to tell versions of a plugin apart.
std::string PluginName(const std::string& bytes) {
  return fmt::format("plugin-{}.so", seal::Sha256(bytes).substr(0, 16));
}

}  // namespace

std::error_code ReplaceFile(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::path part = file;
  part += fmt::format(".{}.part", ::getpid());
  errno = 0;
  std::ofstream out(part, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  if (out) {
    std::filesystem::rename(part, file, error);
  } else {
    error = std::error_code(errno != 0 ? errno : EIO, std::generic_category());
  }
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
                                      : "name another file with --output, in a folder that you may "
                                        "write"));
}

std::string ReadText(const std::filesystem::path& file) {
  file::Reading reading = file::Read(file);
  if (reading.problem.empty()) return std::move(reading.bytes);
  throw UserError(fmt::format("{}: cannot read this file: {}", file.string(), reading.problem));
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
  WriteFile(folder / name, bytes);
  return name;
}

std::filesystem::path FindKeptPlugin(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path file = folder / name;
  if (!std::filesystem::exists(file)) {
    throw UserError(fmt::format(
        "{}: the run's plugin is gone, and without it the run cannot go on; put it back, or start "
        "another run by `trainer train`",
        file.string()));
  }
  if (PluginName(ReadText(file)) != name) {
    throw UserError(fmt::format(
        "{}: the run's plugin was changed, so the run cannot go on with it; put the original back, "
        "or start another run by `trainer train`",
        file.string()));
  }
  return file;
}

robot::RobotDescription ReadKeptRobot(const std::filesystem::path& folder,
                                      const std::string& description) {
  const std::filesystem::path file = folder / "robot.toml";
  WriteFile(file, description);
  return robot::ReadRobot(file);
}

}  // namespace runtime
