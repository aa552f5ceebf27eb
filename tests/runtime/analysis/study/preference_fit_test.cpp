#include "runtime/analysis/study/preference_fit.h"

#include <gmock/gmock.h>

#include <cmath>

#include "runtime/analysis/study/compared_behavior.h"
#include "runtime/analysis/study/informative_pair.h"
#include "runtime/analysis/study/preference_figures.h"
#include "runtime/training/run/run_database.h"
#include "tests/runtime/analysis/study/sample_preferences.h"
#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Preference Over(const std::string& better, const std::string& worse) {
  return {ParseBehaviorName("crawling/" + better), ParseBehaviorName("crawling/" + worse)};
}

class PreferenceFitTest : public testing::Test {
 protected:
  void SetUp() override { runs_ = WriteThreeEndings(folder()); }
  const std::filesystem::path& folder() const { return folder_.path(); }
  void Add(const SampleEnding& ending, const std::string& experiment = "crawling") {
    runs_.push_back(folder() / experiment / ("seed" + std::to_string(ending.seed)));
    WriteEnding(runs_.back(), ending);
  }
  const StudyResults& Study() {
    if (!study_) study_ = ReadStudyResults(folder(), runs_);
    return *study_;
  }
  const ExperimentResult& Crawling() { return Study().experiments.front(); }
  PreferenceFit Fit(const std::vector<Preference>& preferences) {
    return FitPreferences(Crawling(), CrawlingParams(), preferences);
  }

  std::vector<std::filesystem::path> runs_;

 private:
  TemporaryFolder folder_;
  std::optional<StudyResults> study_;
};

// Variances over the three runs: forward 4200 / 27, turning 294 / 27, fall 896 / 3.
TEST_F(PreferenceFitTest, TheScaleIsTheSpreadOfAllTermsTogether) {
  EXPECT_NEAR(Fit({}).model.scale, std::sqrt(4200. / 27 + 294. / 27 + 896. / 3), 1e-9);
}

TEST_F(PreferenceFitTest, ProbabilitiesAreThoseOfTheReturns) {
  const PreferenceFit fit = Fit({Over("seed2", "seed1")});
  const PreferenceResult& result = fit.preferences.front();
  EXPECT_DOUBLE_EQ(result.probability.before, Logistic((88. - 82) / fit.model.scale));
  EXPECT_TRUE(result.holds.before);
  const auto after = [&](size_t run) { return fit.rescored.runs[run].final.after; };
  EXPECT_DOUBLE_EQ(result.probability.after, Logistic((after(1) - after(0)) / fit.model.scale));
}

TEST_F(PreferenceFitTest, WhoeverMindsNoFallsPaysLessForThem) {
  const PreferenceFit fit = Fit({Over("seed3", "seed1"), Over("seed3", "seed2")});
  const WeightChange& fall = fit.weights[0];
  EXPECT_EQ(fall.param.name, "fall_penalty");
  EXPECT_EQ(fall.value.before, 4);
  EXPECT_LT(fall.value.after, 4);
  EXPECT_GT(fall.value.after, 0);
  EXPECT_LT(fall.low, fall.value.after);
  EXPECT_GT(fall.high, fall.value.after);
  EXPECT_LT(fall.sd, std::log(2));
  EXPECT_FALSE(fit.preferences[0].holds.before);
  EXPECT_TRUE(fit.is_consistent());
}

