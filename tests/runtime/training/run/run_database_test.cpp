#include "runtime/training/run/run_database.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <thread>

#include "runtime/training/run/change_json.h"
#include "runtime/training/run/sqlite.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/sample_run.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class RunDatabaseTest : public testing::Test {
 protected:
  std::filesystem::path folder() const { return parent_.path() / "run"; }
  std::filesystem::path file() const { return folder() / "run.db"; }

  TemporaryFolder parent_;
};

TEST_F(RunDatabaseTest, GivesBackWhatTheRunIs) {
  const RunRecord written = SampleRun();
  RunDatabase::Create(folder(), written);
  const RunRecord read = RunDatabase::OpenToRead(folder()).ReadRun();
  EXPECT_EQ(read.robot, written.robot);
  EXPECT_EQ(read.robot_description, written.robot_description);
  EXPECT_EQ(read.agent, written.agent);
  EXPECT_EQ(read.profile, written.profile);
  EXPECT_EQ(read.version, written.version);
  EXPECT_EQ(read.body, written.body);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.episodes_planned, written.episodes_planned);
  EXPECT_EQ(read.record_every, written.record_every);
  EXPECT_EQ(read.checkpoint_seconds, written.checkpoint_seconds);
  EXPECT_EQ(read.tasks.size(), 1u);
}

void ExpectSampleTask(const TaskRecord& read) {
  const TaskRecord written = SampleTask();
  EXPECT_EQ(read.module, written.module);
  EXPECT_EQ(read.task, written.task);
  EXPECT_EQ(read.task_file, written.task_file);
  EXPECT_EQ(read.task_hash, written.task_hash);
  EXPECT_EQ(read.plugin, written.plugin);
  EXPECT_EQ(read.compiler, written.compiler);
  ASSERT_EQ(read.terms.size(), 2u);
  EXPECT_EQ(read.terms[0].name, "speed");
  EXPECT_EQ(read.terms[0].doc, "forward speed");
  EXPECT_EQ(read.terms[1].name, "fall");
  ASSERT_EQ(read.metrics.size(), 1u);
  EXPECT_EQ(read.metrics[0].name, "distance");
  EXPECT_EQ(read.metrics[0].unit, "m");
  EXPECT_EQ(read.metrics[0].reduction, "last");
  EXPECT_EQ(read.metrics[0].doc, "how far it got");
  ASSERT_EQ(read.logs.size(), 2u);
  EXPECT_EQ(read.logs[0].name, "speed");
  EXPECT_EQ(read.logs[0].unit, "m/s");
  EXPECT_EQ(read.logs[1].reduction, "sum");
  ASSERT_EQ(read.goals.size(), 1u);
  EXPECT_EQ(read.goals[0].name, "place");
  EXPECT_EQ(read.goals[0].type, "vec2");
  EXPECT_EQ(read.goals[0].unit, "m");
  EXPECT_EQ(read.goals[0].doc, "where to go");
  ASSERT_EQ(read.phases.size(), 2u);
  EXPECT_EQ(read.phases[0].name, "reach");
  EXPECT_EQ(read.phases[0].doc, "get there");
  ASSERT_EQ(read.sources.size(), 2u);
  EXPECT_EQ(read.sources[0].text, written.sources[0].text);
  EXPECT_EQ(read.sources[1].file, "tasks/shaping.task");
}

TEST_F(RunDatabaseTest, GivesBackTheTasksInTheOrderOfLoading) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  TaskRecord version = SampleVersion();
  version.id = 0;
  EXPECT_EQ(database.AddTask(version), 2);
  EXPECT_EQ(database.AddTask(SampleTask()), 3);
  const RunRecord run = RunDatabase::OpenToRead(folder()).ReadRun();
  ASSERT_EQ(run.tasks.size(), 3u);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(run.tasks[i].id, static_cast<int64_t>(i + 1));
  ExpectSampleTask(run.tasks[0]);
  EXPECT_EQ(run.tasks[1].task_hash, version.task_hash);
  EXPECT_EQ(run.tasks[1].terms.size(), 3u);
  EXPECT_TRUE(run.tasks[1].logs.empty());
  ExpectSampleTask(TaskWithId(run, 3));
}

