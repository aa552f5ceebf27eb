#include "compiler/compose/compose.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/file/read.h"
#include "base/text/nearest_name.h"
#include "compiler/compose/extend.h"
#include "compiler/compose/library.h"
#include "compiler/syntax/parse.h"
#include "compiler/syntax/read_table.h"
#include "plugins/world/world_description.h"

namespace compiler {
namespace {

namespace fs = std::filesystem;

// One name for each file, however it is reached.
fs::path KeyOf(const fs::path& file) {
  std::error_code error;
  fs::path absolute = fs::absolute(file, error);
  return (error ? file : absolute).lexically_normal();
}

// Where a file names another.
struct Reference {
  fs::path file;  // relative to the folder where the compiler runs, or absolute
  std::string written;
  Span span;                          // of the path
  std::string_view reads;             // "imports", "extends" or "reads"
  fs::path beside{};                  // of the name of a library: the file that it might be instead
  std::string_view ending = ".task";  // of files of its kind
};

Reference ReferenceIn(const fs::path& file, const std::string& written, Span span,
                      std::string_view reads, std::string_view ending = ".task") {
  return {(file.parent_path() / written).lexically_normal(), written, span, reads, {}, ending};
}

Reference ImportIn(const fs::path& file, const ImportDeclaration& import) {
  return {ImportedFile(file, import.path), import.path, import.path_span, "imports",
          file.parent_path() / (import.path + ".task")};
}

class Composer {
 public:
  Composer(const FileReader& read, Sources& sources, Diagnostics& diagnostics)
      : read_(read), sources_(sources), diagnostics_(diagnostics) {}

  std::optional<SyntaxTree> Compose(const fs::path& file) {
    std::optional<std::string> text = read_(file);
    // Read again for the reason why it cannot be read.
    const SourceFile& source =
        sources_.Add(file.string(), text ? std::move(*text) : MustReadFromDisk(file));
    total_size_ = source.text().size();
    std::optional<SyntaxTree> tree = Parse(source, diagnostics_);
    if (!tree) return std::nullopt;
    if (IsLibrary(*tree)) {
      Report(code::kNotATask, {source.first_offset(), source.first_offset()},
             "this file is a library: it has no task", "begin it with `task NAME`, or import it");
      tree->lost.has_header = true;  // it may be meant for any robot
    }
    chain_.push_back({KeyOf(file), {}});
    tree = Complete(std::move(*tree), file);
    for (Declaration& declaration : tree->declarations)
      if (auto* table = std::get_if<TableDeclaration>(&declaration.node)) AddTable(table->source);
    if (tree->world && !AddWorld(*tree->world)) tree->lost.has_anything = true;
    return tree;
  }

 private:
  struct Link {
    fs::path key;
    Reference from;  // what led to this file; nothing for the first
  };

  // A header that could not be read is one nevertheless.
  static bool IsLibrary(const SyntaxTree& tree) { return !tree.task && !tree.lost.has_header; }

  // The tree of a file with all that it imports and extends.
  SyntaxTree Complete(SyntaxTree tree, const fs::path& file) {
    AddImports(tree, file);
    if (!tree.base) {
      if (tree.lost.has_header || !RejectOverrides(tree, diagnostics_)) return tree;
      return ExtendUnknown(std::move(tree));
    }
    const Reference reference = ReferenceIn(file, tree.base->path, tree.base->path_span, "extends");
    std::optional<SyntaxTree> base = ReadBase(reference);
    if (!base) return ExtendUnknown(std::move(tree));
    chain_.push_back({KeyOf(reference.file), reference});
    base = Complete(std::move(*base), reference.file);
    chain_.pop_back();
    return Extend(std::move(*base), std::move(tree), diagnostics_);
  }

  std::optional<SyntaxTree> ReadBase(const Reference& reference) {
    std::optional<SyntaxTree> base = Read(reference);
    if (!base || !IsLibrary(*base)) return base;
    Report(code::kNotATask, reference.span,
           fmt::format("`{}` is a library, not a task", reference.written),
           fmt::format("to use its functions: `import \"{}\"`", reference.written));
    return std::nullopt;
  }

  // Puts the declarations of the imported files in place of the imports.
  void AddImports(SyntaxTree& tree, const fs::path& file) {
    std::vector<Declaration> declarations;
    for (Declaration& declaration : tree.declarations) {
      const auto* import = std::get_if<ImportDeclaration>(&declaration.node);
      if (import == nullptr) {
        declarations.push_back(std::move(declaration));
        continue;
      }
      const Reference reference = ImportIn(file, *import);
      if (imported_.contains(KeyOf(reference.file)) && !IsInChain(reference)) continue;
      std::optional<SyntaxTree> library = Import(reference);
      if (!library) {
        tree.lost.has_imports = true;
        continue;
      }
      for (Declaration& imported : library->declarations) {
        imported.is_imported = true;
        declarations.push_back(std::move(imported));
      }
      std::ranges::move(library->allowances, std::back_inserter(tree.allowances));
      AddLost(std::move(library->lost), tree.lost);
    }
    tree.declarations = std::move(declarations);
  }

