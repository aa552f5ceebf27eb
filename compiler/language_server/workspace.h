// The files that the editor has open, and what the compiler makes of them.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/analyze/analyze.h"
#include "compiler/check/references.h"
#include "compiler/language_server/document.h"

namespace compiler {

// What the compiler found in a file and in those that it is made of. The sources are the texts of
// that moment.
struct Findings {
  Analysis analysis;
  References references;
  std::filesystem::path file;  // the one that was looked at
  uint32_t first_offset = 0;   // of that file among the sources

  // The reference whose name an offset of the file touches, or null.
  const Reference* FindReference(uint32_t offset) const {
    return references.Find(first_offset + offset);
  }
};

class Workspace {
 public:
  // `robots`: where to look for robots first; may be empty.
  explicit Workspace(std::filesystem::path robots) : robots_(std::move(robots)) {}

  PositionEncoding encoding = PositionEncoding::kUtf16;
  std::vector<std::filesystem::path> folders;  // of the editor's project

  void Open(const std::string& uri, std::string text, int64_t version);
  // A new version of the text; nothing happens where the file is not open.
  void Change(const std::string& uri, std::string text, int64_t version);
  void Close(const std::string& uri);
  // Something has changed on the disk.
  void Forget();

  const Document* Find(const std::string& uri) const;
  std::vector<const Document*> documents() const;

  // What is wrong and what is right with the open file as it is now.
  const Findings& FindingsOf(const Document& document);
  // The last version that had a syntax tree; null if there was none yet.
  const Findings* LastGood(const Document& document);
  // The robot that the text names now, or that of the last good version; null if there is none.
  const robot::RobotDescription* RobotOf(const Document& document);

  // Where the robots are that the document can name.
  std::vector<std::filesystem::path> RobotFoldersOf(const Document& document) const;

  // The compiler's findings in all files, open or not, that are made with this one; the file itself
  // first.
  std::vector<std::shared_ptr<const Findings>> Users(const std::filesystem::path& file);

  // Analyzes a file with some texts in the place of what is there.
  std::shared_ptr<const Findings> Analyze(
      const std::filesystem::path& file,
      const std::map<std::filesystem::path, std::string>& replaced = {}) const;

 private:
  struct Opened {
    std::unique_ptr<const Document> document;
    std::shared_ptr<const Findings> current;  // null: to be found
    std::shared_ptr<const Findings> good;
  };

  std::set<std::filesystem::path> TaskFiles() const;

  std::filesystem::path robots_;
  std::map<std::string, Opened> opened_;  // by URI
  std::map<std::string, std::optional<robot::RobotDescription>> found_robots_;
};

// The part of a source that belongs to a span, as an offset from the file's begin.
inline Span LocalSpan(const SourceFile& file, Span span) {
  return {span.begin - file.first_offset(), span.end - file.first_offset()};
}

}  // namespace compiler
