#include "compiler/language_server/navigation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "compiler/compose/library.h"
#include "compiler/language_server/cursor_place.h"
#include "compiler/language_server/uri.h"

namespace compiler {
namespace {

using protocol::Json;

// A place in a file, whichever sources it is part of.
struct FilePlace {
  std::filesystem::path file;
  Span span{};

  auto operator<=>(const FilePlace& other) const {
    return std::tie(file, span.begin) <=> std::tie(other.file, other.span.begin);
  }
  bool operator==(const FilePlace& other) const = default;
};

FilePlace PlaceOf(const Sources& sources, Span span) {
  const SourceFile& file = sources.FileOf(span);
  return {std::filesystem::absolute(file.path()).lexically_normal(), LocalSpan(file, span)};
}

// The reference at a place of the document as it is now.
const Reference* ReferenceAt(const Document& document, uint32_t offset, Workspace& workspace) {
  const Findings& findings = workspace.FindingsOf(document);
  const Reference* reference = findings.FindReference(offset);
  return reference != nullptr && reference->has_definition() ? reference : nullptr;
}

// What the text itself says, where the compiler has not come so far.
const DeclaredName* NameAt(const Document& document, uint32_t offset) {
  const PathAtCursor path = FindPath(document.tokens(), offset);
  if (path.path.empty()) return nullptr;
  const DeclaredName* name = document.FindName(path.path, offset);
  for (std::string whole = path.path; name == nullptr && whole.find('.') != std::string::npos;) {
    whole.resize(whole.rfind('.'));
    name = document.FindName(whole, offset);
  }
  return name;
}

// All uses of what is declared at a place, in all files that are made with it.
std::set<FilePlace> UsesOf(const FilePlace& definition, Workspace& workspace) {
  std::set<FilePlace> uses;
  for (const auto& findings : workspace.Users(definition.file)) {
    const Sources& sources = findings->analysis.sources;
    for (const auto& [place, reference] : findings->references.by_place()) {
      if (!reference.has_definition()) continue;
      if (PlaceOf(sources, reference.definition) == definition) {
        uses.insert(PlaceOf(sources, reference.use));
      }
    }
  }
  return uses;
}

std::optional<FilePlace> DefinitionAt(const Document& document, uint32_t offset,
                                      Workspace& workspace) {
  const Reference* reference = ReferenceAt(document, offset, workspace);
  if (reference == nullptr) return std::nullopt;
  return PlaceOf(workspace.FindingsOf(document).analysis.sources, reference->definition);
}

// The text of a file as the editor has it, or as it is on the disk.
std::string TextOf(const std::filesystem::path& file, const Workspace& workspace) {
  for (const Document* document : workspace.documents()) {
    if (document->path() == file) return document->text();
  }
  return ReadFromDisk(file).value_or("");
}

Json ToJson(const FilePlace& place, const Workspace& workspace) {
  const std::string text = TextOf(place.file, workspace);
  const TextPositions positions(text, workspace.encoding);
  return {{"uri", UriOfPath(place.file)}, {"range", protocol::ToJson(positions, place.span)}};
}

// The file that is imported, extended or read by the text at a place.
Json FileAt(const Document& document, uint32_t offset) {
  const TextTokens& tokens = document.tokens();
  for (size_t i = 1; i < tokens.size(); ++i) {
    const Span span = tokens[i].span;
    const bool is_here = tokens.KindOf(i) == LexedKind::kText && span.begin <= offset &&
                         offset <= span.end && span.end - span.begin >= 2;
    const bool is_file =
        tokens.Is(i - 1, "import") || tokens.Is(i - 1, "extends") || IsFileOfTable(tokens, i);
    if (!is_here || !is_file) continue;
    const std::string_view name = tokens.TextOf(i).substr(1, span.end - span.begin - 2);
    const std::filesystem::path file = tokens.Is(i - 1, "import")
                                           ? ImportedFile(document.path(), name)
                                           : document.path().parent_path() / name;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return nullptr;
    const Json begin = protocol::ToJson(TextPosition{});
    return {{"uri", UriOfPath(file)}, {"range", {{"start", begin}, {"end", begin}}}};
  }
  return nullptr;
}

// Every place where the text has the word, outside of comments and texts.
std::vector<Span> WordsLike(const DeclaredName& name, const Document& document) {
  std::vector<Span> spans;
  const TextTokens& tokens = document.tokens();
  for (size_t i = 0; i < tokens.size(); ++i) {
    const Span span = tokens[i].span;
    const bool is_visible =
        (name.visible.begin <= span.begin && span.end <= name.visible.end) || span == name.span;
    const bool is_member = i > 0 && tokens.Is(i - 1, ".");
    if (tokens.Is(i, name.name) && is_visible && !is_member) spans.push_back(span);
  }
  return spans;
}

bool IsWord(const std::string& name) {
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
         std::ranges::all_of(name, is_letter);
}

// The new texts of the files that have uses.
std::map<std::filesystem::path, std::string> Replaced(const std::set<FilePlace>& uses,
                                                      const std::string& name,
                                                      const Workspace& workspace) {
  std::map<std::filesystem::path, std::string> texts;
  for (auto use = uses.rbegin(); use != uses.rend(); ++use) {
    auto [text, is_new] = texts.try_emplace(use->file);
    if (is_new) text->second = TextOf(use->file, workspace);
    text->second.replace(use->span.begin, use->span.end - use->span.begin, name);
  }
  return texts;
}

// What would go wrong in the first file in which something would; empty where nothing does.
std::string MistakeOf(const std::map<std::filesystem::path, std::string>& texts,
                      const std::filesystem::path& definition, Workspace& workspace) {
  for (const auto& before : workspace.Users(definition)) {
    const auto after = workspace.Analyze(before->file, texts);
    if (after->analysis.diagnostics.error_count() <= before->analysis.diagnostics.error_count())
      continue;
    for (const Diagnostic& diagnostic : after->analysis.diagnostics.list()) {
      if (diagnostic.severity == Severity::kError) return diagnostic.message;
    }
  }
  return "";
}

}  // namespace

Json Definition(const Document& document, uint32_t offset, Workspace& workspace) {
  if (const Reference* reference = ReferenceAt(document, offset, workspace)) {
    return protocol::LocationOf(workspace.FindingsOf(document).analysis.sources,
                                reference->definition, workspace.encoding);
  }
  if (const DeclaredName* name = NameAt(document, offset)) {
    return {{"uri", document.uri()}, {"range", protocol::ToJson(document.positions(), name->span)}};
  }
  return FileAt(document, offset);
}

Json FindReferences(const Document& document, uint32_t offset, bool with_declaration,
                    Workspace& workspace) {
  Json places = Json::array();
  if (const auto definition = DefinitionAt(document, offset, workspace)) {
    for (const FilePlace& use : UsesOf(*definition, workspace)) {
      if (with_declaration || use != *definition) places.push_back(ToJson(use, workspace));
    }
  } else if (const DeclaredName* name = NameAt(document, offset)) {
    for (const Span span : WordsLike(*name, document)) {
      if (!with_declaration && span == name->span) continue;
      places.push_back(
          {{"uri", document.uri()}, {"range", protocol::ToJson(document.positions(), span)}});
    }
  }
  return places;
}

Json Highlights(const Document& document, uint32_t offset, Workspace& workspace) {
  Json highlights = Json::array();
  const Findings& findings = workspace.FindingsOf(document);
  const Reference* at = findings.FindReference(offset);
  if (at == nullptr) return highlights;
  for (const auto& [place, reference] : findings.references.by_place()) {
    const uint32_t first = findings.first_offset;
    const bool is_here =
        reference.use.begin >= first && reference.use.end <= first + document.text().size();
    const bool is_same = reference.kind == at->kind && reference.name == at->name &&
                         reference.definition == at->definition;
    if (!is_here || !is_same) continue;
    const Span span{reference.use.begin - first, reference.use.end - first};
    highlights.push_back({{"range", protocol::ToJson(document.positions(), span)}});
  }
  return highlights;
}

Json PrepareRename(const Document& document, uint32_t offset, Workspace& workspace) {
  const Reference* reference = ReferenceAt(document, offset, workspace);
  if (reference == nullptr) return nullptr;
  const Sources& sources = workspace.FindingsOf(document).analysis.sources;
  return protocol::LocationOf(sources, reference->use, workspace.encoding)["range"];
}

RenameResult Rename(const Document& document, uint32_t offset, const std::string& name,
                    Workspace& workspace) {
  const auto definition = DefinitionAt(document, offset, workspace);
  if (!definition) return {nullptr, "there is nothing here that can be renamed"};
  if (IsOfLibrary(definition->file) && document.path() != definition->file)
    return {nullptr, fmt::format("this belongs to the library `{}`, which other tasks use as well",
                                 definition->file.stem().string())};
  if (!IsWord(name)) {
    return {nullptr,
            fmt::format("`{}` is not a name: a name consists of letters, digits and underscores",
                        name)};
  }
  const std::set<FilePlace> uses = UsesOf(*definition, workspace);
  const std::string mistake =
      MistakeOf(Replaced(uses, name, workspace), definition->file, workspace);
  if (!mistake.empty()) return {nullptr, mistake};
  Json changes = Json::object();
  for (const FilePlace& use : uses) {
    const Json place = ToJson(use, workspace);
    changes[place["uri"].get<std::string>()].push_back(
        {{"range", place["range"]}, {"newText", name}});
  }
  return {{{"changes", changes}}, ""};
}

}  // namespace compiler