  std::optional<SyntaxTree> Import(const Reference& reference) {
    if (reference.file.extension() == ".csv") {
      Report(code::kNotALibrary, reference.span,
             fmt::format("`{}` is no library", reference.written),
             fmt::format("its numbers are read by `table NAME: TYPE = \"{}\"`", reference.written));
      return std::nullopt;
    }
    std::optional<SyntaxTree> library = Read(reference);
    if (!library) return std::nullopt;
    if (!IsLibrary(*library)) {
      Report(code::kNotALibrary, reference.span,
             fmt::format("`{}` is a task, not a library", reference.written),
             fmt::format("to build on it: `task NAME extends \"{}\"`", reference.written));
      return std::nullopt;
    }
    imported_.insert(KeyOf(reference.file));
    chain_.push_back({KeyOf(reference.file), reference});
    AddImports(*library, reference.file);
    chain_.pop_back();
    return library;
  }

  static bool IsNameOfWorld(const std::string& path) {
    return fs::path(path).extension() == world::kWorldEnding;
  }

  // What the file says is read later. Returns whether it is there.
  bool AddWorld(WorldFile& world) {
    if (world.path.empty()) return false;
    if (!IsNameOfWorld(world.path)) {
      Report(code::kBadWorld, world.path_span,
             fmt::format("`{}` is not the name of a world", world.path),
             fmt::format("the file of a world ends with `{}`", world::kWorldEnding));
      return false;
    }
    const fs::path folder = sources_.FileOf(world.path_span).path();
    const Reference reference =
        ReferenceIn(folder, world.path, world.path_span, "reads", world::kWorldEnding);
    const SourceFile* source = AddSource(reference);
    if (source == nullptr) return false;
    world.file = sources_.files().size() - 1;
    if (source->text().size() <= SourceFile::kMaxSize) return true;
    Report(code::kFileTooLarge, world.path_span,
           fmt::format("the file of the world is larger than {} bytes", SourceFile::kMaxSize),
           "heights of the ground have a file of their own");
    return false;
  }

  // Several tables may be of one file.
  void AddTable(TableSource& table) {
    if (table.path.empty()) return;
    if (IsNameOfWorld(table.path))
      return Report(code::kNotATable, table.path_span,
                    fmt::format("`{}` is the name of a world", table.path),
                    "the file of a table is CSV: call it `.csv`");
    const fs::path folder = sources_.FileOf(table.path_span).path();
    const Reference reference = ReferenceIn(folder, table.path, table.path_span, "reads", ".csv");
    const auto [known, is_new] = tables_.try_emplace(KeyOf(reference.file));
    if (is_new) {
      const SourceFile* source = AddSource(reference);
      if (source != nullptr) {
        Diagnostics found;
        known->second = ReadTable(*source, found);
        AddWithReason(found, reference);
      }
    }
    table.file = known->second;
  }

  // ---- Files ----

  std::optional<SyntaxTree> Read(const Reference& reference) {
    if (IsInChain(reference)) {
      ReportCircle(reference);
      return std::nullopt;
    }
    const SourceFile* source = AddSource(reference);
    if (source == nullptr) return std::nullopt;
    Diagnostics found;
    std::optional<SyntaxTree> tree = Parse(*source, found);
    AddWithReason(found, reference);
    return tree;
  }

  // Null, after a message, where the file cannot be read or would be too much.
  const SourceFile* AddSource(const Reference& reference) {
    if (!IsWithinLimits(reference)) return nullptr;
    std::optional<std::string> text = read_(reference.file);
    if (!text) {
      ReportMissing(reference);
      return nullptr;
    }
    total_size_ += text->size();
    if (total_size_ > kMaxTotalSize) {
      ReportLimit(reference,
                  fmt::format("the files of a task have more than {} bytes", kMaxTotalSize));
      return nullptr;
    }
    return &sources_.Add(reference.file.string(), std::move(*text));
  }

  void ReportMissing(const Reference& reference) {
    if (reference.reads == "imports" && IsLibraryName(reference.written))
      return Report(code::kMissingFile, reference.span,
                    fmt::format("there is no library `{}`", reference.written),
                    NearestLibrary(reference));
    const std::string name = reference.file.string();
    std::error_code error;
    if (!fs::exists(reference.file, error)) {
      return Report(code::kMissingFile, reference.span, fmt::format("there is no file `{}`", name),
                    NearestFile(reference));
    }
    Report(code::kMissingFile, reference.span, fmt::format("`{}` cannot be read", name),
           file::Read(reference.file, 0).problem);
  }

