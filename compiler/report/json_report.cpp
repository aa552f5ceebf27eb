#include <algorithm>

#include "compiler/report/report.h"

namespace compiler {
namespace {

void AddPlace(Json& json, const FileRange& place) {
  json["file"] = place.file;
  json["line"] = place.begin.line;
  json["column"] = place.begin.column;
  json["end_line"] = place.end.line;
  json["end_column"] = place.end.column;
  json["offset"] = place.bytes.begin;
  json["end_offset"] = place.bytes.end;
}

Json ToJson(const RunReport::Finding& finding) {
  const Diagnostic& diagnostic = finding.diagnostic;
  Json json;
  json["severity"] = diagnostic.severity == Severity::kError ? "error" : "warning";
  json["code"] = diagnostic.code;
  json["message"] = diagnostic.message;
  AddPlace(json, finding.place);
  json["note"] = diagnostic.note;
  json["help"] = diagnostic.help.text;
  json["fixes"] = Json::array();
  for (size_t i = 0; i < finding.fix_places.size(); ++i) {
    Json& fix = json["fixes"].emplace_back();
    AddPlace(fix, finding.fix_places[i]);
    fix["text"] = diagnostic.help.fixes[i].text;
  }
  json["labels"] = Json::array();
  for (size_t i = 0; i < finding.label_places.size(); ++i) {
    Json& label = json["labels"].emplace_back();
    AddPlace(label, finding.label_places[i]);
    label["text"] = diagnostic.labels[i].text;
  }
  return json;
}

}  // namespace

Json ToJson(const RunReport& report) {
  const auto errors = std::ranges::count_if(report.findings, [](const RunReport::Finding& finding) {
    return finding.diagnostic.severity == Severity::kError;
  });
  Json json;
  json["format"] = 1;
  json["taskc"] = TASKC_VERSION;
  json["exit_status"] = report.exit_status;
  json["errors"] = errors;
  json["warnings"] = static_cast<int64_t>(report.findings.size()) - errors;
  json["tasks"] = report.tasks;
  json["diagnostics"] = Json::array();
  for (const RunReport::Finding& finding : report.findings) {
    json["diagnostics"].push_back(ToJson(finding));
  }
  json["failures"] = report.failures;
  return json;
}

}  // namespace compiler
