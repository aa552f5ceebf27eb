#include "compiler/mend/mend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/analyze/analyze.h"
#include "compiler/mend/mended_text.h"
#include "tests/compiler/compose/file_set.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Key;
using testing::Pair;

bool Any(const std::string&) { return true; }

Mending MendMain(const FileSet& files,
                 const std::function<bool(const std::string&)>& may_change = Any) {
  return Mend("main.task", ReaderOf(files), SOURCE_DIR "/plugins", may_change);
}

size_t ErrorsOf(const std::string& file, const FileSet& files) {
  const Analysis analysis = Analyze(file, ReaderOf(files), SOURCE_DIR "/plugins");
  return static_cast<size_t>(
      std::ranges::count(analysis.diagnostics.list(), Severity::kError, &Diagnostic::severity));
}

TEST(MendedText, HoldsThoseFixesThatTouchNoOther) {
  const SourceFile file("a.task", "abcdef", 100);
  const std::vector<Fix> fixes =
      Apart({{{100, 101}, "X"}, {{101, 102}, "Y"}, {{103, 103}, "-"}, {{105, 106}, ""}});
  ASSERT_EQ(fixes.size(), 3u);
  EXPECT_EQ(WithFixes(file, fixes), "Xbc-de");
  EXPECT_EQ(WithFixes(file, {}), "abcdef");
}

TEST(Mend, AppliesWhatHasOnlyOneFix) {
  const Mending mending = MendMain({{"main.task", R"(task main for humanoid
on end_of_time_step {
  reward up = base.postion.z / 1 m
  if tme > 2 s { truncate_episode "time is up" }
}
)"}});
  ASSERT_EQ(mending.mended.size(), 2u);
  EXPECT_EQ(mending.mended[1].before, "tme");
  EXPECT_EQ(mending.mended[1].after, "time");
  EXPECT_EQ(mending.mended[1].place, (Position{4, 6}));
  EXPECT_EQ(mending.mended[1].code, code::kUnknownName);
  EXPECT_THAT(mending.texts, ElementsAre(Pair("main.task", R"(task main for humanoid
on end_of_time_step {
  reward up = base.position.z / 1 m
  if time > 2 s { truncate_episode "time is up" }
}
)")));
}

// The name is looked up only once its statement can be read.
TEST(Mend, MendsWhatMendingBringsToLight) {
  const Mending mending = MendMain({{"main.task", R"(task main for humanoid
on end_of_time_step {
  var height = base.postion.z
  reward up = height / 1 m
  if time > 2 s { truncate_episode "time is up" }
}
)"}});
  ASSERT_EQ(mending.mended.size(), 2u);
  EXPECT_EQ(mending.mended[0].after, "let");
  EXPECT_EQ(mending.mended[1].after, "base.position");
  EXPECT_EQ(ErrorsOf("main.task", mending.texts), 0u);
}

TEST(Mend, LeavesAChoiceToTheAuthor) {
  EXPECT_THAT(MendMain({{"main.task", R"(task main for humanoid
on end_of_time_step {
  reward up = 1
  if time > 2 s { end_episode "time is up" }
}
)"}}).texts,
              IsEmpty());
}

// It would pay something else.
TEST(Mend, LeavesATaskThatCompiles) {
  const FileSet files = {{"main.task", R"(task main for humanoid
param unused: real = 1 in 0 .. 2
on end_of_time_step { reward up = base.position.z / 1 m }
)"}};
  EXPECT_EQ(ErrorsOf("main.task", files), 0u);
  EXPECT_THAT(MendMain(files).texts, IsEmpty());
}

TEST(Mend, MendsWhatATaskImportsOnlyWhereItMay) {
  const FileSet files = {{"main.task", R"(task main for humanoid
import "lib.task"
on end_of_time_step {
  reward up = twice(base.postion.z / 1 m)
  if time > 2 s { truncate_episode "time is up" }
}
)"},
                         {"lib.task", "fn twice(x: real) -> real = 2 * X\n"}};
  EXPECT_THAT(MendMain(files).texts, ElementsAre(Key("lib.task"), Key("main.task")));
  const Mending own = MendMain(files, [](const std::string& file) { return file == "main.task"; });
  EXPECT_THAT(own.texts, ElementsAre(Key("main.task")));
}

TEST(Mend, KnowsWhatIsNotTheUsers) {
  EXPECT_TRUE(IsOwnFile(SOURCE_DIR "/tasks/crawling.task"));
  EXPECT_FALSE(IsOwnFile("absent.task"));
}

// All that the compiler has ever been tested with.
TEST(Mend, NeverLeavesMoreErrors) {
  size_t changed = 0;
  size_t mended = 0;
  for (const char* folder : {"syntax", "check", "analyze"}) {
    const std::filesystem::path messages = SOURCE_DIR "/tests/compiler";
    for (const auto& path : golden::FilesIn(messages / folder / "messages", "", ".task")) {
      const FileSet files = {{"main.task", golden::ReadInput(path)}};
      const Mending mending = MendMain(files);
      if (mending.texts.empty()) continue;
      ++changed;
      const size_t errors = ErrorsOf("main.task", mending.texts);
      EXPECT_LE(errors, ErrorsOf("main.task", files)) << path;
      EXPECT_THAT(MendMain(mending.texts).texts, IsEmpty()) << path << ": all was mended at once";
      if (errors == 0) ++mended;
    }
  }
  EXPECT_GT(changed, 50u);
  EXPECT_GT(mended, 5u) << "most of them hold something that only their author can mend";
}

}  // namespace
}  // namespace compiler
