#include "compiler/source/file_reader.h"

#include <utility>

#include "base/file/read.h"
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

}  // namespace

std::optional<std::string> ReadFromDisk(const std::filesystem::path& file) {
  try {
    return MustReadFromDisk(file);
  } catch (const CallError&) {
    return std::nullopt;
  }
}

std::string MustReadFromDisk(const std::filesystem::path& file) {
  file::Reading reading = file::Read(file, SourceFile::kMaxTableSize + 1);
  if (reading.problem.empty()) return std::move(reading.bytes);
  throw CallError("cannot read `" + file.string() + "`: " + reading.problem + NearbyTask(file));
}

}  // namespace compiler
