// Dependencies run one way: a folder includes only from itself and from the folders listed for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

using Folders = std::set<std::string>;

// Each folder of sources, and what it may include besides itself.
const std::map<std::string, Folders> kMayInclude = {
    {"base/text", {}},
    {"base/file", {}},
    {"base/seal", {}},
    {"base/watch", {}},
    {"base/cache", {}},
    {"base/command_line", {"base/text"}},
    {"base/variant", {}},

    {"plugins/abi", {}},
    {"plugins/host", {"base/file", "base/seal"}},
    {"plugins/robot", {"base/file", "base/text"}},
    {"plugins/world", {"base/text", "base/variant", "plugins/robot"}},

    {"libtaskc", {"base/text", "plugins/host"}},

    {"compiler/source", {"base/file", "base/seal", "base/text"}},
    {"compiler/syntax", {"base/text", "compiler/source"}},
    {"compiler/format", {"base/text", "compiler/source", "compiler/syntax"}},
    {"compiler/compose",
     {"base/file", "base/text", "compiler/source", "compiler/syntax", "plugins/world"}},
    {"compiler/check",
     {"base/text", "compiler/source", "compiler/syntax", "plugins/robot", "plugins/world"}},
    {"compiler/analyze",
     {"compiler/bounds", "compiler/check", "compiler/compose", "compiler/source", "compiler/syntax",
      "plugins/robot", "plugins/world"}},
    {"compiler/difference",
     {"base/variant", "compiler/analyze", "compiler/bounds", "compiler/check", "compiler/syntax",
      "plugins/robot"}},
    {"compiler/mend", {"compiler/analyze", "compiler/compose", "compiler/source"}},
    {"compiler/language_server",
     {"base/text", "compiler/analyze", "compiler/bounds", "compiler/check", "compiler/compose",
      "compiler/document", "compiler/format", "compiler/interpret", "compiler/source",
      "compiler/syntax", "plugins/robot", "plugins/world"}},
    {"compiler/spec",
     {"base/text", "compiler/check", "compiler/compose", "compiler/language_server",
      "compiler/report", "compiler/source", "compiler/syntax", "plugins/robot"}},
    {"compiler/bounds", {"base/variant", "compiler/check", "compiler/source"}},
    {"compiler/weights", {"compiler/check"}},
    {"compiler/emit", {"base/variant", "compiler/check", "compiler/source", "compiler/syntax"}},
    {"compiler/toolchain", {"base/cache", "base/file", "base/seal", "compiler/source"}},
    {"compiler/interpret", {"compiler/check"}},
    {"compiler/report", {"compiler/source"}},
    {"compiler/task_tests",
     {"base/cache", "compiler/check", "compiler/emit", "compiler/interpret", "compiler/source",
      "compiler/syntax", "compiler/toolchain", "plugins/host", "plugins/robot"}},
    {"compiler/document",
     {"compiler/analyze", "compiler/bounds", "compiler/check", "compiler/weights",
      "compiler/report", "compiler/source", "compiler/syntax", "plugins/robot"}},
    {"compiler/driver",
     {"base/command_line", "base/file",           "base/seal",          "base/text",
      "base/watch",        "compiler/analyze",    "compiler/bounds",    "compiler/difference",
      "compiler/document", "compiler/emit",       "compiler/format",    "compiler/language_server",
      "compiler/mend",     "compiler/report",     "compiler/source",    "compiler/spec",
      "compiler/syntax",   "compiler/task_tests", "compiler/toolchain", "plugins/robot"}},

    {"runtime/base", {"base/file", "base/text"}},
    {"runtime/core/module", {"base/variant", "plugins/robot", "runtime/base"}},
    {"runtime/core/shape", {"plugins/robot", "runtime/base"}},
    {"runtime/core/task",
     {"base/variant", "plugins/host", "plugins/robot", "plugins/world", "runtime/base",
      "runtime/core/module"}},
    {"runtime/core/agent", {"base/file", "runtime/base", "runtime/core/module"}},
    {"runtime/training/learning",
     {"base/cache", "base/file", "base/seal", "plugins/robot", "runtime/base",
      "runtime/core/module"}},
    {"runtime/training/environment",
     {"plugins/robot", "runtime/base", "runtime/core/module", "runtime/core/task"}},
    {"runtime/training/simulation",
     {"plugins/robot", "plugins/world", "runtime/base", "runtime/core/module", "runtime/core/shape",
      "runtime/core/task", "runtime/training/environment"}},
    {"runtime/training/signal",
     {"base/file", "base/text", "plugins/robot", "runtime/base", "runtime/core/module"}},
    {"runtime/training/run",
     {"base/variant", "base/file", "base/seal", "base/text", "plugins/host", "plugins/robot",
      "plugins/world", "runtime/base", "runtime/core/module", "runtime/core/task",
      "runtime/training/environment", "runtime/training/learning", "runtime/training/signal",
      "runtime/training/simulation"}},
    {"runtime/live/control",
     {"base/variant", "plugins/host", "runtime/base", "runtime/core/module", "runtime/core/task",
      "runtime/training/environment", "runtime/training/learning", "runtime/training/run"}},
    {"runtime/live/server", {"runtime/base", "runtime/live/control"}},
    {"runtime/live/client",
     {"runtime/base", "runtime/live/control", "runtime/live/server", "runtime/training/run"}},
    {"runtime/live/workers",
     {"base/text", "runtime/base", "runtime/core/module", "runtime/training/run"}},
    {"runtime/analysis/behavior",
     {"plugins/robot", "runtime/base", "runtime/training/run", "runtime/training/simulation"}},
    {"runtime/analysis/picture",
     {"plugins/robot", "plugins/world", "runtime/analysis/behavior", "runtime/base",
      "runtime/core/shape"}},
    {"runtime/analysis/film",
     {"plugins/robot", "plugins/world", "runtime/analysis/behavior", "runtime/analysis/picture",
      "runtime/base"}},
    {"runtime/analysis/robot",
     {"plugins/robot", "runtime/analysis/behavior", "runtime/analysis/picture", "runtime/base",
      "runtime/core/shape", "runtime/training/simulation"}},
    {"runtime/analysis/curves", {"runtime/training/run"}},
    {"runtime/analysis/report",
     {"runtime/analysis/curves", "runtime/base", "runtime/training/run"}},
    {"runtime/analysis/export",
     {"plugins/robot", "runtime/analysis/behavior", "runtime/analysis/curves", "runtime/core/shape",
      "runtime/training/learning", "runtime/training/run"}},
    {"runtime/analysis/study",
     {"runtime/analysis/behavior", "runtime/analysis/picture", "runtime/analysis/preference",
      "runtime/analysis/report", "runtime/base", "runtime/training/run"}},
    {"runtime/analysis/probe",
     {"plugins/robot", "runtime/analysis/behavior", "runtime/analysis/picture",
      "runtime/analysis/report", "runtime/analysis/study", "runtime/base", "runtime/core/module",
      "runtime/training/learning", "runtime/training/run"}},
    {"runtime/analysis/preference", {"runtime/base", "runtime/training/run"}},
    {"runtime/trainer", {"base/command_line", "base/text", "runtime/base"}},
    {"runtime/import",
     {"base/file", "plugins/robot", "runtime/analysis/robot", "runtime/base", "runtime/core/shape",
      "runtime/training/learning", "runtime/training/run", "runtime/training/simulation"}},
    {"runtime/trainer/robot",
     {"base/command_line", "base/text", "plugins/robot", "runtime/analysis/robot", "runtime/import",
      "runtime/trainer", "runtime/trainer/setup", "runtime/training/run",
      "runtime/training/simulation"}},
    {"runtime/trainer/setup",
     {"base/cache", "base/command_line", "base/text", "plugins/robot", "runtime/analysis/robot",
      "runtime/base", "runtime/core/agent", "runtime/core/module", "runtime/core/task",
      "runtime/trainer", "runtime/training/environment", "runtime/training/run",
      "runtime/training/simulation"}},
    {"runtime/trainer/runs",
     {"base/command_line", "base/text", "plugins/robot", "runtime/analysis/report", "runtime/base",
      "runtime/core/agent", "runtime/core/module", "runtime/core/task", "runtime/live/control",
      "runtime/live/server", "runtime/live/workers", "runtime/trainer", "runtime/trainer/setup",
      "runtime/training/run"}},
    {"runtime/trainer/serve",
     {"base/text", "runtime/analysis/report", "runtime/base", "runtime/live/client",
      "runtime/live/control", "runtime/live/server", "runtime/live/workers", "runtime/trainer",
      "runtime/trainer/runs", "runtime/training/run", "runtime/training/simulation"}},
    {"runtime/trainer/engines",
     {"base/text", "runtime/base", "runtime/live/workers", "runtime/trainer",
      "runtime/trainer/runs", "runtime/trainer/setup", "runtime/training/run"}},
    {"runtime/trainer/train",
     {"base/text", "plugins/robot", "runtime/analysis/probe", "runtime/analysis/study",
      "runtime/core/agent", "runtime/core/module", "runtime/core/task", "runtime/live/workers",
      "runtime/trainer", "runtime/trainer/engines", "runtime/trainer/runs", "runtime/trainer/serve",
      "runtime/trainer/setup", "runtime/training/run"}},
    {"runtime/trainer/environment",
     {"base/command_line", "base/text", "runtime/base", "runtime/core/module", "runtime/core/task",
      "runtime/trainer", "runtime/trainer/setup", "runtime/training/environment",
      "runtime/training/learning", "runtime/training/run"}},
    {"libtaskc_sim",
     {"base/file", "libtaskc", "plugins/host", "runtime/analysis/behavior",
      "runtime/analysis/picture", "runtime/core/module", "runtime/core/task",
      "runtime/trainer/environment", "runtime/trainer/setup", "runtime/training/learning",
      "runtime/training/run", "runtime/training/simulation"}},
    {"runtime/trainer/completion",
     {"base/command_line", "plugins/robot", "runtime/live/client", "runtime/live/control",
      "runtime/trainer", "runtime/trainer/ctl", "runtime/trainer/setup"}},
    {"runtime/trainer/ctl",
     {"base/command_line", "base/text", "base/watch", "runtime/base", "runtime/live/client",
      "runtime/live/control", "runtime/live/server", "runtime/trainer", "runtime/training/run"}},
    {"runtime/trainer/results",
     {"base/command_line", "base/text", "plugins/robot", "runtime/analysis/behavior",
      "runtime/analysis/export", "runtime/analysis/film", "runtime/analysis/picture",
      "runtime/analysis/report", "runtime/analysis/study", "runtime/base", "runtime/core/module",
      "runtime/live/control", "runtime/live/workers", "runtime/trainer", "runtime/trainer/runs",
      "runtime/trainer/setup", "runtime/training/environment", "runtime/training/learning",
      "runtime/training/run"}},
    {"runtime/trainer/reproduce",
     {"base/command_line", "base/text", "plugins/host", "runtime/base", "runtime/core/agent",
      "runtime/live/control", "runtime/trainer", "runtime/trainer/runs", "runtime/trainer/setup",
      "runtime/training/run"}},
    {"runtime/trainer/rescore",
     {"base/text", "plugins/robot", "runtime/base", "runtime/core/module", "runtime/core/task",
      "runtime/trainer", "runtime/trainer/runs", "runtime/trainer/setup",
      "runtime/training/environment", "runtime/training/run", "runtime/training/simulation"}},
    {"runtime/trainer/prefer",
     {"base/command_line", "base/text", "runtime/analysis/preference", "runtime/analysis/study",
      "runtime/base", "runtime/trainer", "runtime/trainer/runs"}},
};