  // What was found in a file. The first error says why it is read.
  void AddWithReason(const Diagnostics& found, const Reference& reference) {
    bool is_first = true;
    for (Diagnostic diagnostic : found.list()) {
      if (std::exchange(is_first, false))
        diagnostic.labels.push_back({reference.span, fmt::format("this {} it", reference.reads)});
      diagnostics_.Add(std::move(diagnostic));
    }
  }

  bool IsInChain(const Reference& reference) const {
    return std::ranges::find(chain_, KeyOf(reference.file), &Link::key) != chain_.end();
  }

  void ReportCircle(const Reference& reference) {
    const auto first = std::ranges::find(chain_, KeyOf(reference.file), &Link::key);
    const bool is_itself = std::next(first) == chain_.end();
    Diagnostic diagnostic =
        MakeDiagnostic(code::kFileCircle, reference.span,
                       is_itself ? fmt::format("this file {} itself", reference.reads)
                                 : fmt::format("`{}` leads back to itself", reference.written));
    for (auto link = std::next(first); link != chain_.end(); ++link)
      diagnostic.labels.push_back(
          {link->from.span, fmt::format("which {} this", link->from.reads)});
    std::ranges::reverse(diagnostic.labels);
    diagnostic.help = "put what both need into a library of its own";
    diagnostics_.Add(std::move(diagnostic));
  }

  bool IsWithinLimits(const Reference& reference) {
    if (chain_.size() >= kMaxChain) {
      ReportLimit(reference, fmt::format("more than {} files import or extend one another in a row",
                                         kMaxChain));
      return false;
    }
    if (sources_.files().size() >= kMaxFiles) {
      ReportLimit(reference, fmt::format("the task consists of more than {} files", kMaxFiles));
      return false;
    }
    return true;
  }

  // Once: every further file would exceed it as well.
  void ReportLimit(const Reference& reference, const std::string& message) {
    if (std::exchange(has_reported_limit_, true)) return;
    Report(code::kTooManyFiles, reference.span, message,
           "put the functions that belong together into one file");
  }

  // "did you mean `std/gait`?"; or a file that is not meant as a library.
  static Help NearestLibrary(const Reference& reference) {
    const auto write = [&](std::string_view what, const std::string& path) -> Help {
      return {fmt::format(fmt::runtime(what), path), {{reference.span, '"' + path + '"'}}};
    };
    const std::vector<std::string> names = LibraryNames();
    if (const auto nearest = text::NearestName(reference.written, names))
      return write("did you mean `{}`?", *nearest);
    std::error_code error;
    if (fs::exists(reference.beside, error))
      return write("to import the file: `{}`", reference.written + ".task");
    return fmt::format("the libraries are {}; the path of a file ends with `.task`",
                       fmt::join(names, ", "));
  }

  // "did you mean `shaping.task`?", of the files of its kind in the folder where it should be.
  static Help NearestFile(const Reference& reference) {
    std::vector<std::string> names;
    std::error_code error;
    fs::path folder = reference.file.parent_path();
    if (folder.empty()) folder = ".";
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
      if (entry->path().extension() == reference.ending) names.push_back(entry->path().filename());
    std::ranges::sort(names);
    const auto nearest = text::NearestName(reference.file.filename().string(), names);
    if (!nearest) return "a path is relative to the folder of the file that contains it";
    const fs::path written = fs::path(reference.written).parent_path() / *nearest;
    return {fmt::format("did you mean `{}`?", written.string()),
            {{reference.span, '"' + written.string() + '"'}}};
  }

  void Report(std::string_view code, Span span, std::string message, Help help) {
    Diagnostic diagnostic = MakeDiagnostic(code, span, std::move(message));
    diagnostic.help = std::move(help);
    diagnostics_.Add(std::move(diagnostic));
  }

  const FileReader& read_;
  Sources& sources_;
  Diagnostics& diagnostics_;
  std::vector<Link> chain_;  // the files being read: each imports or extends the next
  std::set<fs::path> imported_;
  std::map<fs::path, std::optional<TableFile>> tables_;
  size_t total_size_ = 0;
  bool has_reported_limit_ = false;
};

}  // namespace

std::optional<SyntaxTree> Compose(const fs::path& file, const FileReader& read, Sources& sources,
                                  Diagnostics& diagnostics) {
  return Composer(read, sources, diagnostics).Compose(file);
}

}  // namespace compiler
