#include "compiler/spec/manual.h"

#include <algorithm>

#include "base/text/trim.h"

namespace compiler {
std::string SectionOf(std::string_view manual, std::string_view heading) {
  const std::string line = "# " + std::string(heading) + "\n";
  const size_t at = manual.find(line);
  if (at == std::string_view::npos) return "";
  const size_t begin = at + line.size();
  size_t end = begin;
  do {
    end = manual.find("\n#", end + 1);
  } while (end != std::string_view::npos && manual.substr(end + 1).starts_with("#!"));
  return std::string(text::Trimmed(manual.substr(begin, end - begin)));
}

std::string MeaningOf(std::string_view manual, std::string_view function) {
  const std::string call = "`" + std::string(function) + "(";
  std::string meaning;
  while (!manual.empty()) {
    const std::string_view line = manual.substr(0, manual.find('\n'));
    manual.remove_prefix(std::min(line.size() + 1, manual.size()));
    const size_t column = line.find(" | ");
    if (!line.starts_with("| `") || column == std::string_view::npos) continue;
    if (line.substr(0, column).find(call) == std::string_view::npos) continue;
    std::string_view cell = line.substr(column + 3);
    cell = text::Trimmed(cell.substr(0, cell.rfind('|')));
    if (!meaning.empty()) meaning += "; ";
    std::ranges::copy_if(cell, std::back_inserter(meaning), [](char c) { return c != '`'; });
  }
  return meaning;
}

}  // namespace compiler
