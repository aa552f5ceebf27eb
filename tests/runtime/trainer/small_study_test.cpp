// A real study of minutes, from end to end, as a user works with it: two of the tasks, two seeds
// each, interrupted, continued, looked at meanwhile, evaluated and reported.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "runtime/training/run/sqlite.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::SizeIs;

constexpr int kEpisodes = 60;
constexpr int kWindow = 3;  // a twentieth of them

// What run.db says, without the code that reports are made of.
class RunTables {
 public:
  explicit RunTables(const std::string& folder)
      : database_(folder + "/run.db", SqliteAccess::kRead) {}

  std::vector<double> Returns() const {
    return Column("SELECT return FROM evaluation WHERE is_active ORDER BY episode");
  }
  std::vector<double> CpuSeconds() const {
    return Column("SELECT cpu_seconds FROM episode ORDER BY number");
  }
  // Means of the last episodes by name; `kind`: metric or term.
  std::map<std::string, double> FinalMeans(const std::string& kind) const {
    const std::string value = kind == "term" ? "sum" : "value";
    SqliteStatement row(database_,
                        "SELECT name, avg(" + value + ") FROM evaluation_" + kind + " JOIN " +
                            kind + " USING (task, id) WHERE episode > " +
                            std::to_string(kEpisodes - kWindow) + " GROUP BY name",
                        "read the run");
    std::map<std::string, double> means;
    while (row.Step()) means[row.Text(0)] = row.Real(1);
    return means;
  }

 private:
  std::vector<double> Column(const std::string& query) const {
    SqliteStatement row(database_, query, "read the run");
    std::vector<double> values;
    while (row.Step()) values.push_back(row.Real(0));
    return values;
  }

  SqliteDatabase database_;
};

double Mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Of the `kWindow` values up to and with `last`, an index.
double MeanUpTo(const std::vector<double>& values, size_t last) {
  return Mean({values.begin() + static_cast<std::ptrdiff_t>(last) + 1 - kWindow,
               values.begin() + static_cast<std::ptrdiff_t>(last) + 1});
}

// The first episode whose mean has come 80 % of the way from the first mean to the last; null where
// that is no clear way up: of less than three standard errors.
json EpisodesToMost(const std::vector<double>& returns) {
  const double first = MeanUpTo(returns, kWindow - 1);
  const double last = MeanUpTo(returns, returns.size() - 1);
  std::vector<double> squares;
  for (size_t i = 1; i < returns.size(); ++i) {
    squares.push_back(std::pow(returns[i] - returns[i - 1], 2));
  }
  if (last - first <= 3 * std::sqrt(Mean(squares) / kWindow)) return nullptr;
  for (size_t i = kWindow - 1;; ++i) {
    if (MeanUpTo(returns, i) >= first + 0.8 * (last - first)) return i + 1;
  }
}

void ExpectNear(const json& value, double expected) {
  ASSERT_TRUE(value.is_number());
  EXPECT_NEAR(value.get<double>(), expected, 1e-9 * std::max(1.0, std::abs(expected)));
}

class SmallStudyTest : public TrainerTest {
 protected:
  SmallStudyTest() {
    std::ofstream file(folder() / "small.toml");
    file << "profile = 'fast-tree'\nseeds = '1..2'\nrecord_every = 25\nepisodes = " << kEpisodes
         << "\n";
    for (const char* task : {"crawling", "forward_rolling"}) {
      file << "[[experiments]]\ntask = '" << PAPER_TASKS << "/" << task << ".task'\n";
    }
  }

  std::vector<std::string> Study(const std::string& out) const {
    return {"study", (folder() / "small.toml").string(), "--out", RunFolder(out), "--jobs", "2",
            "--json"};
  }
  void RunStudy(const std::string& out) const {
    const ProgramResult result = Trainer(Study(out));
    ASSERT_EQ(result.exit_status, 0) << result.errors;
  }
  json Report(const std::string& out) const {
    const ProgramResult result = Trainer({"report", RunFolder(out), "--json"});
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return json::parse(result.output);
  }
  std::string CheckpointOf(const std::string& run) const {
    return RunDatabase::OpenToRead(RunFolder(run)).ReadCheckpoint().value().state;
  }

  // Starts the study, asks for its report while it is running, and stops it by Ctrl-C.
  void StartAndInterrupt() const {
    std::vector<std::string> words = Study("study");
    words.insert(words.begin(), TRAINER);
    ChildProcess study(words);
    ASSERT_TRUE(study.WaitForLines(12));
    const json figures = Report("study");
    study.Send(SIGINT);
    EXPECT_EQ(study.Wait().exit_status, 128 + SIGINT);
    int episodes = 0;
    for (const json& experiment : figures["experiments"]) {
      EXPECT_EQ(experiment["is_settled"], false);
      for (const json& run : experiment["runs"]) {
        const auto done = run["episodes"].get<int>();
        EXPECT_EQ(run["final_return"].is_null(), done == 0);
        EXPECT_LT(done, kEpisodes);
        episodes += done;
      }
    }
    EXPECT_GE(episodes, 12);
    for (const std::string& run : kNames) {
      const auto done = RunDatabase::OpenToRead(RunFolder("study/" + run)).ReadEpisodes().size();
      EXPECT_LT(done, static_cast<size_t>(kEpisodes)) << "stopped too late";
    }
  }

