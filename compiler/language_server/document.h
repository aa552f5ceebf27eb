// A file that is open in the editor: its text, and what can be known of it without checking.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/language_server/declared_names.h"
#include "compiler/language_server/text_positions.h"
#include "compiler/language_server/text_tokens.h"

namespace compiler {

// One version of the text. It never changes, and stays where it is: its parts point into it.
class Document {
 public:
  Document(std::string uri, std::filesystem::path path, std::string text, int64_t version,
           PositionEncoding encoding);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const std::string& uri() const { return uri_; }
  const std::filesystem::path& path() const { return path_; }
  const std::string& text() const { return text_; }
  int64_t version() const { return version_; }
  const TextPositions& positions() const { return positions_; }
  const TextTokens& tokens() const { return tokens_; }
  const std::vector<DeclaredName>& names() const { return names_; }

  // The name that `name` stands for at `offset`; a dotted path that begins with it counts as well.
  const DeclaredName* FindName(std::string_view name, uint32_t offset) const;
  // The robot that the header names.
  std::optional<std::string> RobotName() const;

 private:
  std::string uri_;
  std::filesystem::path path_;
  std::string text_;
  int64_t version_;
  TextPositions positions_;
  TextTokens tokens_;
  std::vector<DeclaredName> names_;
};

// The `///` lines above the line of `offset`, without their slashes.
std::string DocAbove(std::string_view text, uint32_t offset);
// The line of `offset` from its first character on, without a comment and an opening brace at its
// end.
std::string CodeOfLine(std::string_view text, uint32_t offset);

}  // namespace compiler
