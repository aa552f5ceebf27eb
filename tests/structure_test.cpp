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
    {"plugins/abi", {}},
    {"plugins/host", {}},
    {"plugins/text", {}},
    {"plugins/file", {}},
    {"plugins/command_line", {"plugins/text"}},
    {"plugins/seal", {}},
    {"plugins/watch", {}},
    {"plugins/cache", {}},
    {"plugins/robot", {"plugins/file", "plugins/text"}},

    {"compiler/source", {"plugins/file", "plugins/seal", "plugins/text"}},
    {"compiler/syntax", {"compiler/source", "plugins/text"}},
    {"compiler/format", {"compiler/source", "compiler/syntax", "plugins/text"}},
    {"compiler/compose", {"compiler/source", "compiler/syntax", "plugins/file", "plugins/text"}},
    {"compiler/check", {"compiler/source", "compiler/syntax", "plugins/robot", "plugins/text"}},
    {"compiler/analyze",
     {"compiler/bounds", "compiler/check", "compiler/compose", "compiler/source", "compiler/syntax",
      "plugins/robot"}},
    {"compiler/language_server",
     {"compiler/analyze", "compiler/bounds", "compiler/check", "compiler/format", "compiler/source",
      "compiler/syntax", "plugins/robot", "plugins/text"}},
    {"compiler/bounds", {"compiler/check", "compiler/source", "compiler/syntax", "plugins/text"}},
    {"compiler/gains", {"compiler/check"}},
    {"compiler/emit", {"compiler/check", "compiler/source", "compiler/syntax"}},
    {"compiler/build", {"compiler/source", "plugins/cache", "plugins/file", "plugins/seal"}},
    {"compiler/evaluate", {"compiler/check"}},
    {"compiler/report", {"compiler/source"}},
    {"compiler/testing",
     {"compiler/build", "compiler/check", "compiler/emit", "compiler/evaluate", "compiler/source",
      "compiler/syntax", "plugins/cache", "plugins/host", "plugins/robot"}},
    {"compiler/document",
     {"compiler/analyze", "compiler/bounds", "compiler/check", "compiler/gains", "compiler/report",
      "compiler/source", "compiler/syntax", "plugins/robot"}},
    {"compiler/driver",
     {"compiler/analyze", "compiler/bounds", "compiler/build", "compiler/check",
      "compiler/document", "compiler/emit", "compiler/format", "compiler/language_server",
      "compiler/report", "compiler/source", "compiler/syntax", "compiler/testing",
      "plugins/command_line", "plugins/file", "plugins/robot", "plugins/seal", "plugins/text",
      "plugins/watch"}},

    {"runtime/module", {"plugins/robot", "plugins/text"}},
    {"runtime/task",
     {"plugins/file", "plugins/host", "plugins/robot", "plugins/seal", "runtime/module"}},
    {"runtime/agent", {"plugins/file", "runtime/module"}},
    {"runtime/simulation", {"plugins/robot", "runtime/module"}},
    {"runtime/learning",
     {"plugins/cache", "plugins/file", "plugins/robot", "plugins/seal", "runtime/module"}},
    {"runtime/run",
     {"plugins/file", "plugins/robot", "plugins/seal", "plugins/text", "runtime/learning",
      "runtime/module", "runtime/simulation", "runtime/task"}},
    {"runtime/behavior", {"plugins/robot", "runtime/run"}},
    {"runtime/picture", {"plugins/robot", "runtime/behavior"}},
    {"runtime/report", {"runtime/module", "runtime/run"}},
    {"runtime/preference", {"runtime/control", "runtime/module", "runtime/run"}},
    {"runtime/study",
     {"runtime/behavior", "runtime/control", "runtime/module", "runtime/picture",
      "runtime/preference", "runtime/report", "runtime/run"}},
    {"runtime/control",
     {"runtime/learning", "runtime/module", "runtime/run", "runtime/simulation", "runtime/task"}},
    {"runtime/server", {"runtime/control", "runtime/module"}},
    {"runtime/client", {"runtime/control", "runtime/module", "runtime/server"}},
    {"runtime/workers", {"plugins/text", "runtime/module", "runtime/run"}},
    {"runtime/trainer",
     {"plugins/command_line", "plugins/robot", "plugins/text", "plugins/watch", "runtime/agent",
      "runtime/behavior", "runtime/client", "runtime/control", "runtime/module", "runtime/picture",
      "runtime/preference", "runtime/report", "runtime/run", "runtime/server", "runtime/simulation",
      "runtime/study", "runtime/task", "runtime/workers"}},
};

bool IsSource(const std::filesystem::path& file) {
  return file.extension() == ".h" || file.extension() == ".cpp";
}

// "compiler/check" for compiler/check/unit.h.
std::string FolderOf(const std::filesystem::path& file) {
  return std::filesystem::relative(file, SOURCE_DIR).parent_path().string();
}

Folders IncludedBy(const std::filesystem::path& file) {
  static const std::regex kInclude("^#include \"((?:compiler|plugins|runtime|tests)/\\w+)/.*");
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
  for (const char* top : {"plugins", "compiler", "runtime"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SOURCE_DIR) / top)) {
      if (!IsSource(entry.path())) continue;
      ++files;
      std::string folder = FolderOf(entry.path());
      if (folder.starts_with("plugins/abi/")) folder = "plugins/abi";
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
// goes. All else is for a person and goes through plugins/text/print.h.
const std::set<std::string> kPrintsRaw = {
    "compiler/driver/emit_verb.cpp", "compiler/driver/fmt_verb.cpp", "compiler/driver/session.cpp",
    "plugins/text/print.h", "runtime/run/live_text.cpp"};

TEST(Structure, NoOneElsesEscapeSequenceReachesATerminal) {
  static const std::regex kRaw(
      R"(fmt::print\(|std::cout <<|std::cerr <<|std::(f?printf|f?puts)\()");
  for (const char* top : {"plugins", "compiler", "runtime"}) {
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