TEST_F(RunDatabaseTest, KeepsWhatShadowsSayApartFromTheActiveTask) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  database.AddTask(SampleVersion());
  EpisodeRecord promoted = SampleEpisode(2);  // now the first task is a shadow of the second
  promoted.shadows = {promoted.active};
  promoted.active = SampleShadow();
  EpisodeRecord shadowed = SampleEpisode(1);
  shadowed.shadows = {SampleShadow()};
  database.AddEpisode(shadowed, {}, {});
  database.AddEpisode(promoted, {}, {});
  database.AddEpisode(SampleEpisode(3), {}, {});

  const std::vector<EpisodeRecord> read = RunDatabase::OpenToRead(folder()).ReadEpisodes();
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].active.task, 1);
  EXPECT_EQ(read[0].active.terms, shadowed.active.terms);
  EXPECT_EQ(read[0].active.goals, shadowed.active.goals);
  EXPECT_EQ(read[0].active.phases, shadowed.active.phases);
  ASSERT_EQ(read[0].shadows.size(), 1u);
  const Evaluation& shadow = read[0].shadows[0];
  EXPECT_EQ(shadow.task, 2);
  EXPECT_EQ(shadow.episode_return, -1.5);
  EXPECT_EQ(shadow.end_kind, "failure");
  EXPECT_EQ(shadow.end_reason, "fell");
  EXPECT_EQ(shadow.violations, 1);
  EXPECT_EQ(shadow.terms, SampleShadow().terms);
  EXPECT_EQ(shadow.metrics, SampleShadow().metrics);
  EXPECT_TRUE(shadow.logs.empty());
  EXPECT_EQ(read[1].active.task, 2);
  EXPECT_EQ(read[1].active.terms, SampleShadow().terms);
  ASSERT_EQ(read[1].shadows.size(), 1u);
  EXPECT_EQ(read[1].shadows[0].task, 1);
  EXPECT_EQ(read[1].shadows[0].logs, SampleEpisode(2).active.logs);
  EXPECT_TRUE(read[2].shadows.empty());
}

TEST_F(RunDatabaseTest, GivesBackChangesAndKeepsThemWhenEpisodesAreDeleted) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  database.AddEpisode(SampleEpisode(1), {}, {});
  const ChangeRecord set{0,
                         1,
                         250,
                         "2026-01-02T03:04:05Z",
                         SetParameter{"task.gain", int64_t{2}},
                         "set task.gain = 2"};
  const ChangeRecord swap{
      0, 2, 0, "2026-01-02T03:04:06Z", SwapTask{"task", 1}, "swap task: a \"b\""};
  const ChangeRecord unload{0, 3, 0, "", UnloadShadow{"careful"}, "unload careful"};
  EXPECT_EQ(database.AddChange(set), 1);
  EXPECT_EQ(database.AddChange(swap), 2);
  EXPECT_EQ(database.AddChange(unload), 3);
  database.DeleteEpisodesAfter(0);
  const std::vector<ChangeRecord> read = RunDatabase::OpenToRead(folder()).ReadChanges();
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].id, 1);
  EXPECT_EQ(read[0].episode, 1);
  EXPECT_EQ(read[0].step, 250);
  EXPECT_EQ(read[0].at, set.at);
  EXPECT_EQ(ChangeData(read[0].change), ChangeData(set.change));
  EXPECT_EQ(read[1].id, 2);
  EXPECT_EQ(read[1].text, swap.text);
  EXPECT_EQ(ChangeData(read[1].change), ChangeData(swap.change));
  EXPECT_THAT(read[2].at, testing::MatchesRegex("20..-..-..T..:..:..Z"));
}