// 75 at the end, half of that before: by the rounded values.
TEST_F(PreferenceFitTest, AllEpisodesAreRescored) {
  const PreferenceFit fit = Fit({Over("seed3", "seed1")});
  const double fall = fit.weights[0].value.after / 4;
  const double turning = fit.weights[1].value.after / 0.025;
  const RunReturns& third = fit.rescored.runs[2];
  EXPECT_DOUBLE_EQ(third.final.before, 75);
  EXPECT_NEAR(third.final.after, 120 - 5 * turning - 40 * fall, 1e-9);
  EXPECT_DOUBLE_EQ(third.all.before, 0.75 * 75);
  EXPECT_NEAR(third.all.after, 0.75 * third.final.after, 1e-9);
  EXPECT_DOUBLE_EQ(fit.rescored.terms[3].before, -16);
  EXPECT_NEAR(fit.rescored.terms[3].after, -16 * fall, 1e-9);
  EXPECT_EQ(fit.rescored.terms[0].before, fit.rescored.terms[0].after);
}

TEST_F(PreferenceFitTest, NewValuesAreRounded) {
  const double value = Fit({Over("seed3", "seed1")}).weights[0].value.after;
  EXPECT_NEAR(value * 100, std::round(value * 100), 1e-9);
}

TEST_F(PreferenceFitTest, AGreaterFactorChangesMore) {
  const auto value = [&](double factor) {
    return FitPreferences(Crawling(), CrawlingParams(), {Over("seed3", "seed1")}, factor)
        .weights[0]
        .value.after;
  };
  EXPECT_LT(value(4), value(2));
  EXPECT_LT(value(2), value(1.1));
}

TEST_F(PreferenceFitTest, SingleEpisodesAreBehaviors) {
  const PreferenceFit fit = Fit({Over("seed1:5", "seed1")});
  EXPECT_DOUBLE_EQ(fit.preferences[0].probability.before, Logistic((41. - 82) / fit.model.scale));
  EXPECT_THAT(ErrorOf([&] {
                TermSums(Crawling().runs[0], {"crawling/seed1", 21});
              }),
              HasSubstr("crawling/seed1 has no episode 21; it has 20"));
}

TEST_F(PreferenceFitTest, AWeightThatWasZeroStays) {
  runs_.clear();
  for (uint64_t seed = 4; seed <= 5; ++seed) {
    Add({.seed = seed,
         .terms = {10. * static_cast<double>(seed), 0, 0, -8},
         .params = "fall_penalty = 4.0\nturning_cost = 0.0\n"},
        "careless");
  }
  const PreferenceFit fit = Fit({});
  ASSERT_THAT(fit.weights, SizeIs(1));
  EXPECT_EQ(fit.weights[0].param.name, "fall_penalty");
  ASSERT_THAT(fit.kept, SizeIs(1));
  EXPECT_EQ(fit.kept[0].param.name, "turning_cost");
  EXPECT_THAT(fit.kept[0].why, HasSubstr("was 0"));
}

// Of two runs that differ in one term only. Its weight is negative, and pays falls.
TEST_F(PreferenceFitTest, AWeightKeepsItsSign) {
  runs_.clear();
  Add({.seed = 4, .terms = {10, 0, 0, 8}, .params = "fall_penalty = -4.0\n"}, "reckless");
  Add({.seed = 5, .terms = {15, 0, 0, 0}, .params = "fall_penalty = -4.0\n"}, "reckless");
  TaskParams params = CrawlingParams();
  params.params.resize(1);
  params.params[0].least = -6;
  params.params[0].greatest = 10;
  const std::vector<Preference> preferences(
      20, {ParseBehaviorName("reckless/seed5"), ParseBehaviorName("reckless/seed4")});
  const WeightChange less = FitPreferences(Crawling(), params, preferences).weights[0];
  EXPECT_LT(less.value.after, 0);
  EXPECT_GT(less.value.after, -4);
  EXPECT_LT(less.low, less.high);
  std::vector<Preference> contrary = preferences;
  for (Preference& preference : contrary) std::swap(preference.better, preference.worse);
  EXPECT_EQ(FitPreferences(Crawling(), params, contrary, 10).weights[0].value.after, -6);
}

TEST_F(PreferenceFitTest, ATaskWithoutWeightsIsAnError) {
  TaskParams params = CrawlingParams();
  for (TaskParam& param : params.params) param.scales.clear();
  EXPECT_THAT(ErrorOf([&] { FitPreferences(Crawling(), params, {}); }),
              HasSubstr("no param of the task crawling is a weight"));
}

