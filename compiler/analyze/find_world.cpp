#include "compiler/analyze/find_world.h"

#include <algorithm>
#include <cctype>

#include "plugins/robot/placed_error.h"
#include "plugins/world/heightmap.h"

namespace compiler {
namespace {

// The word or the text in quotes that begins at a line and column of a file.
Span SpanAt(const SourceFile& file, uint32_t row, uint32_t column) {
  const uint32_t line = std::clamp(row, 1U, file.line_count());
  const std::string_view text = file.Line(line);
  const size_t begin = std::min<size_t>(std::max(column, 1U) - 1, text.size());
  const bool is_quoted = begin < text.size() && text[begin] == '"';
  const auto belongs = [&](char c) {
    return is_quoted ? c != '"'
                     : std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                           std::string_view("._-+").find(c) != std::string_view::npos;
  };
  size_t end = begin + (is_quoted ? 1 : 0);
  while (end < text.size() && belongs(text[end])) ++end;
  if (is_quoted && end < text.size()) ++end;
  const uint32_t start = file.LineStart(line);
  return {start + static_cast<uint32_t>(begin), start + static_cast<uint32_t>(end)};
}

}  // namespace

std::optional<world::WorldDescription> FindWorld(SyntaxTree& tree, const FileReader& read,
                                                 Sources& sources, Diagnostics& diagnostics) {
  if (!tree.world || !tree.world->file) return std::nullopt;
  WorldFile& named = *tree.world;
  const SourceFile& file = sources.files()[*named.file];
  const auto read_map = [&](const std::filesystem::path& path) {
    std::optional<std::string> bytes = read(path);
    if (bytes) {
      sources.Add(path.string(), world::TextOfHeights(*bytes));
      named.map_file = sources.files().size() - 1;
    }
    return bytes;
  };
  try {
    return world::ReadWorld(file.text(), file.path(), read_map);
  } catch (const robot::PlacedError& error) {
    Diagnostic diagnostic = MakeDiagnostic(
        code::kBadWorld, SpanAt(file, error.line(), error.column()), error.message());
    diagnostic.help = error.help();
    diagnostic.labels.push_back({named.path_span, "this reads it"});
    diagnostics.Add(std::move(diagnostic));
    tree.lost.has_anything = true;
    return std::nullopt;
  }
}

}  // namespace compiler