TEST_F(RunDatabaseTest, GivesBackEpisodesBitForBit) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  EpisodeRecord second = SampleEpisode(2);
  second.active.episode_return = std::numeric_limits<double>::quiet_NaN();
  second.active.logs[0] = std::numeric_limits<double>::quiet_NaN();
  second.active.terms = {std::numeric_limits<double>::infinity(), 5e-324};
  database.AddEpisode(SampleEpisode(1), {}, {});
  database.AddEpisode(second, {}, {});

  const std::vector<EpisodeRecord> read = RunDatabase::OpenToRead(folder()).ReadEpisodes();
  ASSERT_EQ(read.size(), 2u);
  const EpisodeRecord first = SampleEpisode(1);
  EXPECT_EQ(read[0].number, 1);
  EXPECT_EQ(read[0].active.episode_return, first.active.episode_return);
  EXPECT_EQ(read[0].active.end_kind, "truncated");
  EXPECT_EQ(read[0].active.end_reason, "time is over");
  EXPECT_EQ(read[0].steps, first.steps);
  EXPECT_EQ(read[0].actions, first.actions);
  EXPECT_EQ(read[0].simulated_seconds, first.simulated_seconds);
  EXPECT_EQ(read[0].wall_seconds, first.wall_seconds);
  EXPECT_EQ(read[0].cpu_seconds, first.cpu_seconds);
  EXPECT_EQ(read[0].active.faults, 2);
  EXPECT_EQ(read[0].active.terms, first.active.terms);
  EXPECT_EQ(read[0].active.violations, 3);
  EXPECT_EQ(read[0].active.metrics, first.active.metrics);
  EXPECT_EQ(read[0].active.logs, first.active.logs);
  EXPECT_TRUE(std::isnan(read[1].active.episode_return));
  EXPECT_EQ(read[1].active.terms, second.active.terms);
  EXPECT_TRUE(std::isnan(read[1].active.logs[0]));
  EXPECT_EQ(read[1].active.logs[1], 7);
}

TEST_F(RunDatabaseTest, GivesBackWhatTheLearnerHasShown) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  EXPECT_TRUE(database.ReadLearnerCurves().empty());
  database.SetLearnerCurves({{"rate", "", "", "alpha"}, {"loss", "m", "", ""}});
  EpisodeRecord first = SampleEpisode(1);
  first.learner = {{"loss", 0.1}, {"rate", 5e-324}};
  EpisodeRecord second = SampleEpisode(2);
  second.learner = {{"rate", std::numeric_limits<double>::quiet_NaN()}, {"unheard_of", 1}};
  database.AddEpisode(first, {}, {});
  database.AddEpisode(second, {}, {});
  // Another version of the learner goes on with the run.
  database.SetLearnerCurves({{"loss", "mm", "", "less is better"}, {"entropy", "", "", ""}});
  EpisodeRecord third = SampleEpisode(3);
  third.learner = {{"entropy", 3}};
  database.AddEpisode(third, {}, {});

  const RunDatabase reader = RunDatabase::OpenToRead(folder());
  const std::vector<CurveRecord> curves = reader.ReadLearnerCurves();
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].name, "rate");
  EXPECT_EQ(curves[0].doc, "alpha");
  EXPECT_EQ(curves[1].name, "loss");
  EXPECT_EQ(curves[1].unit, "mm");
  EXPECT_EQ(curves[2].name, "entropy");
  const std::vector<EpisodeRecord> read = reader.ReadEpisodes();
  EXPECT_EQ(read[0].learner, (std::vector<NamedValue>{{"rate", 5e-324}, {"loss", 0.1}}));
  ASSERT_EQ(read[1].learner.size(), 1u);
  EXPECT_TRUE(std::isnan(read[1].learner[0].value));
  EXPECT_EQ(read[2].learner, third.learner);
}

