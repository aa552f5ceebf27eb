#include "runtime/analysis/study/group_notes.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "runtime/base/user_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& file, const toml::source_region& place,
                       std::string_view what) {
  throw UserError(
      fmt::format("{}:{}:{}: {}", file.string(), place.begin.line, place.begin.column, what));
}

}  // namespace

std::map<std::string, std::string> ReadGroupNotes(const std::filesystem::path& study) {
  const std::filesystem::path file = study / kGroupNotesFile;
  std::map<std::string, std::string> notes;
  if (!std::filesystem::exists(file)) return notes;
  toml::table table;
  try {
    table = toml::parse(ReadText(file));
  } catch (const toml::parse_error& error) {
    Fail(file, error.source(), error.description());
  }
  for (const auto& [run, sentence] : table) {
    const auto text = sentence.value<std::string>();
    if (!text) {
      Fail(file, sentence.source(),
           R"(expected a sentence about a run: "EXPERIMENT/seed1" = "What it does.")");
    }
    notes.emplace(run.str(), *text);
  }
  return notes;
}

}  // namespace runtime
