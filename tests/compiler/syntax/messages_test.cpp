#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/parse.h"
#include "tests/golden.h"

namespace compiler {
namespace {

const std::filesystem::path kFolder = SOURCE_DIR "/tests/compiler/syntax/messages";

TEST(SyntaxMessages, AreAsReviewed) {
  for (const auto& path : golden::FilesIn(kFolder, "fail_", ".task")) {
    const Sources sources(path.filename(), golden::ReadFile(path));
    Diagnostics diagnostics;
    EXPECT_FALSE(Parse(sources.main(), diagnostics).has_value()) << path;
    std::filesystem::path expected = path;
    golden::Expect(expected.replace_extension(".expected"), Render(sources, diagnostics, false));
  }
}

}  // namespace
}  // namespace compiler