TEST_F(RunDatabaseTest, GoesOnWithARunFromBeforeLearnersShowedAnything) {
  RunDatabase::Create(folder(), SampleRun()).AddEpisode(SampleEpisode(1), {}, {});
  SqliteDatabase(file(), SqliteAccess::kWrite)
      .Execute("DROP TABLE learner_value; DROP TABLE learner_curve", "be an old one");
  EXPECT_EQ(RunDatabase::OpenToRead(folder()).ReadEpisodes().size(), 1u);
  EXPECT_TRUE(RunDatabase::OpenToRead(folder()).ReadLearnerCurves().empty());
  RunDatabase database = RunDatabase::Open(folder());
  database.SetLearnerCurves({{"rate", "", "", ""}});
  EpisodeRecord second = SampleEpisode(2);
  second.learner = {{"rate", 0.5}};
  database.AddEpisode(second, {}, {});
  const std::vector<EpisodeRecord> read = RunDatabase::OpenToRead(folder()).ReadEpisodes();
  EXPECT_TRUE(read.at(0).learner.empty());
  EXPECT_EQ(read.at(1).learner, second.learner);
}

TEST_F(RunDatabaseTest, GoesOnWithARunFromBeforeThereWerePhases) {
  RunRecord run = SampleRun();
  run.tasks[0].phases.clear();
  EpisodeRecord episode = SampleEpisode(1);
  episode.active.phases.clear();
  RunDatabase::Create(folder(), run).AddEpisode(episode, {}, {});
  SqliteDatabase(file(), SqliteAccess::kWrite)
      .Execute("DROP TABLE evaluation_phase; DROP TABLE phase", "be an old one");
  EXPECT_EQ(RunDatabase::OpenToRead(folder()).ReadEpisodes().size(), 1u);
  RunDatabase database = RunDatabase::Open(folder());
  EXPECT_EQ(database.AddTask(SampleTask()), 2);
  EpisodeRecord second = SampleEpisode(2);
  second.active.task = 2;
  database.AddEpisode(second, {}, {});
  const std::vector<EpisodeRecord> read = RunDatabase::OpenToRead(folder()).ReadEpisodes();
  EXPECT_TRUE(read.at(0).active.phases.empty());
  EXPECT_EQ(read.at(1).active.phases, second.active.phases);
}

TEST_F(RunDatabaseTest, GoesOnWithARunFromBeforeTimelinesWereRecorded) {
  RunDatabase::Create(folder(), SampleRun())
      .AddEpisode(SampleEpisode(1), Recording{1, 0.02, true, "p", ""}, {});
  SqliteDatabase(file(), SqliteAccess::kWrite).Execute("DROP TABLE timeline", "be an old one");
  EXPECT_EQ(RunDatabase::OpenToRead(folder()).ReadRecording(1)->timeline, "");
  RunDatabase database = RunDatabase::Open(folder());
  database.AddEpisode(SampleEpisode(2), Recording{1, 0.02, true, "p", "t"}, {});
  EXPECT_EQ(database.ReadRecording(1)->timeline, "");
  EXPECT_EQ(database.ReadRecording(2)->timeline, "t");
}

TEST_F(RunDatabaseTest, KeepsTheLastCheckpointAndAllRecordings) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  const std::string poses("\0\1\2 poses", 9);
  database.AddEpisode(SampleEpisode(1), Recording{3, 0.02, true, poses, "timeline"},
                      Checkpoint{1, "old"});
  database.AddEpisode(SampleEpisode(2), {}, Checkpoint{2, "new"});
  EXPECT_EQ(database.ReadCheckpoint()->episode, 2);
  EXPECT_EQ(database.ReadCheckpoint()->state, "new");
  const std::optional<Recording> recording = database.ReadRecording(1);
  ASSERT_TRUE(recording.has_value());
  EXPECT_EQ(recording->frames, 3);
  EXPECT_EQ(recording->frame_interval, 0.02);
  EXPECT_TRUE(recording->is_best);
  EXPECT_EQ(recording->poses, poses);
  EXPECT_EQ(recording->timeline, "timeline");
  EXPECT_FALSE(database.ReadRecording(2).has_value());
  EXPECT_EQ(database.ReadLastRecordedEpisode(), 1);
}

