#include "compiler/language_server/document.h"

#include <algorithm>
#include <utility>

#include "base/text/trim.h"

namespace compiler {
namespace {

size_t BeginOfLine(std::string_view text, size_t offset) {
  const size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  return before == std::string_view::npos ? 0 : before + 1;
}

std::string_view LineFrom(std::string_view text, size_t begin) {
  return text.substr(begin, std::min(text.find_first_of("\r\n", begin), text.size()) - begin);
}

}  // namespace

Document::Document(std::string uri, std::filesystem::path path, std::string text, int64_t version,
                   PositionEncoding encoding)
    : uri_(std::move(uri)),
      path_(std::move(path)),
      text_(std::move(text)),
      version_(version),
      positions_(text_, encoding),
      tokens_(text_),
      names_(FindDeclaredNames(tokens_)) {}

const DeclaredName* Document::FindName(std::string_view name, uint32_t offset) const {
  const DeclaredName* found = nullptr;
  for (const DeclaredName& declared : names_) {
    const bool is_visible = (declared.visible.begin <= offset && offset <= declared.visible.end) ||
                            (declared.span.begin <= offset && offset <= declared.span.end);
    if (declared.name == name && is_visible && declared.kind != NameKind::kTest) {
      if (found == nullptr || found->is_override) found = &declared;
    }
  }
  return found;
}

std::optional<std::string> Document::RobotName() const {
  for (size_t i = 0; i + 1 < tokens_.size(); ++i) {
    const bool is_in_header = tokens_.Is(i, "for") && i >= 2 && !tokens_.BeginsLine(i) &&
                              (tokens_.Is(i - 2, "task") || tokens_.Is(i - 2, "extends"));
    if (is_in_header && tokens_.IsName(i + 1)) return std::string(tokens_.TextOf(i + 1));
  }
  return std::nullopt;
}

std::string DocAbove(std::string_view text, uint32_t offset) {
  std::vector<std::string_view> lines;
  for (size_t begin = BeginOfLine(text, offset); begin > 0;) {
    begin = BeginOfLine(text, begin - 1);
    std::string_view line = text::Trimmed(LineFrom(text, begin));
    if (line.starts_with("allow ")) continue;
    if (!line.starts_with("///") || line.starts_with("////")) break;
    line.remove_prefix(3);
    if (line.starts_with(' ')) line.remove_prefix(1);
    lines.push_back(line);
  }
  std::string doc;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) doc.append(*line).append("\n");
  if (!doc.empty()) doc.pop_back();
  return doc;
}

std::string CodeOfLine(std::string_view text, uint32_t offset) {
  std::string_view line = LineFrom(text, BeginOfLine(text, offset));
  const size_t comment = line.find("//");
  if (comment != std::string_view::npos && line.find('"') > comment) line = line.substr(0, comment);
  line = text::Trimmed(line);
  if (line.ends_with('{')) line.remove_suffix(1);
  return std::string(text::Trimmed(line));
}

}  // namespace compiler
