#include "compiler/language_server/library_text.h"

#include <fmt/format.h>

#include "compiler/compose/library.h"
#include "compiler/source/file_reader.h"

namespace compiler {
namespace {

// The `//` lines at its top, in one paragraph.
std::string HeadOf(std::string_view text) {
  std::string head;
  while (text.starts_with("// ")) {
    const size_t end = std::min(text.find('\n'), text.size());
    head += fmt::format("{}{}", head.empty() ? "" : " ", text.substr(3, end - 3));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return head;
}

}  // namespace

std::optional<Span> ImportAt(const Document& document, uint32_t offset) {
  const TextTokens& tokens = document.tokens();
  for (size_t i = 1; i < tokens.size(); ++i) {
    const Span span = tokens[i].span;
    const bool is_here = tokens.KindOf(i) == LexedKind::kText && span.begin <= offset &&
                         offset <= span.end && span.end - span.begin >= 2;
    if (is_here && tokens.Is(i - 1, "import")) return span;
  }
  return std::nullopt;
}

std::string LibraryDoc(std::string_view library) {
  if (!IsLibraryName(library)) return "";
  const auto text = ReadFromDisk(ImportedFile("", library));
  if (!text) return "";
  std::string functions;
  for (const DeclaredName& name : FindDeclaredNames(TextTokens(*text)))
    if (name.kind == NameKind::kFunction) functions += fmt::format("{}{}\n", name.name, name.type);
  return fmt::format("{}\n\n```task\n{}```", HeadOf(*text), functions);
}

}  // namespace compiler