TEST_F(RunDatabaseTest, DeletesLaterEpisodesWithAllThatBelongsToThem) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  database.SetLearnerCurves({{"rate", "", "", ""}});
  for (int number = 1; number <= 3; ++number) {
    EpisodeRecord episode = SampleEpisode(number);
    episode.learner = {{"rate", 0.5}};
    database.AddEpisode(episode, Recording{1, 0.02, false, "p", "t"}, {});
  }
  database.DeleteEpisodesAfter(1);
  EXPECT_EQ(database.ReadEpisodes().size(), 1u);
  SqliteDatabase raw(file(), SqliteAccess::kRead);
  for (const char* table : {"episode", "evaluation", "evaluation_term", "evaluation_metric",
                            "evaluation_log", "learner_value", "recording", "timeline"}) {
    const std::string column = table == std::string("episode") ? "number" : "episode";
    EXPECT_EQ(raw.QueryInteger("SELECT max(" + column + ") FROM " + table, "count"), 1) << table;
  }
}

TEST_F(RunDatabaseTest, IsReadWhileItIsWritten) {
  RunDatabase writer = RunDatabase::Create(folder(), SampleRun());
  const RunDatabase reader = RunDatabase::OpenToRead(folder());
  EXPECT_TRUE(reader.ReadEpisodes().empty());
  EXPECT_EQ(reader.ReadLastRecordedEpisode(), 0);
  writer.AddEpisode(SampleEpisode(1), {}, {});
  EXPECT_EQ(reader.ReadEpisodes().size(), 1u);
  EXPECT_EQ(reader.ReadState(), RunState::kRunning);
}

TEST_F(RunDatabaseTest, LeavesOneFileBehind) {
  RunDatabase::Create(folder(), SampleRun()).AddEpisode(SampleEpisode(1), {}, {});
  RunDatabase::Open(folder()).AddEpisode(SampleEpisode(2), {}, {});
  EXPECT_EQ(RunDatabase::OpenToRead(folder()).ReadEpisodes().size(), 2u);
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    EXPECT_EQ(entry.path(), file());
  }
}

TEST_F(RunDatabaseTest, CountsAsInterruptedOnceItsTrainerIsGone) {
  {
    const RunDatabase writer = RunDatabase::Create(folder(), SampleRun());
    EXPECT_EQ(writer.ReadState(), RunState::kRunning);
  }
  EXPECT_EQ(RunDatabase::OpenToRead(folder()).ReadState(), RunState::kInterrupted);
}

TEST_F(RunDatabaseTest, NotesWhenItWasFinished) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  EXPECT_THAT(database.ReadValue("started_at"), testing::MatchesRegex("20..-..-..T..:..:..Z"));
  EXPECT_EQ(database.ReadValue("finished_at"), "");
  database.SetState(RunState::kFinished);
  EXPECT_EQ(database.ReadState(), RunState::kFinished);
  EXPECT_THAT(database.ReadValue("finished_at"), testing::MatchesRegex("20..-..-..T..:..:..Z"));
  database.SetState(RunState::kRunning);
  EXPECT_EQ(database.ReadValue("finished_at"), "");
}

TEST_F(RunDatabaseTest, RefusesAFolderThatHoldsARun) {
  RunDatabase::Create(folder(), SampleRun()).AddEpisode(SampleEpisode(1), {}, {});
  EXPECT_THAT(ErrorOf([&] { RunDatabase::Create(folder(), SampleRun()); }),
              AllOf(HasSubstr(folder().string()), HasSubstr("trainer resume"), HasSubstr("--out")));
  EXPECT_EQ(RunDatabase::OpenToRead(folder()).ReadEpisodes().size(), 1u);
}