bool IsSource(const std::filesystem::path& file) {
  return file.extension() == ".h" || file.extension() == ".cpp";
}

// "compiler/check" for compiler/check/unit.h.
std::string FolderOf(const std::filesystem::path& file) {
  return std::filesystem::relative(file, SOURCE_DIR).parent_path().string();
}

Folders IncludedBy(const std::filesystem::path& file) {
  static const std::regex kInclude(
      "^#include \"((?:base|compiler|plugins|runtime)/[\\w/]+|libtaskc(?:_sim)?)/\\w+\\.h\".*");
  Folders folders;
  std::ifstream in(file);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, match, kInclude)) folders.insert(match[1]);
  }
  return folders;
}

TEST(Structure, FoldersIncludeOnlyWhatTheyMay) {
  int files = 0;
  for (const char* top : {"base", "plugins", "libtaskc", "libtaskc_sim", "compiler", "runtime"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SOURCE_DIR) / top)) {
      if (!IsSource(entry.path())) continue;
      ++files;
      std::string folder = FolderOf(entry.path());
      if (folder.starts_with("plugins/abi/")) folder = "plugins/abi";
      if (folder.ends_with("/include/taskc")) folder = folder.substr(0, folder.find('/'));
      const auto allowed = kMayInclude.find(folder);
      ASSERT_NE(allowed, kMayInclude.end()) << "a new folder, " << folder << ": add it here";
      for (const std::string& included : IncludedBy(entry.path())) {
        EXPECT_TRUE(included == folder || allowed->second.contains(included))
            << entry.path() << " includes from " << included;
      }
    }
  }
  EXPECT_GT(files, 100);
}

