#include "compiler/document/page.h"

#include <gtest/gtest.h>

namespace compiler {
namespace {

Page SamplePage() {
  Page page;
  page.title = "a <b> & _c_";
  page.blocks.push_back(Paragraph{FromDoc("say `x < y` | twice")});
  page.blocks.push_back(Formulas{{{"a", "=", "b < c"}, {"d", "\\leftarrow", "e"}}});
  page.blocks.push_back(
      Table{{"one", "two"}, {{Code("n"), Math("\\lvert x \\rvert")}, {{}, Plain("two\nlines")}}});
  page.blocks.push_back(List{{Plain("first"), Plain("second")}});
  return page;
}

TEST(Page, BecomesMarkdown) {
  EXPECT_EQ(ToMarkdown(SamplePage()),
            "# a \\<b\\> & \\_c\\_\n"
            "\n"
            "say `x < y` \\| twice\n"
            "\n"
            "$$\n"
            "\\begin{aligned}\n"
            "a &= b < c \\\\[4pt]\n"
            "d &\\leftarrow e\n"
            "\\end{aligned}\n"
            "$$\n"
            "\n"
            "| one | two |\n"
            "|---|---|\n"
            "| `n` | $\\lvert x \\rvert$ |\n"
            "| | two lines |\n"
            "\n"
            "* first\n"
            "* second\n");
}

TEST(Page, BecomesHtmlInItsTemplate) {
  std::string html = ToHtml(SamplePage(), "<title>{{title}}</title>{{content}}!");
  EXPECT_EQ(
      html,
      "<title>a &lt;b&gt; &amp; _c_</title><h1>a &lt;b&gt; &amp; _c_</h1>\n"
      "<p>say <code>x &lt; y</code> | twice</p>\n"
      "<div class=\"math\">\\begin{aligned}\na &amp;= b &lt; c \\\\[4pt]\nd "
      "&amp;\\leftarrow e\n\\end{aligned}</div>\n"
      "<div class=\"scroll\"><table><thead><tr><th>one</th><th>two</th></tr></thead><tbody>\n"
      "<tr><td><code>n</code></td><td><span class=\"math\">\\lvert x \\rvert</span></td></tr>\n"
      "<tr><td></td><td>two\nlines</td></tr></tbody></table></div>\n"
      "<ul>\n<li>first</li>\n<li>second</li>\n</ul>\n!");
}

}  // namespace
}  // namespace compiler
