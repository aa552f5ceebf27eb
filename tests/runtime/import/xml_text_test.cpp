#include "runtime/import/xml_text.h"

#include <gmock/gmock.h>

namespace runtime {
namespace {

constexpr const char* kText =
    "<?xml version=\"1.0\"?>\n<!-- <no> -->\n<robot name='a > b'>\n  <link\n    name=\"x\" />\n"
    "  <link name=\"y\"><link/></link>\n</robot>\n";

TEST(XmlText, FindsTagsButNotInComments) {
  const XmlText text(kText);
  const std::vector<XmlTag> tags = text.Tags();
  ASSERT_EQ(tags.size(), 6u);
  EXPECT_EQ(tags[0].name, "robot");
  EXPECT_EQ(text.Attribute(tags[0], "name"), "a > b");
  EXPECT_EQ(text.LineOf(tags[0].begin), 3);
  EXPECT_TRUE(tags[1].is_empty);
  EXPECT_EQ(text.Attribute(tags[1], "name"), "x");
  EXPECT_EQ(text.Attribute(tags[1], "ame"), "");
  EXPECT_TRUE(tags[5].is_end);
  EXPECT_EQ(text.EndOfElement(tags, 2), tags[4].end);
}

TEST(XmlText, BlanksWithoutMovingLines) {
  XmlText text(kText);
  const std::vector<XmlTag> tags = text.Tags();
  EXPECT_FALSE(text.BlankAttribute(tags[1], "mass"));
  EXPECT_TRUE(text.BlankAttribute(tags[1], "name"));
  EXPECT_TRUE(text.BlankValue(tags[2], "y"));
  text.Blank(tags[2].begin, text.EndOfElement(tags, 2));
  EXPECT_EQ(text.text().size(), std::string(kText).size());
  const std::vector<XmlTag> left = text.Tags();
  ASSERT_EQ(left.size(), 3u);
  EXPECT_EQ(text.Attribute(left[1], "name"), "");
  EXPECT_EQ(text.LineOf(left[2].begin), 7);
}

TEST(XmlText, EndsWhereTheTextDoes) {
  for (const char* broken :
       {"<", "<a", "<a b", "<a b=", "<a b='", "</", "<!--", "<![CDATA[", "<a b=\"c"}) {
    const XmlText text(broken);
    for (const XmlTag& tag : text.Tags()) {
      EXPECT_EQ(text.Attribute(tag, "b"), "") << broken;
      EXPECT_LE(text.EndOfElement(text.Tags(), 0), text.text().size()) << broken;
    }
  }
}

}  // namespace
}  // namespace runtime
