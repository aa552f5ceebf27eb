// A folder of runs that is served: which there are, and to start, pause, continue and stop them.
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "runtime/live/client/client.h"
#include "runtime/trainer/serve/new_runs.h"
#include "runtime/trainer/serve/runs_service.h"
#include "tests/runtime/live/server/command_rows.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/runtime/training/run/error_of.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class ServeRunsTest : public TrainerTest {
 protected:
  void Serve(std::vector<std::string> more = {}) {
    std::filesystem::create_directories(runs());
    std::vector<std::string> words = {TRAINER, "serve", runs().string()};
    words.insert(words.end(), more.begin(), more.end());
    server_.emplace(words);
    ASSERT_TRUE(server_->WaitForLines(1));
  }

  std::filesystem::path runs() const { return std::filesystem::canonical(folder()) / "runs"; }

  Reply AskServer(const std::string& command, const json& arguments = json::object()) const {
    return Ask(runs(), {command, arguments});
  }
  json ValueOf(const std::string& command, const json& arguments = json::object()) const {
    const Reply reply = AskServer(command, arguments);
    EXPECT_TRUE(reply.ok) << command << ": " << reply.error;
    return reply.value;
  }
  json RunNamed(const std::string& name) const {
    const json listing = ValueOf("runs");
    for (const json& run : listing["runs"]) {
      if (run["name"] == name) return run;
    }
    return json::object();
  }
  // The run, once `member` is `value`.
  json WaitFor(const std::string& name, const char* member, const json& value) const {
    json run;
    for (int tries = 0; tries < 1200; ++tries, usleep(50'000)) {
      run = RunNamed(name);
      if (run.value(member, json()) == value) return run;
    }
    ADD_FAILURE() << member << " never was " << value << ": " << run;
    return run;
  }
  json StartOf(int episodes) const {
    return {{"task", TaskFile("leaning")}, {"profile", "fast"}, {"episodes", episodes}};
  }

  std::optional<ChildProcess> server_;
};

TEST_F(ServeRunsTest, ListsTheRunsThatAreThere) {
  Train("runs/old", 3);
  Serve();
  const json run = RunNamed("old");
  EXPECT_EQ(run["state"], "finished");
  EXPECT_EQ(run["task"], "leaning");
  EXPECT_EQ(run["profile"], "fast");
  EXPECT_EQ(run["episodes"], 3);
  EXPECT_EQ(run["episodes_planned"], 3);
  EXPECT_EQ(run["sparkline"].size(), 3u);
  EXPECT_EQ(run["address"], "");
  const std::vector<EpisodeRecord> episodes =
      RunDatabase::OpenToRead(runs() / "old").ReadEpisodes();
  EXPECT_DOUBLE_EQ(run["last_return"].get<double>(),
                   static_cast<float>(episodes.back().active.episode_return));
  const json curve = ValueOf("curve", {{"run", "old"}, {"after", "1"}});
  EXPECT_EQ(curve["after"], 1);
  EXPECT_EQ(curve["returns"].get<std::string>().size(), 12u);  // two floats in base64
  EXPECT_THAT(AskServer("curve", {{"run", "../old"}}).error, HasSubstr("there is no run"));
}

