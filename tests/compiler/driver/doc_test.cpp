#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/build/file_io.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Doc, PrintsMarkdown) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("doc good.task");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("# good\n"), HasSubstr("\\Delta t")));
  EXPECT_EQ(taskc.Run("doc good.task -o good.md").out, "");
  EXPECT_EQ(ReadWholeFile(taskc.path("good.md")), outcome.out);
}

TEST(Doc, WritesOneHtmlFileThatNeedsNoOther) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  EXPECT_EQ(taskc.Run("doc good.task -o good.html").status, 0);
  std::string html = ReadWholeFile(taskc.path("good.html")).value();
  // Not matched as a whole: a failure would print all of the page.
  const auto has = [&](std::string_view part) { return html.find(part) != std::string::npos; };
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_TRUE(has("<title>good</title>") && has("<h1>good</h1>"));
  EXPECT_TRUE(has("font/woff2;base64"));
  EXPECT_FALSE(has("{{title}}") || has("{{content}}") || has("{{style}}") || has("{{script}}"));
  EXPECT_FALSE(has("src=\"http") || has("href=\"http"));
}

TEST(Doc, IsMarkdownOrHtml) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  Outcome outcome = taskc.Run("doc good.task -o good.pdf");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("a page is a .md or a .html file"));
}

TEST(Doc, WritesNothingForAWrongTask) {
  TaskcProcess taskc;
  taskc.Write("bad.task", "task bad\nmetric x = nothing\n");
  EXPECT_EQ(taskc.Run("doc bad.task -o bad.md").status, 1);
  EXPECT_FALSE(std::filesystem::exists(taskc.path("bad.md")));
}

}  // namespace
}  // namespace compiler
