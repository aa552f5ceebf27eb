#include <algorithm>
#include <iterator>
#include <string_view>

#include "compiler/report/report.h"

namespace compiler {
namespace {

// A path as a relative or absolute URI.
std::string ToUri(const std::string& path) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    if (kPlain.find(c) != std::string_view::npos) {
      uri += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      uri += {'%', kHex[byte / 16], kHex[byte % 16]};
    }
  }
  return uri;
}

Json Region(const FileRange& place) {
  return {{"startLine", place.begin.line},
          {"startColumn", place.begin.column},
          {"endLine", place.end.line},
          {"endColumn", place.end.column}};
}

Json Location(const FileRange& place) {
  Json location;
  location["physicalLocation"]["artifactLocation"]["uri"] = ToUri(place.file);
  location["physicalLocation"]["region"] = Region(place);
  return location;
}

Json FixOf(const FileRange& place, const Fix& fix) {
  Json change;
  change["artifactLocation"]["uri"] = ToUri(place.file);
  change["replacements"] =
      Json::array({{{"deletedRegion", Region(place)}, {"insertedContent", {{"text", fix.text}}}}});
  return {{"artifactChanges", Json::array({change})}};
}

const char* Level(std::string_view code) { return code.starts_with('W') ? "warning" : "error"; }

// Every code that there is, so that a rule's index is its place in the table.
Json Rules() {
  Json rules = Json::array();
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    rules.push_back({{"id", kind.code},
                     {"shortDescription", {{"text", kind.title}}},
                     {"help", {{"text", "taskc explain " + std::string(kind.code)}}},
                     {"defaultConfiguration", {{"level", Level(kind.code)}}}});
  }
  return rules;
}

Json Result(const RunReport::Finding& finding) {
  const Diagnostic& diagnostic = finding.diagnostic;
  std::string message = diagnostic.message;
  if (!diagnostic.note.empty()) message += "\n" + diagnostic.note;
  if (!diagnostic.help.empty()) message += "\nhelp: " + diagnostic.help.text;
  const auto rule = std::ranges::find(kDiagnosticTable, diagnostic.code, &DiagnosticKind::code);
  Json result{{"ruleId", diagnostic.code},
              {"ruleIndex", std::distance(std::begin(kDiagnosticTable), rule)},
              {"level", Level(diagnostic.code)},
              {"message", {{"text", message}}},
              {"locations", Json::array({Location(finding.place)})}};
  for (size_t i = 0; i < finding.label_places.size(); ++i) {
    Json related = Location(finding.label_places[i]);
    related["message"]["text"] = diagnostic.labels[i].text;
    result["relatedLocations"].push_back(std::move(related));
  }
  for (size_t i = 0; i < finding.fix_places.size(); ++i) {
    result["fixes"].push_back(FixOf(finding.fix_places[i], diagnostic.help.fixes[i]));
  }
  return result;
}

// How the call went; it failed only where taskc could not do its work.
Json Invocation(const RunReport& report) {
  Json invocation{{"executionSuccessful", report.failures.empty()},
                  {"exitCode", report.exit_status}};
  for (const std::string& failure : report.failures) {
    invocation["toolExecutionNotifications"].push_back(
        {{"level", "error"}, {"message", {{"text", failure}}}});
  }
  return invocation;
}

}  // namespace

Json ToSarif(const RunReport& report) {
  Json run;
  run["tool"]["driver"] = {{"name", "taskc"}, {"version", TASKC_VERSION}, {"rules", Rules()}};
  run["invocations"] = Json::array({Invocation(report)});
  run["columnKind"] = "unicodeCodePoints";
  run["results"] = Json::array();
  for (const RunReport::Finding& finding : report.findings)
    run["results"].push_back(Result(finding));
  return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
          {"version", "2.1.0"},
          {"runs", Json::array({run})}};
}

}  // namespace compiler