// Where text is printed as it is: what is a file's content, what is colored, and where the cursor
// goes. All else is for a person and goes through base/text/print.h.
const std::set<std::string> kPrintsRaw = {
    "compiler/driver/emit_verb.cpp", "compiler/driver/fmt_verb.cpp", "compiler/driver/session.cpp",
    "base/text/print.h", "runtime/training/run/live_text.cpp"};

TEST(Structure, NoOneElsesEscapeSequenceReachesATerminal) {
  static const std::regex kRaw(
      R"(fmt::print\(|std::cout <<|std::cerr <<|std::(f?printf|f?puts)\()");
  for (const char* top : {"base", "plugins", "libtaskc", "libtaskc_sim", "compiler", "runtime"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SOURCE_DIR) / top)) {
      const std::string name = std::filesystem::relative(entry.path(), SOURCE_DIR).string();
      if (!IsSource(entry.path()) || kPrintsRaw.contains(name)) continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        EXPECT_FALSE(std::regex_search(line, kRaw)) << name << ": " << line;
      }
    }
  }
}

// Each file that includes CLI11 takes seconds longer to compile.
TEST(Structure, OnlyOneFolderIncludesCli11) {
  for (const char* top :
       {"base", "plugins", "libtaskc", "libtaskc_sim", "compiler", "runtime", "tests"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SOURCE_DIR) / top)) {
      if (!IsSource(entry.path()) || FolderOf(entry.path()) == "base/command_line") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        EXPECT_FALSE(line.starts_with("#include <CLI/")) << entry.path();
      }
    }
  }
}

