// What one call of `taskc` found, as data for other programs: JSON of our own and SARIF.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/source/sources.h"

namespace compiler {

using Json = nlohmann::ordered_json;

// A stretch of a file; the end exclusive.
struct FileRange {
  std::string file;
  Position begin;
  Position end;
  Span bytes;  // the same, counted from the file's first byte
};
FileRange RangeOf(const Sources& sources, Span span);

struct RunReport {
  // A diagnostic whose spans have become places.
  struct Finding {
    Diagnostic diagnostic;
    FileRange place;
    std::vector<FileRange> label_places;  // one for each label
    std::vector<FileRange> fix_places;    // one for each fix
  };
  std::vector<Finding> findings;
  std::vector<std::string> failures;  // mistakes in the call and in taskc, about no place in a task
  Json tasks = Json::array();         // what became of each; the verbs say what that is
  int exit_status = 0;

  void Add(const Sources& sources, const Diagnostics& diagnostics);
};

// The format is described in docs/taskc.md.
Json ToJson(const RunReport& report);
// SARIF 2.1.0, the static analysis results interchange format of OASIS.
Json ToSarif(const RunReport& report);

// As it is written out. Bytes that are not UTF-8 become U+FFFD.
std::string ToText(const Json& json);

}  // namespace compiler
