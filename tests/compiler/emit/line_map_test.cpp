#include "compiler/emit/line_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "compiler/emit/emit.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

TEST(LineMap, JoinsNeighboringLines) {
  EXPECT_EQ(LineMap({{7, {"a.task", 12}},
                     {8, {"a.task", 12}},
                     {9, {"a.task", 3}},
                     {11, {"a.task", 12}},
                     {12, {"library.task", 1}}}),
            "a.task:3        9\n"
            "a.task:12       7-8, 11\n"
            "library.task:1  12\n");
  EXPECT_EQ(LineMap({}), "");
}

TEST(LineMap, PointsAtWhatALineHasBecome) {
  CheckedSource checked("a.task",
                        "task a\nsensor x: real\non end_of_action {\n  reward near = -x\n"
                        "  if x > 3 { end_episode success \"far\" }\n}\n");
  ASSERT_TRUE(checked.task);
  const EmittedText emitted = EmitWithOrigins(*checked.task, checked.sources);
  std::vector<std::string> lines;
  std::istringstream stream(emitted.text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const auto becomes = [&](uint32_t line, const std::string& text) {
    return std::ranges::any_of(emitted.origins, [&](const LineOrigin& origin) {
      return origin.source == SourceLine{"a.task", line} &&
             lines.at(origin.line - 1).find(text) != std::string::npos;
    });
  };
  EXPECT_TRUE(becomes(3, "void end_of_action("));
  EXPECT_TRUE(becomes(4, "Pay(frame, reward, term_near, -x);"));
  EXPECT_TRUE(becomes(5, "if (x > 3.0) {"));
  EXPECT_TRUE(becomes(5, "End(frame, 0);"));
  EXPECT_FALSE(becomes(4, "End(frame, 0);"));
}

}  // namespace
}  // namespace compiler