  void ExpectRunFigures(const json& run, const std::string& folder) const {
    const RunTables tables(folder);
    const std::vector<double> returns = tables.Returns();
    EXPECT_EQ(run["state"], "finished");
    EXPECT_EQ(run["episodes"], kEpisodes);
    ExpectNear(run["final_return"], MeanUpTo(returns, kEpisodes - 1));
    ExpectNear(run["best_return"], std::ranges::max(returns));
    EXPECT_EQ(run["episodes_to_80_percent"], EpisodesToMost(returns));
    ExpectNear(run["cpu_minutes"], Mean(tables.CpuSeconds()) * kEpisodes / 60);
    for (const std::string kind : {"metric", "term"}) {
      const std::map<std::string, double> means = tables.FinalMeans(kind);
      EXPECT_THAT(run[kind + "s"], SizeIs(means.size()));
      for (const auto& [name, mean] : means) ExpectNear(run[kind + "s"][name], mean);
    }
  }

  void ExpectFigures(const json& experiment) const {
    std::vector<double> final_returns;
    std::vector<double> cpu_minutes;
    for (const json& run : experiment["runs"]) {
      ExpectRunFigures(run, RunFolder("study/" + run["name"].get<std::string>()));
      final_returns.push_back(run["final_return"]);
      cpu_minutes.push_back(run["cpu_minutes"]);
    }
    EXPECT_THAT(final_returns, SizeIs(2));
    EXPECT_EQ(experiment["is_settled"], true);
    EXPECT_EQ(experiment["mean_over"], kWindow);
    EXPECT_EQ(experiment["final_return"]["count"], 2);
    ExpectNear(experiment["final_return"]["mean"], Mean(final_returns));
    ExpectNear(experiment["final_return"]["least"], std::ranges::min(final_returns));
    EXPECT_EQ(experiment["final_return"]["low"], nullptr);  // of two runs
    ExpectNear(experiment["cpu_minutes"]["mean"], Mean(cpu_minutes));
    size_t grouped = 0;
    for (const json& group : experiment["groups"]) grouped += group["runs"].size();
    EXPECT_EQ(grouped, 2u);
  }

  void ExpectEvaluated(const json& experiment) const {
    std::vector<double> learned;
    std::vector<double> there;
    for (const json& run : experiment["runs"]) {
      const std::string folder = RunFolder("study/" + run["name"].get<std::string>());
      const json file = json::parse(std::ifstream(folder + "/evaluation-paper-tree.json"));
      EXPECT_EQ(file["checkpoint_episode"], kEpisodes);
      ExpectNear(file["learned_return"], MeanUpTo(RunTables(folder).Returns(), kEpisodes - 1));
      learned.push_back(file["learned_return"]);
      there.push_back(file["return"]);
    }
    ASSERT_THAT(experiment["evaluations"], SizeIs(1));
    const json& evaluation = experiment["evaluations"][0];
    EXPECT_EQ(evaluation["profile"], "paper-tree");
    EXPECT_EQ(evaluation["return"]["count"], 2);
    ExpectNear(evaluation["return"]["mean"], Mean(there));
    ExpectNear(evaluation["learned_return"]["mean"], Mean(learned));
    if (Mean(learned) > 0) {
      ExpectNear(evaluation["share"], Mean(there) / Mean(learned));
    } else {
      EXPECT_EQ(evaluation["share"], nullptr);
    }
  }

  const std::vector<std::string> kNames = {"crawling-fast-tree/seed1", "crawling-fast-tree/seed2",
                                           "forward_rolling-fast-tree/seed1",
                                           "forward_rolling-fast-tree/seed2"};
};

TEST_F(SmallStudyTest, IsWhatItWouldBeWithoutInterruptionAndItsReportTellsTheTruth) {
  StartAndInterrupt();
  RunStudy("study");
  RunStudy("uninterrupted");
  for (const std::string& run : kNames) {
    ExpectEqual(TraceOf("study/" + run), TraceOf("uninterrupted/" + run));
    EXPECT_TRUE(CheckpointOf("study/" + run) == CheckpointOf("uninterrupted/" + run)) << run;
  }

  const ProgramResult again = Trainer(Study("study"));
  EXPECT_EQ(again.exit_status, 0);
  EXPECT_EQ(again.output, "");  // no episode is repeated

  const ProgramResult evaluated = Trainer({"evaluate", RunFolder("study"), "--profile",
                                           "paper-tree", "--episodes", "1", "--jobs", "2"});
  EXPECT_EQ(evaluated.exit_status, 0) << evaluated.errors;
  const json figures = Report("study");
  EXPECT_THAT(figures["notes"], SizeIs(0));
  ASSERT_THAT(figures["experiments"], SizeIs(2));
  for (const json& experiment : figures["experiments"]) {
    ExpectFigures(experiment);
    ExpectEvaluated(experiment);
  }
}

}  // namespace
}  // namespace runtime
