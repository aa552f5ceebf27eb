// What the compiler has to say about a task: errors and warnings as data, with places in the
// source.
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/source/diagnostic_table.h"
#include "compiler/source/sources.h"

namespace compiler {

enum class Severity { kError, kWarning };

// A further place that explains a diagnostic, e.g. "declared here"; perhaps in another file.
struct Label {
  Span span;
  std::string text;
};

// An edit that mends a mistake, in the file of its diagnostic: `text` takes the place of what
// stands in `span`. Where the span is empty something is inserted, where the text is, removed.
struct Fix {
  Span span;
  std::string text;
};

// What to do about a mistake: in words and, where these name what to write, as an edit.
struct Help {
  Help() = default;
  Help(std::string words, std::vector<Fix> edits = {})
      : text(std::move(words)), fixes(std::move(edits)) {}
  Help(const char* words) : text(words) {}

  bool empty() const { return text.empty(); }

  std::string text;
  std::vector<Fix> fixes;  // any one of them mends it
};

// "did you mean `name`?", in the place of what stands in `span`.
Help DidYouMean(Span span, const std::string& name);
// "write `text`", in the place of what stands in `span`.
Help WriteInstead(Span span, const std::string& text);

struct Diagnostic {
  Severity severity = Severity::kError;
  std::string code;     // "E0203": one per kind of mistake, listed in diagnostic_table.def
  std::string message;  // lower case, backticks around code, no final period
  Span span;            // what the carets point at
  std::string note;     // written after the carets; may be empty
  std::vector<Label> labels;
  Help help;  // the likely fix; may be empty
};

// A diagnostic of the kind `code` (one of compiler::code); "W..." is a warning, all else an error.
// The caller adds note, labels and help where they say something new.
Diagnostic MakeDiagnostic(std::string_view code, Span span, std::string message);

// Collects the diagnostics of a task.
class Diagnostics {
 public:
  // The code must be in the table. What has been said of this place already, as where one text is
  // checked for each statement that it replaces, is not said again.
  void Add(Diagnostic diagnostic);
  bool has_errors() const { return has_errors_; }
  size_t error_count() const;
  // Has something of this kind been said of this place?
  bool Has(std::string_view code, Span span) const;
  // In the order of their places in the source.
  const std::vector<Diagnostic>& list() const { return list_; }

 private:
  std::vector<Diagnostic> list_;
  bool has_errors_ = false;
};

// The diagnostics as a person reads them: file:line:column, the line, carets, help. Of escape
// sequences there are those of the colors only.
std::string Render(const Sources& sources, const Diagnostics& diagnostics, bool color);

// A mistake in the call rather than in the task: a missing file, an unwritable folder.
class CallError : public std::exception {
 public:
  explicit CallError(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

}  // namespace compiler
