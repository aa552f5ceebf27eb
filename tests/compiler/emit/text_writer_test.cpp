#include "compiler/emit/text_writer.h"

#include <gtest/gtest.h>

namespace compiler {
namespace {

TEST(TextWriter, SaysTheLineOnlyWhereTheCompilerWouldBeWrong) {
  TextWriter writer("a.cpp");
  writer.Line("// ours");
  writer.Line("one;", {"a.task", 7});
  writer.Line("two;", {"a.task", 8});
  writer.Line("two again;", {"a.task", 8});
  writer.Line("five;", {"a.task", 5});
  EXPECT_EQ(writer.text(),
            "// ours\n#line 7 \"a.task\"\none;\ntwo;\n#line 8\ntwo again;\n#line 5\nfive;\n");
}

TEST(TextWriter, CountsLinesThatStandForNone) {
  TextWriter writer("a.cpp");
  writer.Line("if (x) {", {"a.task", 3});
  writer.Line("}");
  writer.Line("next;", {"a.task", 5});
  EXPECT_EQ(writer.text(), "#line 3 \"a.task\"\nif (x) {\n}\nnext;\n");
}

TEST(TextWriter, ComesBackToItsOwnLines) {
  TextWriter writer("a.cpp");
  writer.Line("one;", {"a.task", 7});
  writer.LeaveSource();
  writer.Line("ours\nand ours");
  // "ours" is the fourth line of the text.
  EXPECT_EQ(writer.text(), "#line 7 \"a.task\"\none;\n#line 4 \"a.cpp\"\nours\nand ours\n");
}

TEST(TextWriter, IndentsCodeButNoDirective) {
  TextWriter writer("a.cpp");
  writer.Indent();
  writer.Line("one;", {"a.task", 1});
  writer.BlankLine();
  writer.Outdent();
  writer.Line("}");
  EXPECT_EQ(writer.text(), "#line 1 \"a.task\"\n  one;\n\n}\n");
}

TEST(TextWriter, SaysTheFileWhereItChanges) {
  TextWriter writer("a.cpp");
  writer.Line("one;", {"a.task", 1});
  writer.Line("two;", {"base.task", 2});
  writer.Line("three;", {"a.task", 3});
  EXPECT_EQ(writer.text(),
            "#line 1 \"a.task\"\none;\n#line 2 \"base.task\"\ntwo;\n#line 3 \"a.task\"\nthree;\n");
}

TEST(TextWriter, QuotesPathsAsTheCompilerReadsThem) {
  TextWriter writer("a.cpp");
  writer.Line("one;", {"a \"b\"\\c.task", 1});
  EXPECT_EQ(writer.text(), "#line 1 \"a \\\"b\\\"\\\\c.task\"\none;\n");
}

}  // namespace
}  // namespace compiler
