#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compiler/toolchain/file_io.h"
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
  EXPECT_THAT(outcome.error, HasSubstr("a page is a .md or .html file"));
}

TEST(Doc, IsJsonForPrograms) {
  TaskcProcess taskc;
  taskc.Write("library.task", "fn near(distance: real [m]) -> real = exp(-distance / 1 m)\n");
  taskc.Write("weighed.task", R"(task weighed for humanoid
import "library.task"
param weight: real = 2
on end_of_time_step { reward rate up = weight * near(base.position.z) }
)");
  const Outcome outcome = taskc.Run("doc weighed.task --json");
  EXPECT_EQ(outcome.status, 0);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["task"], "weighed");
  EXPECT_EQ(json["file"], "weighed.task");
  EXPECT_EQ(json["terms"][0]["weight"], "weight");
  // The plugin is known by the same.
  const std::string field = ".source_hash = \"" + json["hash"].get<std::string>() + "\"";
  EXPECT_THAT(taskc.Run("emit weighed.task").out, HasSubstr(field));
}

TEST(Doc, IsNotAPageAndJsonAtOnce) {
  TaskcProcess taskc;
  taskc.Write("good.task", kGoodTask);
  const Outcome outcome = taskc.Run("doc good.task --json -o good.md");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, HasSubstr("--output excludes --json"));
}

TEST(Doc, WritesNothingForAWrongTask) {
  TaskcProcess taskc;
  taskc.Write("bad.task", "task bad\nmetric x = nothing\n");
  EXPECT_EQ(taskc.Run("doc bad.task -o bad.md").status, 1);
  EXPECT_FALSE(std::filesystem::exists(taskc.path("bad.md")));
}

// The names and texts of a page are other people's.
TEST(Doc, SendsNoEscapeSequenceToATerminal) {
  TaskcProcess taskc;
  const std::string name = "go\x1b[31mod\u202e.task";
  taskc.Write(name, kGoodTask);
  const std::string quoted = " '" + name + "'";
  for (const std::string verb : {"doc", "doc --json", "check", "build --format json", "new"}) {
    const Outcome outcome = taskc.Run(verb + quoted);
    EXPECT_EQ(outcome.out.find('\x1b'), std::string::npos) << verb;
    EXPECT_EQ(outcome.out.find("\u202e"), std::string::npos) << verb;
    EXPECT_EQ(outcome.error.find('\x1b'), std::string::npos) << verb;
    EXPECT_EQ(outcome.error.find("\u202e"), std::string::npos) << verb;
  }
  const Outcome json = taskc.Run("check --format json" + quoted);
  EXPECT_EQ(nlohmann::json::parse(json.out)["tasks"][0]["file"], name);
  const Outcome absent = taskc.Run("check 'absent\x1b[31m.task'");
  EXPECT_NE(absent.error.find("cannot read `absent\\u001b[31m.task`"), std::string::npos);
  taskc.Write(name, "task t for humanoid\nreward\n");
  const Outcome wrong = taskc.Run("check --color always" + quoted);
  EXPECT_NE(wrong.error.find(" go\\u001b[31mod\\u202e.task:2:"), std::string::npos) << wrong.error;
}

}  // namespace
}  // namespace compiler
