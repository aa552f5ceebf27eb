#include "runtime/live/control/journal.h"

#include <gmock/gmock.h>

#include "runtime/training/run/change_json.h"
#include "tests/runtime/live/control/small_agent.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr RunPosition kEnd{1'000'000, 0};
const Change kSet = SetParameter{"task.limit", int64_t{1}};

class JournalTest : public testing::Test {
 protected:
  static std::vector<std::string> TakeAll(Journal& journal, const RunPosition& position) {
    std::vector<std::string> texts;
    while (const auto change = journal.TakeDue(position)) texts.push_back(change->record.text);
    return texts;
  }
  void Add(Journal& journal, const RunPosition& position, const std::string& text,
           const Change& change = kSet) {
    journal.AddDue(position, change, text, nullptr);
  }

  TemporaryFolder folder_;
  RunDatabase database_ = RunDatabase::Create(folder_.path() / "run", SampleRun());
  Journal journal_{database_};
};

TEST_F(JournalTest, ChangesAreDueAtTheirPosition) {
  Add(journal_, {3, 0}, "third");
  EXPECT_FALSE(journal_.has_due({2, 500}));
  EXPECT_EQ(journal_.TakeDue({2, 500}), std::nullopt);
  EXPECT_TRUE(journal_.has_due({3, 0}));
  EXPECT_THAT(TakeAll(journal_, {3, 0}), ElementsAre("third"));
  EXPECT_FALSE(journal_.has_due(kEnd));
}

TEST_F(JournalTest, TheyComeByPositionAndThenInTheOrderInWhichTheyWereMade) {
  Add(journal_, {5, 0}, "e");  // in the next episode
  Add(journal_, {4, 7}, "a");
  Add(journal_, {4, 7}, "b");
  Add(journal_, {5, 0}, "f");
  Add(journal_, {4, 9}, "c");
  Add(journal_, {4, 10}, "d");
  EXPECT_THAT(TakeAll(journal_, {4, 9}), ElementsAre("a", "b", "c"));
  EXPECT_THAT(TakeAll(journal_, kEnd), ElementsAre("d", "e", "f"));
}

TEST_F(JournalTest, WhatIsDoneAlreadyIsOnlyWrittenDown) {
  Add(journal_, {2, 0}, "later");
  const ChangeRecord added = journal_.AddDone({1, 4}, kSet, "now");
  EXPECT_EQ(added.id, 2);
  EXPECT_EQ(added.episode, 1);
  EXPECT_EQ(added.step, 4);
  EXPECT_FALSE(journal_.has_due({1, 4}));
  Journal again(database_);
  EXPECT_THAT(TakeAll(again, kEnd), ElementsAre("now", "later"));
}

TEST_F(JournalTest, WhatTakesEffectLaterStandsWhereItDoes) {
  Add(journal_, {4, 0}, "b");
  Add(journal_, {3, 700}, "a");
  Add(journal_, {4, 0}, "c");
  Add(journal_, {4, 3}, "e");
  for (const char* text : {"a", "b", "c"}) {
    const std::optional<DueChange> change = journal_.TakeDueNow({4, 0});
    ASSERT_TRUE(change.has_value());
    EXPECT_EQ(change->record.text, text);
    EXPECT_EQ(change->position(), (RunPosition{4, 0}));
  }
  EXPECT_EQ(journal_.TakeDueNow({4, 2}), std::nullopt);
  journal_.AddDone({4, 2}, kSet, "d");
  EXPECT_EQ(journal_.TakeDueNow({4, 3})->record.id, 4);  // where it stood
  Journal again(database_);
  EXPECT_FALSE(again.has_due({3, 700}));
  EXPECT_THAT(TakeAll(again, {4, 0}), ElementsAre("a", "b", "c"));
  EXPECT_THAT(TakeAll(again, kEnd), ElementsAre("d", "e"));
}

