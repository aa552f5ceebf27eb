#include "compiler/source/source_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "compiler/source/diagnostic.h"
#include "compiler/source/utf8.h"

namespace compiler {
namespace {

[[noreturn]] void ThrowUnreadable(const std::string& path, const std::string& reason) {
  throw CallError("cannot read `" + path + "`: " + reason);
}

}  // namespace

Span Cover(Span first, Span second) {
  return {std::min(first.begin, second.begin), std::max(first.end, second.end)};
}

SourceFile::SourceFile(std::string path, std::string text)
    : path_(std::move(path)), text_(std::move(text)), line_starts_{0} {
  for (uint32_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(i + 1);
  }
}

SourceFile SourceFile::Read(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) ThrowUnreadable(path, "it is a folder");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) ThrowUnreadable(path, std::strerror(errno != 0 ? errno : EIO));
  std::string text(kMaxSize + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) ThrowUnreadable(path, std::strerror(errno != 0 ? errno : EIO));
  text.resize(static_cast<size_t>(file.gcount()));
  return SourceFile(path, std::move(text));
}

Position SourceFile::PositionOf(uint32_t offset) const {
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  Position position;
  position.line = static_cast<uint32_t>(next - line_starts_.begin());
  const std::string_view line = Line(position.line);
  const size_t end = std::min<size_t>(offset - LineStart(position.line), line.size());
  for (size_t i = 0; i < end;) {
    i += DecodeUtf8(line, i).length;
    if (i <= end) ++position.column;
  }
  return position;
}

std::string_view SourceFile::Line(uint32_t line) const {
  const uint32_t begin = LineStart(line);
  size_t end = line < line_count() ? line_starts_[line] - 1 : text_.size();
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

}  // namespace compiler
