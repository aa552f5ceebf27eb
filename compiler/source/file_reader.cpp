#include "compiler/source/file_reader.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "compiler/source/diagnostic.h"
#include "compiler/source/source_file.h"

namespace compiler {
namespace {

// The task that was meant where its ending was left out.
std::string NearbyTask(const std::filesystem::path& file) {
  const std::filesystem::path task = file.string() + ".task";
  std::error_code error;
  if (!std::filesystem::is_regular_file(task, error)) return "";
  return "; did you mean `" + task.string() + "`?";
}

[[noreturn]] void ThrowUnreadable(const std::filesystem::path& file, const std::string& reason) {
  throw CallError("cannot read `" + file.string() + "`: " + reason + NearbyTask(file));
}

}  // namespace

std::optional<std::string> ReadFromDisk(const std::filesystem::path& file) {
  try {
    return MustReadFromDisk(file);
  } catch (const CallError&) {
    return std::nullopt;
  }
}

std::string MustReadFromDisk(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) ThrowUnreadable(file, "it is a folder");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) ThrowUnreadable(file, std::strerror(errno != 0 ? errno : EIO));
  std::string text(SourceFile::kMaxSize + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) ThrowUnreadable(file, std::strerror(errno != 0 ? errno : EIO));
  text.resize(static_cast<size_t>(stream.gcount()));
  return text;
}

}  // namespace compiler
