#include "runtime/live/client/set_words.h"

#include <gmock/gmock.h>

#include "runtime/training/run/value_json.h"
#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(SetWords, AValueIsWhatItLooksLike) {
  EXPECT_EQ(ValueOfWord("0.5"), 0.5);
  EXPECT_EQ(ValueOfWord("-3"), -3);
  EXPECT_EQ(ValueOfWord("true"), true);
  EXPECT_EQ(ValueOfWord("[1, 2.5]"), json({1, 2.5}));
  EXPECT_EQ(ValueOfWord("20 s"), "20 s");
  EXPECT_EQ(ValueOfWord("standing"), "standing");
  EXPECT_EQ(ValueOfWord("null"), "null");
  EXPECT_EQ(ValueOfWord("{\"a\": 1}"), "{\"a\": 1}");
  EXPECT_EQ(ValueOfWord("\"0.5\""), "\"0.5\"");
}

TEST(SetWords, ANameAndItsValue) {
  const json expected = {{"name", "task.gain"}, {"value", 0.5}};
  EXPECT_EQ(SetArguments({"task.gain", "0.5"}), expected);
  EXPECT_EQ(SetArguments({"task.gain", "=", "0.5"}), expected);
  EXPECT_EQ(SetArguments({"task.gain=0.5"}), expected);
  EXPECT_EQ(SetArguments({"task.gain =0.5"}), expected);
  EXPECT_EQ(SetArguments({"task.gain", "-0.5"})["value"], -0.5);
  EXPECT_EQ(SetArguments({"task.limit", "20", "s"})["value"], "20 s");
  EXPECT_EQ(SetArguments({"task.limit", "-20 deg"})["value"], "-20 deg");
  EXPECT_EQ(SetArguments({"a.b", "total"})["value"], "total");
}

TEST(SetWords, ASchedule) {
  const json expected = {{"name", "task.gain"}, {"from", 0.1}, {"to", 0.5}, {"episodes", 200}};
  EXPECT_EQ(SetArguments({"task.gain", "=", "0.1", "to", "0.5", "over", "200", "episodes"}),
            expected);
  EXPECT_EQ(SetArguments({"task.gain = 0.1 -> 0.5 over 200 episodes"}), expected);
  EXPECT_EQ(SetArguments({"task.gain", "=", "0.1", "→", "0.5", "over", "200", "episodes"}),
            expected);
  EXPECT_EQ(SetArguments({"task.gain", "0.1", "to", "0.5", "over", "200", "episodes"}), expected);
  EXPECT_EQ(SetArguments({"task.gain=0.1→0.5", "over", "200", "episodes"}), expected);
  EXPECT_EQ(SetArguments({"a.b", "-1", "to", "-2", "over", "1", "episode"}),
            (json{{"name", "a.b"}, {"from", -1.0}, {"to", -2.0}, {"episodes", 1}}));
}

TEST(SetWords, WhatIsNeitherIsExplained) {
  const auto error = [](const std::vector<std::string>& words) {
    return ErrorOf([&] { SetArguments(words); });
  };
  EXPECT_THAT(error({}), HasSubstr("write `set NAME VALUE`"));
  EXPECT_THAT(error({"task.gain"}), HasSubstr("write `set NAME VALUE`"));
  EXPECT_THAT(error({"task.gain", "="}), HasSubstr("write `set NAME VALUE`"));
  // The shell has taken `> 0.5` for a file.
  EXPECT_THAT(error({"task.gain", "=", "0.1", "-", "over", "200", "episodes"}),
              HasSubstr("only in quotes"));
  EXPECT_THAT(error({"a.b", "1", "to", "x", "over", "2", "episodes"}),
              HasSubstr("`x` is not a number"));
  EXPECT_THAT(error({"a.b", "1", "to", "2", "over", "99999999999999999999", "episodes"}),
              HasSubstr("too many"));
}

}  // namespace
}  // namespace runtime