TEST_F(RunDatabaseTest, MakesARunWhereOneWasNeverFinishedBeingMade) {
  std::filesystem::create_directories(folder());
  std::ofstream(file()).close();
  EXPECT_EQ(ErrorOf([&] { RunDatabase::Create(folder(), SampleRun()); }), "");
}

TEST_F(RunDatabaseTest, RefusesASecondTrainer) {
  const RunDatabase first = RunDatabase::Create(folder(), SampleRun());
  EXPECT_THAT(ErrorOf([&] { RunDatabase::Open(folder()); }),
              AllOf(HasSubstr(folder().string()), HasSubstr("another trainer")));
}

TEST_F(RunDatabaseTest, RefusesAFolderWithoutARun) {
  for (const auto& open : {RunDatabase::Open, RunDatabase::OpenToRead}) {
    EXPECT_THAT(ErrorOf([&] { open(folder()); }),
                AllOf(HasSubstr(folder().string()), HasSubstr("trainer train")));
  }
}

TEST_F(RunDatabaseTest, RefusesAPlaceWhereNoFolderCanBeMade) {
  std::filesystem::create_directories(folder());
  std::ofstream(folder() / "file") << "x";
  const std::filesystem::path below_file = folder() / "file" / "run";
  EXPECT_THAT(ErrorOf([&] { RunDatabase::Create(below_file, SampleRun()); }),
              AllOf(HasSubstr(below_file.string()), HasSubstr("--out")));
}

TEST_F(RunDatabaseTest, RefusesAForeignDatabase) {
  std::filesystem::create_directories(folder());
  SqliteDatabase(file(), SqliteAccess::kCreate).Execute("CREATE TABLE episode (number)", "make it");
  EXPECT_THAT(ErrorOf([&] { RunDatabase::Open(folder()); }),
              AllOf(HasSubstr(file().string()), HasSubstr("not one of the trainer")));
}

TEST_F(RunDatabaseTest, RefusesANewerSchema) {
  RunDatabase::Create(folder(), SampleRun());
  SqliteDatabase(file(), SqliteAccess::kWrite).Execute("PRAGMA user_version=99", "change it");
  EXPECT_THAT(ErrorOf([&] { RunDatabase::OpenToRead(folder()); }),
              AllOf(HasSubstr(file().string()), HasSubstr("99"), HasSubstr("use that version")));
}

TEST_F(RunDatabaseTest, RefusesAFileThatIsNoDatabase) {
  std::filesystem::create_directories(folder());
  std::ofstream(file()) << std::string(5000, 'x');
  EXPECT_THAT(ErrorOf([&] { RunDatabase::Open(folder()); }),
              AllOf(HasSubstr(file().string()), HasSubstr("damaged")));
}

TEST_F(RunDatabaseTest, ReportsDamage) {
  {
    RunDatabase database = RunDatabase::Create(folder(), SampleRun());
    for (int number = 1; number <= 200; ++number) {
      database.AddEpisode(SampleEpisode(number), {}, {});
    }
  }
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(file()));
  std::fstream raw(file(), std::ios::in | std::ios::out | std::ios::binary);
  raw.seekp(4096);  // all but the first page
  raw << std::string(static_cast<size_t>(size - 4096), '\x5a');
  raw.close();
  EXPECT_THAT(ErrorOf([&] {
                const RunDatabase database = RunDatabase::OpenToRead(folder());
                database.ReadRun();
                database.ReadEpisodes();
              }),
              AllOf(HasSubstr(file().string()), HasSubstr("damaged")));
}

