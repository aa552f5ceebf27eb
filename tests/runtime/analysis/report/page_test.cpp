#include "runtime/analysis/report/page.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class MakePageTest : public testing::Test {
 protected:
  void SetUp() override {
    Write("template.html", "<title>{{title}}</title>{{style}}<script>{{data}}</script>{{script}}");
    Write("page.css", "p{}");
    Write("page.js", "f()");
  }
  void Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }
  std::string Make(const json& data) { return MakePage(data, folder_.path()); }

  TemporaryFolder folder_;
};

TEST_F(MakePageTest, PutsTheFourPartsIntoTheTemplate) {
  EXPECT_EQ(Make({{"title", "hop – learning run"}}),
            "<title>hop – learning run</title>p{}"
            "<script>{\"title\":\"hop \\u2013 learning run\"}</script>f()");
}

TEST_F(MakePageTest, DataThatLooksLikeAPlaceholderStaysAsItIs) {
  const std::string page = Make({{"title", "{{script}}"}});
  EXPECT_THAT(page, HasSubstr("<title>{{script}}</title>"));
  EXPECT_THAT(page, HasSubstr("\"{{script}}\""));
}

TEST_F(MakePageTest, NoTextEndsTheScriptOrTheTitle) {
  const std::string page = Make({{"title", "</title></script><!--<script>\""}});
  EXPECT_THAT(page, HasSubstr("<title>&lt;/title&gt;&lt;/script&gt;&lt;!--&lt;script&gt;&quot;<"));
  EXPECT_THAT(page, HasSubstr("\\u003c/title>\\u003c/script>\\u003c!--\\u003cscript>\\\""));
}

TEST_F(MakePageTest, AMissingPartIsNamedWithTheRemedy) {
  std::filesystem::remove(folder_.path() / "page.js");
  const std::string error = ErrorOf([&] { Make({{"title", ""}}); });
  EXPECT_THAT(error, HasSubstr((folder_.path() / "page.js").string()));
  EXPECT_THAT(error, HasSubstr("`web`"));
}

TEST(JsonForScript, IsAsciiAndReadsBackAsItWas) {
  const json data = {{"why", "fällt\u2028um </script> & \\ \"so\""}};
  const std::string text = JsonForScript(data);
  EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 128; }));
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_EQ(json::parse(text), data);
}

TEST(JsonForScript, BytesThatAreNoTextAreReplaced) {
  EXPECT_EQ(JsonForScript("a\xff z"), "\"a\\ufffd z\"");
}

}  // namespace
}  // namespace runtime
