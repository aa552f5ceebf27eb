#include "runtime/analysis/study/group_notes.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class ReadGroupNotesTest : public testing::Test {
 protected:
  void Write(const std::string& text) { std::ofstream(folder_.path() / "groups.toml") << text; }

  TemporaryFolder folder_;
};

TEST_F(ReadGroupNotesTest, AreNoneWithoutTheFile) {
  EXPECT_THAT(ReadGroupNotes(folder_.path()), IsEmpty());
}

TEST_F(ReadGroupNotesTest, AreSentencesByTheNamesOfRuns) {
  Write("\"jumping/seed3\" = \"It jumps.\"\nseed1 = \"It rests.\"\n");
  EXPECT_THAT(ReadGroupNotes(folder_.path()),
              ElementsAre(Pair("jumping/seed3", "It jumps."), Pair("seed1", "It rests.")));
}

TEST_F(ReadGroupNotesTest, MistakesAreShownWithTheirPlace) {
  Write("a = \"fine\"\nb = 3\n");
  EXPECT_THAT(ErrorOf([&] { ReadGroupNotes(folder_.path()); }),
              AllOf(HasSubstr("groups.toml:2:"), HasSubstr("expected a sentence")));
  Write("a = \n");
  EXPECT_THAT(ErrorOf([&] { ReadGroupNotes(folder_.path()); }), HasSubstr("groups.toml:1:"));
}

}  // namespace
}  // namespace runtime
