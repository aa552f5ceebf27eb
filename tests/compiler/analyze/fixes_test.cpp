// The fixes that come with messages: whichever is taken, what it mends is no longer said. All
// golden files of messages are gone through.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/analyze/analyze.h"
#include "tests/compiler/compose/file_set.h"
#include "tests/golden.h"

namespace compiler {
namespace {

// A task of the golden files, with what it needs.
struct Case {
  std::filesystem::path golden;
  std::string file;  // the one that is analyzed
  FileSet files;
};

std::vector<Case> Cases() {
  const std::filesystem::path tests = SOURCE_DIR "/tests/compiler";
  std::vector<Case> cases;
  for (const char* folder : {"syntax", "check", "analyze"}) {
    for (const auto& path : golden::FilesIn(tests / folder / "messages", "", ".task")) {
      const std::string name = path.filename();
      cases.push_back({path, name, {{name, golden::ReadInput(path)}}});
    }
  }
  for (const char* folder : {"compose", "analyze"})
    for (const auto& path : golden::FilesIn(tests / folder / "messages", "", ".txt"))
      cases.push_back({path, "main.task", SplitFiles(golden::ReadInput(path))});
  return cases;
}

Analysis AnalyzeCase(const Case& golden) {
  return Analyze(golden.file, ReaderOf(golden.files), SOURCE_DIR "/plugins");
}

Case With(const Fix& fix, Case golden, const Sources& sources) {
  const SourceFile& file = sources.FileOf(fix.span);
  golden.files.at(file.path())
      .replace(fix.span.begin - file.first_offset(), fix.span.end - fix.span.begin, fix.text);
  return golden;
}

auto Count(const Diagnostics& diagnostics, const Diagnostic& wanted) {
  return std::ranges::count_if(diagnostics.list(), [&](const Diagnostic& other) {
    return other.code == wanted.code && other.message == wanted.message;
  });
}

// Errors of syntax hide all others.
auto CountOfSyntax(const Diagnostics& diagnostics) {
  return std::ranges::count_if(diagnostics.list(), [](const Diagnostic& diagnostic) {
    return diagnostic.code.starts_with("E01");
  });
}

TEST(Fixes, MendWhatTheyAreFor) {
  size_t count = 0;
  for (const Case& golden : Cases()) {
    const Analysis before = AnalyzeCase(golden);
    for (const Diagnostic& diagnostic : before.diagnostics.list()) {
      for (const Fix& fix : diagnostic.help.fixes) {
        ++count;
        const std::string about = golden.golden.string() + ": " + diagnostic.message + ": `" +
                                  fix.text + "`, line " +
                                  std::to_string(before.sources.LineOf(diagnostic.span));
        ASSERT_EQ(before.sources.IndexOf(fix.span), before.sources.IndexOf(diagnostic.span));
        const Analysis after = AnalyzeCase(With(fix, golden, before.sources));
        EXPECT_LT(Count(after.diagnostics, diagnostic), Count(before.diagnostics, diagnostic))
            << about;
        if (!diagnostic.code.starts_with("E01")) {
          EXPECT_LE(CountOfSyntax(after.diagnostics), CountOfSyntax(before.diagnostics)) << about;
        }
      }
    }
  }
  EXPECT_GT(count, 100u);
}

TEST(Fixes, ComeWithEachSuggestedName) {
  for (const Case& golden : Cases()) {
    const Analysis analysis = AnalyzeCase(golden);
    for (const Diagnostic& diagnostic : analysis.diagnostics.list()) {
      if (!diagnostic.help.text.starts_with("did you mean")) continue;
      EXPECT_EQ(diagnostic.help.fixes.size(), 1u) << golden.golden << ": " << diagnostic.message;
    }
  }
}

}  // namespace
}  // namespace compiler
