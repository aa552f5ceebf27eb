#include "compiler/toolchain/file_io.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "base/file/read.h"
#include "compiler/source/diagnostic.h"

namespace compiler {
namespace {

[[noreturn]] void FailToWrite(const std::filesystem::path& file, int reason) {
  throw CallError(fmt::format("cannot write `{}`: {}", file.string(), std::strerror(reason)));
}

void WriteAndClose(std::FILE* file, const std::filesystem::path& name, std::string_view bytes) {
  errno = 0;
  bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  int reason = errno;
  bool is_closed = std::fclose(file) == 0;
  if (!is_written) FailToWrite(name, reason);
  if (!is_closed) FailToWrite(name, errno);
}

}  // namespace

std::optional<std::string> ReadWholeFile(const std::filesystem::path& file) {
  file::Reading reading = file::Read(file);
  return reading.problem.empty() ? std::optional(std::move(reading.bytes)) : std::nullopt;
}

void WriteWholeFile(const std::filesystem::path& file, std::string_view bytes) {
  std::FILE* output = std::fopen(file.c_str(), "wb");
  if (output == nullptr) FailToWrite(file, errno);
  WriteAndClose(output, file, bytes);
}

void ReplaceFile(const std::filesystem::path& file, std::string_view bytes) {
  std::error_code ignored;
  std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (std::filesystem::is_directory(status)) FailToWrite(file, EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return WriteWholeFile(file, bytes);
  }
  std::string temporary = file.string() + ".XXXXXX";
  int descriptor = mkstemp(temporary.data());
  if (descriptor < 0) FailToWrite(file, errno);
  try {
    WriteAndClose(fdopen(descriptor, "wb"), file, bytes);
    mode_t mask = umask(0);
    umask(mask);
    // mkstemp lets only the owner read.
    if (chmod(temporary.c_str(), 0666 & ~mask) != 0) FailToWrite(file, errno);
    if (std::rename(temporary.c_str(), file.c_str()) != 0) FailToWrite(file, errno);
  } catch (...) {
    unlink(temporary.c_str());
    throw;
  }
}

void RewriteFile(const std::filesystem::path& file, std::string_view bytes) {
  const std::filesystem::path target = std::filesystem::canonical(file);
  const auto permissions = std::filesystem::status(target).permissions();
  ReplaceFile(target, bytes);
  std::filesystem::permissions(target, permissions);
}

void CopyWholeFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::optional<std::string> bytes = ReadWholeFile(from);
  if (!bytes) throw CallError(fmt::format("cannot read `{}`", from.string()));
  ReplaceFile(to, *bytes);
}

}  // namespace compiler
