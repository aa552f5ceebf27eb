#include "runtime/analysis/preference/preferences_file.h"

#include <gmock/gmock.h>

#include <fstream>

#include "runtime/training/run/run_files.h"
#include "tests/runtime/analysis/preference/over.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class PreferencesFileTest : public testing::Test {
 protected:
  const std::filesystem::path& folder() const { return folder_.path(); }
  std::filesystem::path file() const { return folder() / "preferences.toml"; }
  void Write(const std::string& text) const { std::ofstream(file()) << text; }
  std::string Error() const {
    return ErrorOf([&] { ReadPreferences(folder()); });
  }

 private:
  TemporaryFolder folder_;
};

TEST(BehaviorName, IsARunOrOneOfItsEpisodes) {
  EXPECT_EQ(ParseBehaviorName("crawling/seed1"), (BehaviorName{"crawling/seed1", {}}));
  EXPECT_EQ(ParseBehaviorName("crawling/seed1:1200"), (BehaviorName{"crawling/seed1", 1200}));
  EXPECT_EQ(ParseBehaviorName("at 12:x"), (BehaviorName{"at 12:x", {}}));
  EXPECT_EQ(ParseBehaviorName("crawling/seed1:1200").text(), "crawling/seed1:1200");
}

TEST_F(PreferencesFileTest, HoldsNoneWhereThereIsNoFile) {
  EXPECT_THAT(ReadPreferences(folder()), IsEmpty());
}

TEST_F(PreferencesFileTest, WhatIsAddedIsReadAgain) {
  Preference tie = Over("seed2", "seed4:12");
  tie.is_tie = true;
  EXPECT_EQ(AddPreferences(folder(), {Over("it's \"one\"\\", "seed1"), tie}), 2u);
  EXPECT_EQ(AddPreferences(folder(), {Over("seed1", "seed2")}), 1u);
  const std::vector<Preference> preferences = ReadPreferences(folder());
  ASSERT_THAT(preferences, SizeIs(3));
  EXPECT_EQ(preferences[0].better.run, "it's \"one\"\\");
  EXPECT_FALSE(preferences[0].is_tie);
  EXPECT_EQ(preferences[0].line, 3);
  EXPECT_EQ(preferences[1].worse, (BehaviorName{"seed4", 12}));
  EXPECT_TRUE(preferences[1].is_tie);
  EXPECT_EQ(preferences[2].text(), "seed1 over seed2");
}

TEST_F(PreferencesFileTest, WhatIsThereStaysAsItIs) {
  const std::string old = "# mine\n[[preference]]\nworse = 'b' # falls\nbetter = 'a'";
  Write(old);
  EXPECT_EQ(AddPreferences(folder(), {Over("a", "c")}), 1u);
  EXPECT_THAT(ReadText(file()), testing::StartsWith(old + "\n\n[[preference]]\n"));
  EXPECT_THAT(ReadPreferences(folder()), SizeIs(2));
}

TEST_F(PreferencesFileTest, WhatIsSaidTwiceCountsOnce) {
  Preference tie = Over("c", "d");
  tie.is_tie = true;
  AddPreferences(folder(), {Over("a", "b"), tie});
  std::swap(tie.better, tie.worse);
  const std::string before = ReadText(file());
  EXPECT_EQ(AddPreferences(folder(), {Over("a", "b"), tie}), 0u);
  EXPECT_EQ(ReadText(file()), before);
  EXPECT_EQ(AddPreferences(folder(), {Over("b", "a"), Over("b", "a")}), 1u);
}

TEST_F(PreferencesFileTest, MistakesAreShownWithTheirPlace) {
  const std::pair<std::string, std::string> mistakes[] = {
      {"[[preference]]\nbetter = \n", "preferences.toml:2:"},
      {"x = 1\n", "preferences.toml:1:5: expected statements"},
      {"[preference]\nbetter = 'a'\n", "expected statements"},
      {"\n[[preference]]\nbetter = 'a'\n", "preferences.toml:2:1: a [[preference]] has `better`"},
      {"[[preference]]\nbetter = 'a'\nworse = 'b'\nwhy = 'c'\n", "has `better` and `worse`"},
      {"[[preference]]\nequal = ['a']\n", "has `better` and `worse`, or `equal"},
      {"[[preference]]\nbetter = 'a'\nworse = 3\n", "preferences.toml:3:9: expected the name"},
      {"[[preference]]\nbetter = 'a'\nworse = 'a'\n", "compared with itself"},
  };
  for (const auto& [text, message] : mistakes) {
    Write(text);
    EXPECT_THAT(Error(), HasSubstr(message)) << text;
  }
}

TEST_F(PreferencesFileTest, NothingIsAddedToAFileWithAMistake) {
  Write("[[preference]]\n");
  EXPECT_THAT(ErrorOf([&] { AddPreferences(folder(), {Over("a", "b")}); }),
              HasSubstr("preferences.toml:1:1"));
  EXPECT_EQ(ReadText(file()), "[[preference]]\n");
}

}  // namespace
}  // namespace runtime