TEST_F(PreferenceFitTest, RunsWhoseTaskWasChangedDoNotCount) {
  RunDatabase::Open(runs_[2]).AddChange(
      {0, 3, 0, "", SetParameter{"task.fall_penalty", int64_t{8}}, "task.fall_penalty = 8"});
  RunDatabase::Open(runs_[1]).AddChange(
      {0, 3, 0, "", SetParameter{"learner.temperature", int64_t{8}}, "learner.temperature = 8"});
  const PreferenceFit fit = Fit({Over("seed2", "seed1"), Over("seed1", "seed3")});
  ASSERT_THAT(fit.preferences, SizeIs(1));
  EXPECT_EQ(fit.preferences[0].preference.worse.run, "crawling/seed1");
  EXPECT_FALSE(fit.rescored.runs[1].left_out);
  EXPECT_TRUE(std::isnan(fit.rescored.runs[2].final.before));
  EXPECT_THAT(*fit.rescored.runs[2].left_out, HasSubstr("task.fall_penalty = 8"));
  EXPECT_THAT(fit.notes[0], HasSubstr("`crawling/seed1 over crawling/seed3` is left out"));
}

TEST_F(PreferenceFitTest, ARunThatIsNotFinishedHasNoBehaviorYet) {
  Add({.seed = 4, .terms = {10, 0, 0, 0}, .episodes = 12});
  EXPECT_THAT(ErrorOf([&] {
                TermSums(Crawling().runs[3], {"crawling/seed4", {}});
              }),
              HasSubstr("compare one of its episodes, `crawling/seed4:12`"));
  const PreferenceFit fit = Fit({Over("seed4", "seed1"), Over("seed4:12", "seed1")});
  ASSERT_THAT(fit.preferences, SizeIs(1));
  EXPECT_EQ(fit.preferences[0].preference.better.episode, 12);
}

TEST_F(PreferenceFitTest, TellsWhatContradictsItself) {
  const PreferenceFit fit = Fit({Over("seed1", "seed2"), Over("seed2", "seed1")});
  EXPECT_TRUE(fit.preferences[0].is_contradicted);
  EXPECT_FALSE(fit.is_consistent());
}

// Less forward, more turning, and as many falls.
TEST_F(PreferenceFitTest, TellsWhatNoWeightsExplain) {
  Add({.seed = 4, .terms = {80, -20, 0, -8}});
  const PreferenceFit fit = Fit({Over("seed4", "seed1"), Over("seed2", "seed3")});
  EXPECT_FALSE(fit.preferences[0].can_hold);
  EXPECT_FALSE(fit.preferences[0].is_contradicted);
  EXPECT_TRUE(fit.preferences[1].can_hold);
  EXPECT_FALSE(fit.is_consistent());
}

TEST_F(PreferenceFitTest, WarnsOfWeightsThatDecideWhenAnEpisodeEnds) {
  EXPECT_THAT(Fit({Over("seed3", "seed1")}).notes,
              testing::Contains(HasSubstr("fall_penalty also affects when an episode ends")));
  EXPECT_THAT(Fit({}).notes, IsEmpty());
}

TEST_F(PreferenceFitTest, SaysTheSameTwice) {
  const std::vector<Preference> preferences = {Over("seed3", "seed1"), Over("seed2", "seed3")};
  EXPECT_EQ(PreferenceFigures(Fit(preferences)).dump(), PreferenceFigures(Fit(preferences)).dump());
}

