#include "runtime/analysis/preference/task_params.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(ParseTaskParams, ReadsWhatTaskcDocPrints) {
  const TaskParams task = ParseTaskParams(R"({
    "task": "crawling", "file": "tasks/crawling.task", "hash": "f9fee327", "robot": "humanoid",
    "params": [
      {"name": "fall_penalty", "doc": "", "unit": "", "default": 4.0, "least": 0.0,
       "greatest": 20.0, "scales": ["fall"], "changes_course": true},
      {"name": "strict", "doc": "", "unit": "", "default": true, "least": null, "greatest": null,
       "scales": [], "changes_course": false}],
    "terms": [{"name": "fall", "doc": "", "weight": "fall_penalty"}], "metrics": []})");
  EXPECT_EQ(task.task_hash, "f9fee327");
  ASSERT_THAT(task.params, SizeIs(2));
  EXPECT_EQ(task.params[0].name, "fall_penalty");
  EXPECT_EQ(task.params[0].initial, 4);
  EXPECT_EQ(task.params[0].greatest, 20);
  EXPECT_THAT(task.params[0].scales, ElementsAre("fall"));
  EXPECT_TRUE(task.params[0].changes_course);
  EXPECT_EQ(task.params[1].initial, 1);
  EXPECT_EQ(task.params[1].least, -std::numeric_limits<double>::infinity());
  EXPECT_THAT(task.params[1].scales, IsEmpty());
}

TEST(ParseTaskParams, AnotherTextIsRefused) {
  for (const char* text : {"", "{}", R"({"hash": "1", "params": [{"name": 3}]})"}) {
    EXPECT_THAT(ErrorOf([&] { ParseTaskParams(text); }), HasSubstr("cannot be understood")) << text;
  }
}

}  // namespace
}  // namespace runtime
