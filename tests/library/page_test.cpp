// docs/library.md says of each function what its file says.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "compiler/source/sources.h"
#include "compiler/syntax/parse.h"
#include "tests/golden.h"

namespace library {
namespace {

const std::filesystem::path kFolder = SOURCE_DIR "/library/std";
const std::filesystem::path kPage = SOURCE_DIR "/docs/library.md";
constexpr std::string_view kBegin = "## std/";

// The `//` lines at the top, as paragraphs.
std::string HeadOf(std::string_view text) {
  std::string head;
  while (text.starts_with("//")) {
    const size_t end = text.find('\n');
    std::string_view line = text.substr(2, end - 2);
    if (line.starts_with(' ')) line.remove_prefix(1);
    head += fmt::format("{}\n", line);
    text.remove_prefix(end + 1);
  }
  return head;
}

// What is written from a declaration's begin to its value, or to the brace of its body.
std::string SignatureOf(std::string_view text, std::string_view end) {
  std::string signature(text.substr(0, text.find(end)));
  signature.erase(signature.find_last_not_of(" \n") + 1);
  return signature;
}

std::string SectionOf(const std::filesystem::path& file) {
  const std::string text = golden::ReadFile(file);
  const compiler::Sources sources(file.string(), text);
  compiler::Diagnostics diagnostics;
  const auto tree = compiler::Parse(sources.main(), diagnostics);
  EXPECT_TRUE(tree && !diagnostics.has_errors()) << file;
  std::string section = fmt::format("## std/{}\n\n{}", file.stem().string(), HeadOf(text));
  for (const compiler::Declaration& declaration : tree->declarations) {
    const std::string_view written = sources.main().TextOf(declaration.span);
    std::string signature;
    std::string doc;
    if (const auto* function = std::get_if<compiler::FunctionDeclaration>(&declaration.node)) {
      const std::string_view rest = written.substr(written.find("->"));
      const bool has_body = rest.find('{') < rest.find('=');
      const std::string_view end = has_body ? " {" : " =";
      signature = SignatureOf(written, end);
      doc = function->doc;
    } else {
      signature = written;
      doc = std::get<compiler::ConstDeclaration>(declaration.node).doc;
    }
    EXPECT_FALSE(doc.empty()) << signature;
    section += fmt::format("\n```task of a library\n{}\n```\n\n{}\n", signature, doc);
  }
  return section;
}

TEST(LibraryPage, SaysWhatTheFilesSay) {
  const std::string page = golden::ReadFile(kPage);
  const size_t begin = page.find(kBegin);
  ASSERT_NE(begin, std::string::npos);
  std::string expected = page.substr(0, begin);
  for (const auto& file : golden::FilesIn(kFolder, "", ".task"))
    expected += (expected.ends_with("\n\n") ? "" : "\n") + SectionOf(file);
  golden::Expect(kPage, expected);
}

}  // namespace
}  // namespace library