TEST_F(PreferenceFitTest, FiguresHoldAllOfIt) {
  const nlohmann::ordered_json figures = PreferenceFigures(Fit({Over("seed3", "seed1")}));
  EXPECT_EQ(figures["experiment"], "crawling");
  EXPECT_EQ(figures["preferences"][0]["better"], "crawling/seed3");
  EXPECT_EQ(figures["preferences"][0]["holds"]["before"], false);
  EXPECT_EQ(figures["weights"][0]["before"], 4);
  EXPECT_EQ(figures["weights"][0]["greatest"], 20);
  EXPECT_EQ(figures["terms"][3]["name"], "fall");
  EXPECT_EQ(figures["runs"][2]["final_return"]["before"], 75);
  EXPECT_EQ(figures["runs"][2]["left_out"], nlohmann::ordered_json());
  EXPECT_THAT(figures["groups"], SizeIs(3));
}

TEST_F(PreferenceFitTest, PreferencesAreSortedByExperiment) {
  Add({.seed = 9, .terms = {1, 0, 0, 0}, .params = "fall_penalty = 8.0\n"}, "other");
  const std::vector<ExperimentResult>& experiments = Study().experiments;
  const auto sort = [&](Preference preference) {
    preference.line = 7;
    return PreferencesByExperiment(experiments, {preference}, "study");
  };
  const auto sorted = sort(Over("seed3", "seed1"));
  ASSERT_THAT(sorted, SizeIs(2));
  EXPECT_THAT(sorted[0], SizeIs(1));
  EXPECT_THAT(sorted[1], IsEmpty());
  EXPECT_THAT(ErrorOf([&] { sort(Over("seed3", "seed8")); }),
              HasSubstr("study/preferences.toml:7: there is no run `crawling/seed8`"));
  EXPECT_THAT(
      ErrorOf([&] {
        sort({ParseBehaviorName("other/seed9"), ParseBehaviorName("crawling/seed1")});
      }),
      HasSubstr("study/preferences.toml:7: other/seed9 and crawling/seed1 are runs of two"));
}

TEST_F(PreferenceFitTest, NamesOfRunsCanBeShortened) {
  Add({.seed = 1, .terms = {1, 0, 0, 0}, .params = "fall_penalty = 8.0\n"}, "other");
  const auto find = [&](const std::vector<std::string>& names, const std::string& experiment) {
    std::vector<std::string> found;
    for (const BehaviorName& name : FindBehaviors(Study().experiments, names, experiment)) {
      found.push_back(name.text());
    }
    return found;
  };
  EXPECT_THAT(find({"seed2:7", "seed1"}, ""), ElementsAre("crawling/seed2:7", "crawling/seed1"));
  EXPECT_THAT(find({"seed1"}, "other"), ElementsAre("other/seed1"));
  EXPECT_THAT(find({"crawling/seed1", "other/seed1"}, ""),
              ElementsAre("crawling/seed1", "other/seed1"));
  EXPECT_THAT(ErrorOf([&] { find({"seed1"}, ""); }),
              AllOf(HasSubstr("`crawling/seed1`, `other/seed1`"), HasSubstr("--experiment")));
  EXPECT_THAT(ErrorOf([&] { find({"seed22"}, "crawling"); }),
              HasSubstr("there is no run `seed22` in crawling"));
}

// Seed 2 against seed 3 is the one answer that depends on what falls cost.
TEST_F(PreferenceFitTest, AsksFirstWhatTellsMostOfTheWeights) {
  const PreferenceFit none = Fit({});
  ASSERT_THAT(Crawling().groups, SizeIs(3));
  const GroupPair first = *MostInformativePair(none, {});
  EXPECT_EQ(first, GroupPair(1, 2));
  const GroupPair second = *MostInformativePair(Fit({Over("seed2", "seed3")}), {});
  EXPECT_NE(second, first);
  const GroupPair third = *MostInformativePair(Fit({Over("seed2", "seed3")}), {second});
  EXPECT_NE(third, first);
  EXPECT_NE(third, second);
  EXPECT_FALSE(MostInformativePair(none, {first, second, third}));
}

}  // namespace
}  // namespace runtime
