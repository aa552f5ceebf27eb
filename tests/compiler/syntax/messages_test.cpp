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
    const Sources sources(path.filename(), golden::ReadInput(path));
    Diagnostics diagnostics;
    Parse(sources.main(), diagnostics);
    EXPECT_TRUE(diagnostics.has_errors()) << path;
    golden::ExpectBehindInput(path, Render(sources, diagnostics, false));
  }
}

}  // namespace
}  // namespace compiler
