#include "compiler/toolchain/share_folder.h"

#include <fmt/format.h>

#include <optional>

#include "compiler/source/diagnostic.h"
#include "compiler/toolchain/file_io.h"

namespace compiler {

std::filesystem::path ShareFolder() {
  std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "share/taskc";
}

std::string ReadShareFile(const std::filesystem::path& name) {
  std::filesystem::path file = ShareFolder() / name;
  std::optional<std::string> text = ReadWholeFile(file);
  if (text) return *text;
  throw CallError(
      fmt::format("cannot read `{}`, which belongs to taskc; reinstall taskc", file.string()));
}

}  // namespace compiler
