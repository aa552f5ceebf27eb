#include "compiler/language_server/workspace.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "compiler/analyze/find_robot.h"
#include "compiler/language_server/uri.h"

namespace compiler {
namespace {

// Of a project's files no more are looked at.
constexpr size_t kMostFiles = 1000;

std::filesystem::path Normal(const std::filesystem::path& path) {
  return std::filesystem::absolute(path).lexically_normal();
}

// A library is checked as part of a task that imports it, and that is not there.
constexpr const char* kLibraryUser = ".library-user.task";

bool IsLibrary(const std::string& text) {
  const TextTokens tokens(text);
  bool has_parts = false;
  for (const DeclaredName& name : FindDeclaredNames(tokens)) {
    if (name.kind == NameKind::kTask) return false;
    has_parts = has_parts || name.kind == NameKind::kFunction || name.kind == NameKind::kConst ||
                name.kind == NameKind::kSet || name.kind == NameKind::kTable;
  }
  return has_parts;
}

bool IsMadeWith(const Findings& findings, const std::filesystem::path& file) {
  return std::ranges::any_of(findings.analysis.sources.files(), [&](const SourceFile& source) {
    return Normal(source.path()) == file;
  });
}

}  // namespace

void Workspace::Open(const std::string& uri, std::string text, int64_t version) {
  const auto path = PathOfUri(uri);
  // A text that is not saved yet has no path: it stands in the current folder.
  Opened& opened = opened_[uri];
  opened.document = std::make_unique<const Document>(
      uri, path.value_or(std::filesystem::current_path() / "untitled.task"), std::move(text),
      version, encoding);
  Forget();
}

void Workspace::Change(const std::string& uri, std::string text, int64_t version) {
  const auto found = opened_.find(uri);
  if (found == opened_.end()) return;
  const std::filesystem::path path = found->second.document->path();
  found->second.document =
      std::make_unique<const Document>(uri, path, std::move(text), version, encoding);
  // Other files may be made with this one.
  for (auto& [other, opened] : opened_) opened.current = nullptr;
}

void Workspace::Close(const std::string& uri) {
  opened_.erase(uri);
  Forget();
}

void Workspace::Forget() {
  for (auto& [uri, opened] : opened_) opened.current = nullptr;
  found_robots_.clear();
}

const Document* Workspace::Find(const std::string& uri) const {
  const auto found = opened_.find(uri);
  return found == opened_.end() ? nullptr : found->second.document.get();
}

std::vector<const Document*> Workspace::documents() const {
  std::vector<const Document*> documents;
  for (const auto& [uri, opened] : opened_) documents.push_back(opened.document.get());
  return documents;
}

const Findings& Workspace::FindingsOf(const Document& document) {
  Opened& opened = opened_.at(document.uri());
  if (!opened.current) {
    opened.current = Analyze(document.path());
    const auto& tree = opened.current->analysis.tree;
    if (tree && tree->lost.is_empty()) opened.good = opened.current;
  }
  return *opened.current;
}

const Findings* Workspace::LastGood(const Document& document) {
  FindingsOf(document);
  return opened_.at(document.uri()).good.get();
}

const robot::RobotDescription* Workspace::RobotOf(const Document& document) {
  const auto name = document.RobotName();
  if (!name) {
    const Findings* good = LastGood(document);
    return good != nullptr && good->analysis.robot ? &*good->analysis.robot : nullptr;
  }
  const auto [found, is_new] = found_robots_.try_emplace(*name);
  if (is_new) {
    Diagnostics ignored;
    try {
      found->second = FindRobot({*name, {}}, document.path(), robots_, ignored);
    } catch (const robot::DescriptionError&) {
      // A robot whose file is wrong has nothing to offer; the analysis says so.
    }
  }
  return found->second ? &*found->second : nullptr;
}

std::vector<std::filesystem::path> Workspace::RobotFoldersOf(const Document& document) const {
  return robot::RobotFolders({document.path()}, robots_);
}

std::vector<std::shared_ptr<const Findings>> Workspace::Users(const std::filesystem::path& file) {
  std::vector<std::shared_ptr<const Findings>> users;
  std::set<std::filesystem::path> files = TaskFiles();
  files.erase(file);
  users.push_back(Analyze(file));
  for (const std::filesystem::path& other : files) {
    auto findings = Analyze(other);
    if (IsMadeWith(*findings, file)) users.push_back(std::move(findings));
  }
  return users;
}

std::set<std::filesystem::path> Workspace::TaskFiles() const {
  std::set<std::filesystem::path> files;
  for (const auto& [uri, opened] : opened_) files.insert(opened.document->path());
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    using Iterator = std::filesystem::recursive_directory_iterator;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    for (Iterator at(folder, options, error);
         !error && at != Iterator() && files.size() < kMostFiles; at.increment(error)) {
      if (at->path().filename().string().starts_with('.') && at->is_directory(error)) {
        at.disable_recursion_pending();
      } else if (at->path().extension() == ".task") {
        files.insert(Normal(at->path()));
      }
    }
  }
  return files;
}

std::shared_ptr<const Findings> Workspace::Analyze(
    const std::filesystem::path& file,
    const std::map<std::filesystem::path, std::string>& replaced) const {
  const FileReader read = [&](const std::filesystem::path& path) -> std::optional<std::string> {
    const std::filesystem::path normal = Normal(path);
    if (const auto found = replaced.find(normal); found != replaced.end()) return found->second;
    for (const auto& [uri, opened] : opened_) {
      if (opened.document->path() == normal) return opened.document->text();
    }
    return ReadFromDisk(path);
  };
  auto findings = std::make_shared<Findings>();
  findings->file = file;
  const std::string text = read(file).value_or("");
  try {
    if (IsLibrary(text)) {
      const std::filesystem::path user = file.parent_path() / kLibraryUser;
      const std::string use = "task library\nimport \"" + file.filename().string() + "\"\n";
      const FileReader with_user = [&](const std::filesystem::path& path) {
        return path == user ? std::optional(use) : read(path);
      };
      findings->analysis = compiler::Analyze(user, with_user, robots_, &findings->references);
    } else {
      findings->analysis = compiler::Analyze(file, read, robots_, &findings->references);
    }
  } catch (const std::exception& error) {
    // The robot's file is wrong, or this one is gone.
    findings->analysis.sources.Add(file.string(), text);
    findings->analysis.diagnostics.Add(MakeDiagnostic(code::kUnknownRobot, {0, 0}, error.what()));
  }
  for (const SourceFile& source : findings->analysis.sources.files()) {
    if (Normal(source.path()) == Normal(file)) findings->first_offset = source.first_offset();
  }
  return findings;
}

}  // namespace compiler
