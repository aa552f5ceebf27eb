// Where the stages of the parser leave their errors.
#pragma once

#include <set>
#include <utility>

#include "compiler/source/diagnostic.h"

namespace compiler {

// Remembers which lines have an error already: what the parser finds in them may be its
// consequence, and what they say is not known. After kMostErrors errors none is added: such a file
// is something else than a task.
class SyntaxReport {
 public:
  static constexpr size_t kMostErrors = 100;

  SyntaxReport(const SourceFile& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  void Add(Diagnostic diagnostic) {
    if (error_count_ == kMostErrors || IsIgnored(diagnostic.span)) return;
    ++error_count_;
    MarkFaulty(diagnostic.span);
    diagnostics_.Add(std::move(diagnostic));
  }
  // Nothing follows from it: what was meant, or a LostExpression, is in its place. The line is read
  // as if it had no error.
  void AddMended(Diagnostic diagnostic) {
    if (error_count_ == kMostErrors || IsIgnored(diagnostic.span)) return;
    ++error_count_;
    diagnostics_.Add(std::move(diagnostic));
  }
  // Adds it unless its line has an error already.
  void AddUnlessFaulty(Diagnostic diagnostic) {
    if (error_count_ < kMostErrors && !IsFaulty(diagnostic.span)) Add(std::move(diagnostic));
  }
  // For an error that is covered by one in another line.
  void MarkFaulty(Span span) { faulty_lines_.insert(source_.LineOf(span.begin)); }
  // No further errors are added in that line.
  void IgnoreLine(Span span) { ignored_lines_.insert(source_.LineOf(span.begin)); }
  bool IsFaulty(Span span) const { return faulty_lines_.contains(source_.LineOf(span.begin)); }
  bool has_errors() const { return error_count_ > 0; }
  const SourceFile& source() const { return source_; }

 private:
  bool IsIgnored(Span span) const { return ignored_lines_.contains(source_.LineOf(span.begin)); }

  const SourceFile& source_;
  Diagnostics& diagnostics_;
  std::set<uint32_t> faulty_lines_;
  std::set<uint32_t> ignored_lines_;
  size_t error_count_ = 0;
};

}  // namespace compiler
