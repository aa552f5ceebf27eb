// What an editor is told of mistakes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compiler/language_server/editor.h"

namespace compiler {
namespace {

using protocol::Json;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Diagnostics, ArePublishedAsOneTypes) {
  Editor editor;
  auto said = editor.Open("a.task", kTask);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0]["method"], "textDocument/publishDiagnostics");
  EXPECT_EQ(said[0]["params"]["diagnostics"], Json::array());
  const Json change{
      {"range",
       {{"start", {{"line", 11}, {"character", 24}}}, {"end", {{"line", 11}, {"character", 32}}}}},
      {"text", "velosity"}};
  said = editor.Tell("textDocument/didChange",
                     {{"textDocument", {{"uri", editor.UriOf("a.task")}, {"version", 2}}},
                      {"contentChanges", {change}}});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0]["params"]["version"], 2);
  const Json diagnostic = said[0]["params"]["diagnostics"].at(0);
  EXPECT_EQ(Text(diagnostic["range"]), "11:19-11:32");
  EXPECT_EQ(diagnostic["severity"], 1);
  EXPECT_EQ(diagnostic["code"], "E0202");
  EXPECT_THAT(diagnostic["codeDescription"]["href"].get<std::string>(),
              StartsWith("file:///page.md#e0202-"));
  EXPECT_THAT(diagnostic["message"].get<std::string>(), HasSubstr("did you mean"));
}

TEST(Diagnostics, HaveRelatedPlaces) {
  Editor editor;
  const auto said = editor.Open("a.task", TaskWith("memory fallen", "memory fall_penalty"));
  const Json diagnostic = said.at(0)["params"]["diagnostics"].at(0);
  EXPECT_EQ(Text(diagnostic["relatedInformation"].at(0)["location"]["range"]), "6:6-6:18");
}

TEST(Diagnostics, GoWhenTheFileIsClosed) {
  Editor editor;
  editor.Open("a.task", "task a\nmetric b = c\n");
  const auto said =
      editor.Tell("textDocument/didClose", {{"textDocument", {{"uri", editor.UriOf("a.task")}}}});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0]["params"]["diagnostics"], Json::array());
}

TEST(Diagnostics, CountColumnsInUtf16) {
  Editor editor;
  const auto said =
      editor.Open("a.task", "task a\non end_of_action { end_episode failure \"😀ä\" let b = c }\n");
  const Json diagnostics = said.at(0)["params"]["diagnostics"];
  EXPECT_EQ(Text(diagnostics.at(0)["range"]), "1:53-1:54");
}

TEST(Diagnostics, OfARobotWithAWrongFileAreGivenInTheTask) {
  Editor editor;
  const auto said = editor.Open("a.task", "task a for nobody\n");
  EXPECT_EQ(said.at(0)["params"]["diagnostics"].at(0)["code"], "E0212");
}

TEST(Diagnostics, OfATableAreGivenInItsFile) {
  Editor editor;
  editor.Write("curve.csv", "x, y\n0, 1\n2, three\n");
  const std::vector<Json> published =
      editor.Open("a.task", "task t\ntable height: real = \"curve.csv\"\n");
  const auto of_table = std::ranges::find_if(published, [&](const Json& each) {
    return each["params"]["uri"] == editor.UriOf("curve.csv");
  });
  ASSERT_NE(of_table, published.end());
  EXPECT_EQ((*of_table)["params"]["diagnostics"].at(0)["code"], "E0671");
  EXPECT_EQ(Text((*of_table)["params"]["diagnostics"].at(0)["range"]), "2:3-2:8");
}

}  // namespace
}  // namespace compiler
