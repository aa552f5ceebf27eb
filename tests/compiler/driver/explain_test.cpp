#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/source/diagnostic_table.h"
#include "tests/compiler/driver/taskc_process.h"

namespace compiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Explain, ShowsTheSectionOfACode) {
  TaskcProcess taskc;
  Outcome outcome = taskc.Run("explain E0103");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(
      outcome.out,
      "E0103: a string is not closed\n\n"
      "A string begins and ends with `\"` on the same line. A quotation mark inside is written "
      "`\\\"`.\n\n"
      "    truncate_episode \"time is up\n\n"
      "    truncate_episode \"time is up\"\n");
  EXPECT_EQ(taskc.Run("explain e0103").out, outcome.out);
}

TEST(Explain, ShowsSeveral) {
  TaskcProcess taskc;
  EXPECT_THAT(taskc.Run("explain W0706 E0101").out,
              AllOf(StartsWith("W0706: "), HasSubstr("\n\n\nE0101: ")));
}

TEST(Explain, KnowsEveryCode) {
  TaskcProcess taskc;
  std::string list = taskc.Run("explain").out;
  std::string codes;
  for (const DiagnosticKind& kind : kDiagnosticTable) {
    EXPECT_THAT(list, HasSubstr(std::string(kind.code) + "  " + std::string(kind.title) + "\n"));
    codes += " " + std::string(kind.code);
  }
  EXPECT_EQ(static_cast<size_t>(std::ranges::count(list, '\n')), std::size(kDiagnosticTable));
  Outcome all = taskc.Run("explain" + codes);
  EXPECT_EQ(all.status, 0);
  EXPECT_EQ(all.error, "");
  EXPECT_THAT(all.out, AllOf(Not(HasSubstr("```")), Not(HasSubstr("##"))));
}

TEST(Explain, SuggestsACodeForAnUnknownOne) {
  TaskcProcess taskc;
  Outcome outcome = taskc.Run("explain E02O3");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(
      outcome.error,
      "taskc: there is no code `E02O3`; did you mean `E0203`? `taskc explain` lists them all\n");
}

}  // namespace
}  // namespace compiler
