#include "runtime/live/client/reply_text.h"

#include <gtest/gtest.h>

namespace runtime {
namespace {

using nlohmann::json;

TEST(ReplyText, AnObjectIsARowForEachMember) {
  EXPECT_EQ(ReplyText({{"state", "running"},
                       {"episode", 12},
                       {"speed", 45.125},
                       {"zeal", true},
                       {"best_return", nullptr},
                       {"task", "crawling"}}),
            "task         crawling\n"
            "state        running\n"
            "episode      12\n"
            "speed        45.125\n"
            "best_return  -\n"
            "zeal         yes\n");
}

TEST(ReplyText, AListOfObjectsIsATable) {
  EXPECT_EQ(ReplyText({{{"name", "gain"}, {"value", 0.5}, {"unit", "m"}},
                       {{"name", "größe"}, {"value", 10}, {"doc", "how large"}}}),
            "name   value  unit  doc\n"
            "gain   0.5    m     -\n"
            "größe  10     -     how large\n");
}

TEST(ReplyText, TablesWithinComeBelow) {
  const json task = {{"module", "task"},
                     {"hash", "0123456789abcdef"},
                     {"params", {{{"name", "gain"}, {"value", 1}}}},
                     {"terms", {{"forward", 12.5}, {"effort", -0.25}}},
                     {"ports", {"reward", "end"}}};
  EXPECT_EQ(ReplyText({{"tasks", {task}}, {"schedules", json::array()}}),
            "schedules  -\n"
            "\ntasks:\n"
            "module  terms                       hash      ports\n"
            "task    effort -0.25, forward 12.5  01234567  reward, end\n"
            "\ntask params:\n"
            "name  value\n"
            "gain  1\n");
}

TEST(ReplyText, ATextIsAsItIs) {
  EXPECT_EQ(ReplyText("digraph {\n}\n"), "digraph {\n}\n");
  EXPECT_EQ(ReplyText("saved"), "saved\n");
  EXPECT_EQ(ReplyText(0.5), "0.5\n");
  EXPECT_EQ(ReplyText(nullptr), "");
  EXPECT_EQ(ReplyText({{"text", "digraph {\n}\n"}}), "digraph {\n}\n");
  EXPECT_EQ(ReplyText({{"task", "crawling"}, {"messages", "warning: a\nwarning: b\n"}}),
            "task  crawling\n\nmessages:\nwarning: a\nwarning: b\n");
}

TEST(EventLine, IsOneLineForEachKind) {
  EXPECT_EQ(EventLine({{"event", "episode"},
                       {"episode", 12},
                       {"task", "crawling"},
                       {"return", 3.25},
                       {"end", {{"kind", "truncated"}, {"reason", "time is up"}}},
                       {"shadows", {{"careful", {{"return", nullptr}}}}}}),
            "episode 12: crawling returns 3.25 (truncated: time is up), careful -");
  EXPECT_EQ(EventLine({{"event", "change"},
                       {"id", 2},
                       {"episode", 13},
                       {"step", 0},
                       {"text", "swap task: crawling.task (a1b2c3d4)"}}),
            "change 2 in episode 13, step 0: swap task: crawling.task (a1b2c3d4)");
  EXPECT_EQ(EventLine({{"event", "state"}, {"state", "paused"}}), "the run is paused");
  EXPECT_EQ(EventLine({{"event", "warning"}, {"text", "it is late"}}), "warning: it is late");
  EXPECT_EQ(EventLine({{"event", "missed"}, {"count", 3}}), "3 events were missed");
  EXPECT_EQ(EventLine({{"event", "new"}, {"a", 1}}), R"({"a":1,"event":"new"})");
}

}  // namespace
}  // namespace runtime
