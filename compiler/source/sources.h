// All files that a task is made of: its own, and those that it imports and extends.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "compiler/source/source_file.h"

namespace compiler {

// Spans count through the files in the order in which they were added, so a span also says which
// file it is of.
class Sources {
 public:
  Sources() = default;
  // A task of one file.
  Sources(std::string path, std::string text) { Add(std::move(path), std::move(text)); }

  // What is returned stays in its place as long as these sources.
  const SourceFile& Add(std::string path, std::string text);

  // In the order in which they were added: the task's own file first.
  const std::deque<SourceFile>& files() const { return files_; }
  const SourceFile& main() const { return files_.front(); }

  // What the text of a task is known by, as taskc/plugin.h says it. There must be a file.
  std::string Hash() const;

  // The number of a span's file in files(). A span after all files counts as the end of the last.
  // There must be a file.
  size_t IndexOf(Span span) const;
  const SourceFile& FileOf(Span span) const { return files_[IndexOf(span)]; }
  Position PositionOf(Span span) const { return FileOf(span).PositionOf(span.begin); }
  uint32_t LineOf(Span span) const { return PositionOf(span).line; }

 private:
  std::deque<SourceFile> files_;
};

}  // namespace compiler
