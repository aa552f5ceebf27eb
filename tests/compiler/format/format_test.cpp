#include "compiler/format/format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace compiler {
namespace {

// The formatted text of a task that is well-formed.
std::string Formatted(const std::string& text) {
  const Sources sources("a.task", text);
  Diagnostics diagnostics;
  const auto formatted = Format(sources.main(), diagnostics);
  EXPECT_TRUE(formatted) << Render(sources, diagnostics, false);
  return formatted.value_or("");
}

// The same for statements: the lines of an event's block, without their indentation.
std::string FormattedBlock(const std::string& statements) {
  const std::string begin = "task t\n\non end_of_action {\n";
  const std::string text = Formatted("task t\n\non end_of_action {\n" + statements + "\n}\n");
  EXPECT_TRUE(text.starts_with(begin) && text.ends_with("}\n")) << text;
  std::string lines;
  for (size_t i = begin.size(); i < text.size() - 2;) {
    const size_t end = text.find('\n', i);
    if (end > i) lines += text.substr(i + 2, end - i - 2);
    lines += '\n';
    i = end + 1;
  }
  return lines;
}

// One statement in one line, without the line's end.
std::string FormattedLine(const std::string& statement) {
  std::string text = FormattedBlock(statement);
  EXPECT_EQ(text.find('\n'), text.size() - 1) << text;
  text.pop_back();
  return text;
}

TEST(Format, SetsBlanksBetweenTokens) {
  EXPECT_EQ(FormattedLine("let   a=b+c*( d-1 )"), "let a = b + c * (d - 1)");
  EXPECT_EQ(FormattedLine("let a = - b+ -2"), "let a = -b + -2");
  EXPECT_EQ(FormattedLine("let a = not(b)and c"), "let a = not (b) and c");
  EXPECT_EQ(FormattedLine("a+=clamp ( x,1 ,2 )"), "a += clamp(x, 1, 2)");
  EXPECT_EQ(FormattedLine("let a = base . velocity .xy"), "let a = base.velocity.xy");
  EXPECT_EQ(FormattedLine("let a = x<=y"), "let a = x <= y");
  EXPECT_EQ(FormattedLine("end_episode   failure\"why\""), "end_episode failure \"why\"");
}

TEST(Format, SetsIndicesAndSetsTightly) {
  EXPECT_EQ(FormattedLine("let a = any(contact [ 2 .. 7,links-{ body,head }-feet ])"),
            "let a = any(contact[2..7, links - {body, head} - feet])");
}

TEST(Format, SetsConstsSetsAndTolerances) {
  EXPECT_EQ(Formatted("task t\nconst   a:real[ m ]=5cm\nset  b={ feet,hands }-0 .. 3\n"
                      "test \"c\" {expect a==b  within  -c}\n"),
            "task t\nconst a: real [m] = 5 cm\nset b = {feet, hands} - 0..3\n"
            "test \"c\" { expect a == b within -c }\n");
}

TEST(Format, SetsUnitsAsTheyAreRead) {
  EXPECT_EQ(FormattedLine("let a = 0.25/5ms*b"), "let a = 0.25 / 5 ms * b");
  EXPECT_EQ(FormattedLine("let a = 3m / s ^ 2 * b"), "let a = 3 m/s^2 * b");
  EXPECT_EQ(FormattedLine("let a = 4/s"), "let a = 4 / s");
  EXPECT_EQ(FormattedLine("let a = 4/s/m"), "let a = 4 / s / m");
  EXPECT_EQ(FormattedLine("let a = 2 N*m"), "let a = 2 N*m");
  EXPECT_EQ(FormattedLine("let a = 5 s^ - 1"), "let a = 5 s^-1");
  EXPECT_EQ(FormattedLine("let a = 5 min*min( b,1 )"), "let a = 5 min * min(b, 1)");
}

TEST(Format, SetsDeclarations) {
  EXPECT_EQ(Formatted("task  t  for humanoid\nstart   standing\n"
                      "param k:real[1/s]=4/s in 0/s..20/s\nmemory n:real [ 4 ][N  m]=0 per action\n"
                      "memory c:bool [link]=false\nmetric  max h=base.position.z\n"),
            "task t for humanoid\nstart standing\n"
            "param k: real [1/s] = 4 / s in 0 / s .. 20 / s\n"
            "memory n: real[4] [N m] = 0 per action\n"
            "memory c: bool[link] = false\nmetric max h = base.position.z\n");
  EXPECT_EQ(Formatted("task t\nsensor a . b:vec3[m / s]\n"), "task t\nsensor a.b: vec3 [m/s]\n");
}

TEST(Format, GivesEachStatementALine) {
  EXPECT_EQ(FormattedBlock("a = 1 b = 2"), "a = 1\nb = 2\n");
  EXPECT_EQ(FormattedBlock("if a { b = 1 c = 2 }"), "if a {\n  b = 1\n  c = 2\n}\n");
  EXPECT_EQ(Formatted("task t for humanoid start standing memory a: int = 0"),
            "task t for humanoid\nstart standing\nmemory a: int = 0\n");
}

TEST(Format, LeavesAShortBlockInItsLine) {
  EXPECT_EQ(FormattedLine("if a{b=1}"), "if a { b = 1 }");
  EXPECT_EQ(FormattedLine("if a { if b {c = 1} }"), "if a { if b { c = 1 } }");
  EXPECT_EQ(FormattedLine("if a { b = 1 } else{c=1}"), "if a { b = 1 } else { c = 1 }");
  EXPECT_EQ(FormattedBlock("if a {\nb = 1 }"), "if a {\n  b = 1\n}\n");
  EXPECT_EQ(FormattedLine("if a {\n\n}"), "if a {}");
}

TEST(Format, OpensABlockThatDoesNotFit) {
  const std::string fits = "if " + std::string(85, 'x') + " { b = 1 }";
  EXPECT_EQ(FormattedLine(fits), fits);
  EXPECT_EQ(FormattedBlock("if x" + fits.substr(3)),
            "if x" + fits.substr(3, 85) + " {\n  b = 1\n}\n");
}

TEST(Format, PutsBracesAndElseWhereTheyBelong) {
  EXPECT_EQ(FormattedBlock("if a\n{\nb = 1\n}\nelse if c\n{\nb = 2 }\nelse\n{ b = 3\n}"),
            "if a {\n  b = 1\n} else if c {\n  b = 2\n} else {\n  b = 3\n}\n");
}

TEST(Format, KeepsOneBlankLine) {
  EXPECT_EQ(Formatted("\n\ntask t\n\n\n\nmemory a: int = 0\non end_of_action {\n\n\na = 1\n\n\n"
                      "a = 2\n\n}\n\n\n"),
            "task t\n\nmemory a: int = 0\non end_of_action {\n  a = 1\n\n  a = 2\n}\n");
}

TEST(Format, KeepsTheBreaksOfLongExpressions) {
  EXPECT_EQ(FormattedBlock("let a = b +\nc *\n\nd"), "let a = b +\n    c *\n    d\n");
  EXPECT_EQ(FormattedBlock("let a = clamp(\nb\n,\n1, 2\n)"),
            "let a = clamp(\n    b,\n    1, 2\n)\n");
  EXPECT_EQ(FormattedBlock("let a = (b\n- c)"), "let a = (b\n    - c)\n");
  EXPECT_EQ(FormattedLine("let a = (b\n.c)"), "let a = (b.c)");
  EXPECT_EQ(Formatted("task t\nparam a: real = 1\nin 0 .. 2\n"),
            "task t\nparam a: real = 1\n    in 0 .. 2\n");
}

TEST(Format, KeepsCommentsAtTheirPlaces) {
  EXPECT_EQ(Formatted("//a\n\n\n/// doc  \n///\n task t // b\n\n\n//c\nmemory a: int = 0\n// d"),
            "//a\n\n/// doc\n///\ntask t  // b\n\n//c\nmemory a: int = 0\n// d\n");
  EXPECT_EQ(FormattedBlock("// first\na = 1\n  // last"), "// first\na = 1\n// last\n");
  EXPECT_EQ(FormattedBlock("if a { // why\n}\n// otherwise\nelse { b = 1 }"),
            "if a {  // why\n}\n// otherwise\nelse { b = 1 }\n");
  EXPECT_EQ(FormattedBlock("let a = b + // one\n// two\nc"),
            "let a = b +  // one\n    // two\n    c\n");
  EXPECT_EQ(FormattedBlock("if a // why\n{ b = 1 }"), "if a  // why\n{ b = 1 }\n");
}

TEST(Format, AlignsTrailingComments) {
  EXPECT_EQ(FormattedBlock("a = 1 // one\nsome = 2 // two\n\nb = 1    // three"),
            "a = 1     // one\nsome = 2  // two\n\nb = 1  // three\n");
  EXPECT_EQ(FormattedBlock("end_episode failure \"größer\" // one\na = 1 // two"),
            "end_episode failure \"größer\"  // one\na = 1                         // two\n");
}

TEST(Format, KeepsTheKindOfLineEnds) {
  EXPECT_EQ(Formatted("task t // c \r\nmemory a: int = 0"),
            "task t  // c\r\nmemory a: int = 0\r\n");
}

TEST(Format, DropsAByteOrderMark) {
  EXPECT_EQ(Formatted("\xEF\xBB\xBF// c\ntask t"), "// c\ntask t\n");
}

TEST(Format, SetsFunctions) {
  EXPECT_EQ(Formatted("fn  near ( d:real[m],e : vec3 )->real [1 / s]=1/s*exp( -d/1m)\n"),
            "fn near(d: real [m], e: vec3) -> real [1/s] = 1 / s * exp(-d / 1 m)\n");
  EXPECT_EQ(Formatted("fn twice(x: real)->real\n{ let y=x return 2*y }\n"),
            "fn twice(x: real) -> real {\n  let y = x\n  return 2 * y\n}\n");
  EXPECT_EQ(Formatted("fn one() -> real { return 1 }"), "fn one() -> real { return 1 }\n");
}

TEST(Format, SetsLoops) {
  EXPECT_EQ(FormattedBlock("for l in{body,head}-feet{\na+=1 }"),
            "for l in {body, head} - feet {\n  a += 1\n}\n");
  EXPECT_EQ(FormattedLine("for i in 0 .. 3 { a[ i ]=1 }"), "for i in 0..3 { a[i] = 1 }");
  EXPECT_EQ(FormattedLine("once   per action if a{b = 1}"), "once per action if a { b = 1 }");
}

TEST(Format, SetsLogsAndRequirements) {
  EXPECT_EQ(FormattedLine("log max  speed=log ( x )"), "log max speed = log(x)");
  EXPECT_EQ(FormattedLine("require x<1\"why\""), "require x < 1 \"why\"");
  EXPECT_EQ(FormattedLine("touched [ feet ]=false"), "touched[feet] = false");
  EXPECT_EQ(FormattedLine("place . xy+=1m"), "place.xy += 1 m");
}

TEST(Format, SetsTests) {
  EXPECT_EQ(Formatted("task t\ntest   \"a\"\n{ given contact [head]=true "
                      "fire end_of_action , 100*end_of_action\n\nexpect total( fall )==-4 }"),
            "task t\ntest \"a\" {\n  given contact[head] = true\n"
            "  fire end_of_action, 100 * end_of_action\n\n  expect total(fall) == -4\n}\n");
}

TEST(Format, SetsWhatATaskChangesOfAnother) {
  EXPECT_EQ(Formatted("allow W0706 ,W0712\n\ntask t extends\"b.task\" for r\n"
                      "import   \"a.task\"  override  param a=-1 in -2..2\n"
                      "override reward rate b=1\n"
                      "override on end_of_action{}\nsensor angle:real[rad]in -180deg..180deg\n"),
            "allow W0706, W0712\n\ntask t extends \"b.task\" for r\nimport \"a.task\"\n"
            "override param a = -1 in -2 .. 2\noverride reward rate b = 1\n"
            "override on end_of_action {}\nsensor angle: real [rad] in -180 deg .. 180 deg\n");
}

TEST(Format, RefusesWhatItCannotRead) {
  Diagnostics diagnostics;
  EXPECT_FALSE(Format(SourceFile("a.task", "task t\nmemory a: = 0\n"), diagnostics));
  EXPECT_TRUE(diagnostics.has_errors());
}

}  // namespace
}  // namespace compiler