TEST_F(JournalTest, APluginWaitsWithItsChange) {
  const auto plugin = std::make_shared<const Plugin>(PluginFile("other"));
  journal_.AddDue({3, 0}, SwapTask{"task", 1}, "swap", plugin);
  EXPECT_EQ(journal_.TakeDueNow({3, 0})->plugin, plugin);
  EXPECT_EQ(plugin.use_count(), 1);
  EXPECT_EQ(Journal(database_).TakeDue({3, 0})->plugin, nullptr);
}

TEST_F(JournalTest, WhatCouldNotBeDoneIsTakenOutOfIt) {
  journal_.AddDone({1, 1}, kSet, "good");
  journal_.Remove(journal_.AddDone({1, 2}, kSet, "bad"));
  journal_.AddDone({1, 3}, kSet, "better");
  Journal again(database_);
  EXPECT_THAT(TakeAll(again, kEnd), ElementsAre("good", "better"));
}

TEST_F(JournalTest, IsReadAgainInTheSameOrder) {
  Add(journal_, {5, 0}, "c");
  Add(journal_, {4, 7}, "a");
  Add(journal_, {4, 8}, "b");
  Journal again(database_);
  EXPECT_THAT(TakeAll(again, {4, 7}), ElementsAre("a"));
  EXPECT_THAT(TakeAll(again, kEnd), ElementsAre("b", "c"));
}

TEST_F(JournalTest, AChangeInQuarantineIsNeverDoneAgain) {
  Add(journal_, {4, 7}, "bad");
  Add(journal_, {4, 7}, "good");
  journal_.Quarantine({4, 9}, database_.ReadChanges().front(), "it broke the net");
  EXPECT_THAT(TakeAll(journal_, kEnd), ElementsAre("good"));
  ASSERT_THAT(journal_.passed_over(), SizeIs(1));
  EXPECT_EQ(journal_.passed_over().front().text, "bad");
  Journal again(database_);
  EXPECT_THAT(TakeAll(again, kEnd), ElementsAre("good"));
  const ChangeRecord written = database_.ReadChanges().back();
  EXPECT_EQ(ChangeData(written.change),
            R"({"change":1,"command":"quarantine","why":"it broke the net"})");
  EXPECT_EQ(written.text, "taken back: bad (it broke the net)");
  EXPECT_EQ(written.episode, 4);
  EXPECT_EQ(written.step, 9);
}

TEST_F(JournalTest, NorIsAnyThatBringsATaskInQuarantine) {
  RunDatabase& database = database_;
  ASSERT_EQ(database.AddTask(SampleVersion()), 2);
  database.AddEpisode(SampleEpisode(1), {}, {});
  Add(journal_, {1, 3}, "swap to 2", SwapTask{"task", 2});
  Add(journal_, {1, 4}, "back to 1", RollBackTask{"task", 1});
  Add(journal_, {1, 5}, "set", kSet);
  Add(journal_, {1, 6}, "back to 2", RollBackTask{"task", 2});
  QuarantineTask(database, 2, "crash: Segmentation fault");
  Journal again(database);
  EXPECT_THAT(again.bad_tasks(), ElementsAre(2));
  EXPECT_THAT(TakeAll(again, kEnd), ElementsAre("back to 1", "set"));
  const ChangeRecord written = database.ReadChanges().back();
  EXPECT_EQ(ChangeData(written.change),
            R"({"command":"quarantine","task":2,"why":"crash: Segmentation fault"})");
  EXPECT_EQ(written.text, "never again: crawling (crash: Segmentation fault)");
  EXPECT_EQ(written.episode, 2);
  EXPECT_EQ(written.step, 0);
}

TEST_F(JournalTest, BeforeTheFirstEpisodeATaskGoesIntoQuarantineAtItsStart) {
  QuarantineTask(database_, 1, "loop");
  EXPECT_EQ(database_.ReadChanges().back().episode, 1);
  EXPECT_THAT(Journal(database_).bad_tasks(), ElementsAre(1));
  EXPECT_FALSE(Journal(database_).has_due(kEnd));
}

}  // namespace
}  // namespace runtime
