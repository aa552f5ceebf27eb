#include "compiler/language_server/published_diagnostics.h"

#include <fmt/format.h>

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
  if (!diagnostic.help.empty()) message += "\nhelp: " + diagnostic.help.text;
  return message;
}

std::string TitleOf(const Fix& fix, const Sources& sources) {
  std::string_view old = sources.FileOf(fix.span).TextOf(fix.span);
  if (fix.text.empty()) {
    old.remove_prefix(std::min(old.find_first_not_of(" \t"), old.size()));
    return fmt::format("Remove `{}`", old.substr(0, old.find_first_of("\r\n")));
  }
  return fmt::format("{} `{}`", old.empty() ? "Insert" : "Replace by", fix.text);
}

Json ToJson(const Fix& fix, const Sources& sources, PositionEncoding encoding) {
  return {{"title", TitleOf(fix, sources)},
          {"range", protocol::LocationOf(sources, fix.span, encoding)["range"]},
          {"newText", fix.text}};
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
  for (const Fix& fix : diagnostic.help.fixes) {
    json["data"]["fixes"].push_back(ToJson(fix, sources, encoding));
  }
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
