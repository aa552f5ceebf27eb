#include "runtime/analysis/study/results.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "runtime/analysis/study/value_curves.h"
#include "runtime/training/run/run_database.h"
#include "tests/runtime/analysis/study/sample_study.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// The sample study's experiment `crawling`.
class ResultsTest : public testing::Test {
 protected:
  ResultsTest() {
    runs_ = WriteStudy(folder_.path());
    runs_.pop_back();
    ReadStudy();
  }
  void ReadStudy() { study_ = ReadStudyRuns(folder_.path(), runs_); }
  const StudyExperiment& experiment() const { return study_.experiments.front(); }

  TemporaryFolder folder_;
  std::vector<std::filesystem::path> runs_;
  Study study_;
  std::vector<std::string> notes_;
};

TEST_F(ResultsTest, FinishedRunsAreGroupedByTheirLastBehaviors) {
  const ExperimentResult result = Evaluate(experiment(), notes_);
  ASSERT_THAT(result.groups, SizeIs(2));
  EXPECT_THAT(result.groups[0].runs, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(result.groups[1].runs, ElementsAre(5, 6));
  EXPECT_EQ(result.runs[2].group, 0u);
  EXPECT_EQ(result.runs[6].group, 1u);
  EXPECT_FALSE(result.runs[7].group.has_value());  // not finished
  EXPECT_THAT(notes_, IsEmpty());
}

TEST_F(ResultsTest, ADamagedRecordingCostsOnlyItself) {
  RunDatabase database = RunDatabase::Open(folder_.path() / "crawling" / "seed2");
  database.SetEpisodesPlanned(41);
  EpisodeRecord episode = database.ReadEpisodes().back();
  episode.number = 41;
  database.AddEpisode(episode, Recording{3, 0.02, false, "nonsense"}, {});
  study_ = ReadStudyRuns(folder_.path(), {folder_.path() / "crawling" / "seed1",
                                          folder_.path() / "crawling" / "seed2"});
  const ExperimentResult result = Evaluate(experiment(), notes_);
  EXPECT_THAT(result.groups, SizeIs(1));
  EXPECT_THAT(notes_, ElementsAre(testing::HasSubstr("crawling/seed2")));
}

TEST_F(ResultsTest, EachRunHasItsFigures) {
  const ExperimentResult result = Evaluate(experiment(), notes_);
  EXPECT_EQ(result.window, 2);  // 40 episodes are planned
  const RunResult& run = result.runs[0];
  const auto& episodes = run.run->episodes;
  EXPECT_DOUBLE_EQ(run.final.episode_return,
                   (episodes[38].active.episode_return + episodes[39].active.episode_return) / 2);
  EXPECT_DOUBLE_EQ(run.cpu_seconds, 40 * 1.5);
  ASSERT_TRUE(run.most_learned.has_value());
  EXPECT_DOUBLE_EQ(run.most_learned->cpu_seconds,
                   1.5 * static_cast<double>(run.most_learned->episode));
}

// Of speeds s from 0.102 to 0.11 m/s and twice 0.5 m/s, each with a learned return of 1000 s.
TEST_F(ResultsTest, TellsWhatRemainsInOtherProfiles) {
  WriteSampleEvaluation(folder_.path() / "crawling" / "seed8", "fast", {.episodes = 25}, 0.5);
  ReadStudy();
  EXPECT_THAT(experiment().runs[7].evaluations, SizeIs(1));
  const std::vector<EvaluationResult> evaluations = EvaluationsOf(Evaluate(experiment(), notes_));
  ASSERT_THAT(evaluations, SizeIs(2));
  const EvaluationResult& fast = evaluations[0];
  EXPECT_EQ(fast.profile, "fast");
  EXPECT_EQ(fast.mean_return.count, 7);  // those that are finished
  EXPECT_DOUBLE_EQ(fast.learned_return.mean, (102 + 104 + 106 + 108 + 110 + 500 + 500) / 7.);
  EXPECT_DOUBLE_EQ(fast.share(), 0.9);
  EXPECT_EQ(evaluations[1].profile, "paper-tree");
  EXPECT_NEAR(evaluations[1].median_share, 0.99, 1e-12);  // 1.02, 1.01, ... 0.96
  EXPECT_THAT(notes_, IsEmpty());
}

TEST_F(ResultsTest, WhatWasEvaluatedBeforeTheEndDoesNotCount) {
  const std::filesystem::path run = folder_.path() / "crawling" / "seed1";
  WriteSampleEvaluation(run, "fast", {.episodes = 20}, 0.9);
  std::ofstream(run / "evaluation-fast-tree.json") << "{";
  ReadStudy();
  ASSERT_THAT(experiment().runs[0].evaluations, SizeIs(1));
  EXPECT_EQ(experiment().runs[0].evaluations[0].profile, "paper-tree");
  EXPECT_THAT(study_.notes,
              ElementsAre(testing::HasSubstr("evaluation-fast-tree.json"),
                          testing::HasSubstr("crawling/seed1 has continued to learn since")));
}

TEST_F(ResultsTest, CurvesEndWhereTheirRunsDo) {
  const Curves curves = CurvesOf(Evaluate(experiment(), notes_));
  ASSERT_THAT(curves.episodes, SizeIs(40));
  EXPECT_EQ(curves.episodes.front(), 1);
  EXPECT_THAT(curves.runs[0], SizeIs(40));
  EXPECT_THAT(curves.runs[7], SizeIs(25));
  EXPECT_EQ(curves.means[24].count, 8);
  EXPECT_EQ(curves.means[25].count, 7);
}

TEST_F(ResultsTest, TermsAndMetricsHaveCurvesOfTheirOwn) {
  const ExperimentResult result = Evaluate(experiment(), notes_);
  const Curves curves = CurvesOf(result);
  const ValueCurves values = ValueCurvesOf(result, curves.episodes);
  ASSERT_THAT(values.terms, SizeIs(3));
  EXPECT_EQ(values.terms[0].name, "forward");
  for (const size_t episode : {0, 24, 39}) {
    double sum = 0;
    for (const ValueCurve& term : values.terms) sum += term.means[episode].mean;
    EXPECT_NEAR(sum, curves.means[episode].mean, 1e-9);  // all that is paid
    EXPECT_EQ(values.terms[0].means[episode].count, curves.means[episode].count);
  }
  ASSERT_THAT(values.metrics, SizeIs(2));
  EXPECT_EQ(values.metrics[0].name, "distance");
  EXPECT_EQ(values.metrics[0].unit, "m");
  double distance = 0;
  for (size_t run = 0; run < 7; ++run) distance += result.runs[run].final.metrics.at("distance");
  EXPECT_NEAR(values.metrics[0].means.back().mean, distance / 7, 1e-9);  // the eighth is shorter
}

// The one without it counts where the other is, and not for what it has not.
TEST_F(ResultsTest, ARunWithoutAMetricIsLeftOutOfItsCurve) {
  study_.experiments.front().runs[0].record.tasks.front().metrics[0].name = "way";
  const ExperimentResult result = Evaluate(experiment(), notes_);
  const ValueCurves values = ValueCurvesOf(result, {1});
  ASSERT_THAT(values.metrics, SizeIs(3));
  EXPECT_EQ(values.metrics[0].name, "way");
  EXPECT_EQ(values.metrics[0].means[0].count, 1);
  EXPECT_EQ(values.metrics[2].name, "distance");
  EXPECT_EQ(values.metrics[2].means[0].count, 7);
}

TEST(CurvesOf, LongRunsAreThinnedOutAndKeepTheirLastEpisode) {
  StudyExperiment experiment;
  experiment.runs.resize(1);
  experiment.runs[0].record.tasks.resize(1);
  for (int64_t number = 1; number <= 1001; ++number) {
    experiment.runs[0].episodes.emplace_back().number = number;
  }
  ExperimentResult result{&experiment, 50, {}, {}};
  result.runs.push_back({&experiment.runs[0], {}, 0, {}, 0, {}});
  const Curves curves = CurvesOf(result);
  EXPECT_LE(curves.episodes.size(), static_cast<size_t>(Curves::kPoints));
  EXPECT_GE(curves.episodes.front(), 1);
  EXPECT_EQ(curves.episodes.back(), 1001);
}

}  // namespace
}  // namespace runtime