// "runtime/core" for runtime/core/module, "base" for base/text.
std::string GroupOf(const std::string& folder) {
  const size_t end = folder.find('/');
  return folder.starts_with("runtime/") ? folder.substr(0, folder.find('/', end + 1))
                                        : folder.substr(0, end);
}

std::map<std::string, Folders> GroupsOf(const std::map<std::string, Folders>& folders) {
  std::map<std::string, Folders> groups;
  for (const auto& [folder, included] : folders) {
    Folders& group = groups[GroupOf(folder)];
    for (const std::string& each : included) {
      if (GroupOf(each) != GroupOf(folder)) group.insert(GroupOf(each));
    }
  }
  return groups;
}

// The names between backticks, without the slash at their end.
Folders NamesIn(const std::string& text) {
  static const std::regex kName("`([a-z_/]+)/`");
  Folders names;
  for (std::sregex_iterator name(text.begin(), text.end(), kName), end; name != end; ++name) {
    names.insert((*name)[1]);
  }
  return names;
}

// The rows of the table with the head "| folder | may include |" in docs/architecture.md.
std::map<std::string, Folders> DocumentedGroups() {
  std::map<std::string, Folders> groups;
  std::ifstream in(std::filesystem::path(SOURCE_DIR) / "docs/architecture.md");
  bool is_inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "| folder | may include |") {
      is_inside = true;
    } else if (is_inside && line.starts_with("| `")) {
      const size_t second = line.find('|', 1);
      const std::string group = *NamesIn(line.substr(0, second)).begin();
      groups[group] = NamesIn(line.substr(second));
    } else if (is_inside && !line.starts_with("|---")) {
      break;
    }
  }
  return groups;
}

TEST(Structure, IsAsItIsDocumented) {
  const std::map<std::string, Folders> groups = GroupsOf(kMayInclude);
  std::map<std::string, Folders> documented = DocumentedGroups();
  Folders& program = documented["runtime/trainer"];
  EXPECT_EQ(program, Folders{"compiler"}) << "all but this";
  program = groups.at("runtime/trainer");
  EXPECT_FALSE(program.contains("compiler"));
  EXPECT_EQ(groups, documented);
}

// An order in which every folder comes after all that it may include proves that there is no
// circle.
TEST(Structure, HasNoCircle) {
  Folders placed;
  for (size_t before = placed.size() + 1; before != placed.size();) {
    before = placed.size();
    for (const auto& [folder, allowed] : kMayInclude) {
      if (std::includes(placed.begin(), placed.end(), allowed.begin(), allowed.end())) {
        placed.insert(folder);
      }
    }
  }
  EXPECT_EQ(placed.size(), kMayInclude.size());
}

}  // namespace