TEST_F(ServeRunsTest, StartsPausesContinuesAndStopsRuns) {
  Serve({"--jobs", "1"});
  json wanted = StartOf(1'000'000);
  wanted["runs"] = 2;
  wanted["seed"] = 4;
  EXPECT_THAT(ValueOf("start", wanted)["runs"],
              ElementsAre("leaning-fast/seed4", "leaning-fast/seed5"));
  WaitFor("leaning-fast/seed4", "state", "running");
  EXPECT_EQ(RunNamed("leaning-fast/seed5")["state"], "waiting");  // for its turn
  EXPECT_THAT(AskServer("start", wanted).error, HasSubstr("seed4"));
  EXPECT_THAT(AskServer("pause", {{"run", "nobody"}}).error, HasSubstr("there is no run `nobody`"));
  const json run = WaitFor("leaning-fast/seed4", "state", "running");
  EXPECT_EQ(run["seed"], 4);
  EXPECT_THAT(run["address"], HasSubstr("http://127.0.0.1:"));

  EXPECT_EQ(ValueOf("pause", {{"run", "leaning-fast/seed4"}})["state"], "paused");
  WaitFor("leaning-fast/seed4", "state", "paused");
  ValueOf("resume", {{"run", "leaning-fast/seed4"}});
  WaitFor("leaning-fast/seed4", "state", "running");

  ValueOf("stop", {{"run", "leaning-fast/seed4"}});
  WaitFor("leaning-fast/seed4", "state", "stopped");
  WaitFor("leaning-fast/seed5", "state", "running");  // it is its turn
  ValueOf("stop", {{"run", "leaning-fast/seed5"}});
  WaitFor("leaning-fast/seed5", "state", "stopped");

  const int64_t done = RunNamed("leaning-fast/seed4")["episodes"];
  ValueOf("resume", {{"run", "leaning-fast/seed4"}});
  WaitFor("leaning-fast/seed4", "state", "running");
  for (int tries = 0; tries < 1200 && RunNamed("leaning-fast/seed4")["episodes"] <= done; ++tries) {
    usleep(50'000);
  }
  EXPECT_GT(RunNamed("leaning-fast/seed4")["episodes"], done);
  server_->Send(SIGINT);
  EXPECT_EQ(server_->Wait().exit_status, 128 + SIGINT);
  EXPECT_EQ(RunDatabase::OpenToRead(runs() / "leaning-fast/seed4").ReadState(),
            RunState::kInterrupted);
}

// Its bits are those of a run that was started by hand.
TEST_F(ServeRunsTest, ARunIsTheSameAsByTrain) {
  Train("by-hand", 5, {"--seed", "3"});
  Serve();
  json wanted = StartOf(5);
  wanted["seed"] = 3;
  ValueOf("start", wanted);
  WaitFor("leaning-fast/seed3", "state", "finished");
  ExpectEqual(TraceOf("by-hand"), TraceOf("runs/leaning-fast/seed3"));
}

TEST_F(ServeRunsTest, SeesWhatOthersTrain) {
  Serve();
  ChildProcess other([&] {
    std::vector<std::string> words = Training("runs/other", 1'000'000, {"--quiet"});
    words.insert(words.begin(), TRAINER);
    return words;
  }());
  WaitFor("other", "state", "running");
  ValueOf("stop", {{"run", "other"}});
  WaitFor("other", "state", "stopped");
  EXPECT_EQ(other.Wait().exit_status, 0);
  EXPECT_THAT(AskServer("stop", {{"run", "other"}}).error, HasSubstr("nobody trains `other`"));
}

TEST_F(ServeRunsTest, SaysWhyARunCannotBeMade) {
  Serve();
  std::ofstream(folder() / "wrong.task") << "task wrong for humanoid\nmetric a = base.positio.x\n";
  ValueOf("start", {{"task", (folder() / "wrong.task").string()}});
  const json run = WaitFor("wrong/seed0", "state", "failed");
  EXPECT_THAT(run["failure"].get<std::string>(),
              AllOf(HasSubstr("wrong.task:2:"), HasSubstr("base.position")));
  EXPECT_THAT(AskServer("start", {{"task", "nowhere.task"}}).error, HasSubstr("no such file"));
  json wanted = StartOf(3);
  wanted["profile"] = "fsat";
  EXPECT_THAT(AskServer("start", wanted).error, HasSubstr("did you mean `fast`?"));
}

TEST_F(ServeRunsTest, RefusesAFolderThatIsServedAlready) {
  Serve();
  const ProgramResult second = Trainer({"serve", runs().string()});
  EXPECT_EQ(second.exit_status, 1);
  EXPECT_THAT(second.errors, HasSubstr("another trainer listens here"));
}

TEST(NewRuns, StayInTheirFolder) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.task") << "task a for humanoid\n";
  const auto named = [&](const char* name) {
    return ErrorOf([&] {
      NewRuns({{"task", (folder.path() / "a.task").string()}, {"name", name}}, folder.path(), "");
    });
  };
  EXPECT_EQ(named("many"), "");
  EXPECT_EQ(named("many/more"), "");
  for (const char* name : {"..", "../other", "many/../../other", "/tmp/other"}) {
    EXPECT_THAT(named(name), HasSubstr("is no name of a folder in this one")) << name;
  }
}

TEST(Documentation, ListsTheCommandsOfAFolderOfRuns) { ExpectListed(API_PAGE, RunsCommands()); }

}  // namespace
}  // namespace runtime
