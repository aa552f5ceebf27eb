#include "compiler/language_server/published_diagnostics.h"

#include <algorithm>
#include <cctype>

#include "compiler/language_server/uri.h"
#include "compiler/source/diagnostic_table.h"

namespace compiler {
namespace {

using protocol::Json;

constexpr int kError = 1;
constexpr int kWarning = 2;
constexpr int kUnnecessary = 1;  // a tag: shown faded

bool IsAboutUnused(std::string_view code) {
  return code == code::kUnusedLocal || code == code::kUnusedParam || code == code::kUnusedSensor;
}

// The heading "### E0101: unexpected token" has the anchor "e0101-unexpected-token".
std::string AnchorOf(const std::string& code) {
  std::string heading = code;
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    if (kind.code == code) heading.append(" ").append(kind.title);
  }
  std::string anchor;
  for (const char c : heading) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0 || c == '_' || c == '-')
      anchor += static_cast<char>(std::tolower(letter));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

std::string MessageOf(const Diagnostic& diagnostic) {
  std::string message = diagnostic.message;
  if (!diagnostic.note.empty()) message += " (" + diagnostic.note + ")";
  if (!diagnostic.help.empty()) message += "\nhelp: " + diagnostic.help;
  return message;
}

Json ToJson(const Diagnostic& diagnostic, const Sources& sources, const std::filesystem::path& page,
            PositionEncoding encoding) {
  Json json{{"range", protocol::LocationOf(sources, diagnostic.span, encoding)["range"]},
            {"severity", diagnostic.severity == Severity::kError ? kError : kWarning},
            {"code", diagnostic.code},
            {"source", "taskc"},
            {"message", MessageOf(diagnostic)}};
  if (!page.empty()) {
    json["codeDescription"] = {{"href", UriOfPath(page) + "#" + AnchorOf(diagnostic.code)}};
  }
  for (const Label& label : diagnostic.labels) {
    json["relatedInformation"].push_back(
        {{"location", protocol::LocationOf(sources, label.span, encoding)},
         {"message", label.text}});
  }
  if (IsAboutUnused(diagnostic.code)) json["tags"] = {kUnnecessary};
  return json;
}

}  // namespace

std::map<std::string, Json> DiagnosticsByUri(const Findings& findings,
                                             const std::filesystem::path& page,
                                             PositionEncoding encoding) {
  const Sources& sources = findings.analysis.sources;
  std::map<std::string, Json> diagnostics;
  diagnostics[UriOfPath(findings.file)] = Json::array();
  for (const Diagnostic& diagnostic : findings.analysis.diagnostics.list()) {
    const SourceFile& file = sources.FileOf(diagnostic.span);
    // A library is checked in a task that is made up: warnings are about the whole of that.
    const bool is_library = findings.first_offset > 0;
    if (is_library && (&file == &sources.main() || diagnostic.severity != Severity::kError)) {
      continue;
    }
    const std::string uri = UriOfPath(file.path());
    diagnostics[uri].push_back(ToJson(diagnostic, sources, page, encoding));
  }
  return diagnostics;
}

}  // namespace compiler