TEST_F(RunDatabaseTest, ReportsAProgramThatKeepsItLocked) {
  RunDatabase::Create(folder(), SampleRun());
  SqliteDatabase database(file(), SqliteAccess::kWrite);
  sqlite3_busy_timeout(database.handle(), 1);  // [ms]
  SqliteDatabase other(file(), SqliteAccess::kWrite);
  other.Execute("BEGIN IMMEDIATE", "lock it");
  EXPECT_THAT(ErrorOf([&] { SqliteTransaction(database, "save episode 1"); }),
              AllOf(HasSubstr(file().string()), HasSubstr("episode 1"), HasSubstr("locked"),
                    HasSubstr("close that program")));
}

TEST_F(RunDatabaseTest, WaitsForAProgramThatKeepsItLockedForAWhile) {
  RunDatabase database = RunDatabase::Create(folder(), SampleRun());
  SqliteDatabase other(file(), SqliteAccess::kWrite);
  other.Execute("BEGIN IMMEDIATE", "lock it");
  const std::jthread backup([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(2600));
    other.Execute("ROLLBACK", "free it");
  });
  database.AddEpisode(SampleEpisode(1), {}, {});
  EXPECT_EQ(database.ReadEpisodes().size(), 1u);
}

// Each of them is what a kill can leave behind.
TEST_F(RunDatabaseTest, WhatIsHalfMadeIsNoRunAndCanBeMadeWhole) {
  for (const char* name : {"", "plugin-0123456789abcdef.so.77.part", "plugin-0123456789abcdef.so",
                           "run.db.part", "run.db.part-journal", "run.db", "run.db-journal"}) {
    std::filesystem::remove_all(folder());
    std::filesystem::create_directories(folder());
    const std::string content = name == std::string("run.db") ? "" : std::string(5000, 'x');
    if (*name != '\0') std::ofstream(folder() / name) << content;
    EXPECT_FALSE(RunDatabase::Exists(folder())) << name;
    EXPECT_EQ(RunDatabase::IsUnfinished(folder()), *name != '\0') << name;
    EXPECT_EQ(ErrorOf([&] { RunDatabase::Create(folder(), SampleRun()); }), "") << name;
    EXPECT_FALSE(RunDatabase::IsUnfinished(folder()));
    EXPECT_EQ(RunDatabase::OpenToRead(folder()).ReadRun().seed, SampleRun().seed) << name;
  }
}

TEST_F(RunDatabaseTest, ReportsAFullDisk) {
  SqliteDatabase database(parent_.path() / "full.db", SqliteAccess::kCreate);
  database.Execute("CREATE TABLE t (x); PRAGMA max_page_count=3", "make it");
  SqliteStatement insert(database, "INSERT INTO t VALUES (?)", "save an episode");
  const std::string value(3000, 'x');
  EXPECT_THAT(ErrorOf([&] {
                for (int i = 0; i < 10; ++i) insert.Bind(std::string_view(value)).Run();
              }),
              AllOf(HasSubstr("full.db"), HasSubstr("save an episode"), HasSubstr("disk is full"),
                    HasSubstr("free some space")));
}

// In a process of its own, because the limit cannot be taken back for sure.
TEST_F(RunDatabaseTest, LosesNothingThatWasSavedWhenNoMoreCanBeWritten) {
  RunDatabase::Create(folder(), SampleRun());
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    RunDatabase database = RunDatabase::Open(folder());
    const rlimit limit{100'000, 100'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    int number = 0;
    const std::string error = ErrorOf([&] {
      while (number < 10'000) {
        database.AddEpisode(SampleEpisode(number + 1), {}, {});
        ++number;
      }
    });
    const bool is_explained = error.find(file().string()) != std::string::npos &&
                              error.find("save episode") != std::string::npos &&
                              error.find("check the disk") != std::string::npos;
    _exit(is_explained && number > 0 && number < 200 ? number : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  const int saved = WEXITSTATUS(status);
  ASSERT_GT(saved, 0);
  EXPECT_EQ(RunDatabase::Open(folder()).ReadEpisodes().size(), static_cast<size_t>(saved));
}

}  // namespace
}  // namespace runtime
