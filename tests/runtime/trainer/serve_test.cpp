// A trainer that is talked to while it trains.
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"
#include "runtime/live/server/control_socket.h"
#include "tests/runtime/live/server/raw_client.h"
#include "tests/runtime/trainer/trainer_test.h"
#include "tests/scoped_environment.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

constexpr int kManyEpisodes = 100'000;

class ServeTest : public TrainerTest {
 protected:
  // The words of a call of the trainer, with a run that ends only where it is told to.
  std::vector<std::string> Words(const std::string& command) const {
    std::vector<std::string> words = Training("run", kManyEpisodes);
    words.front() = command;
    words.insert(words.begin(), TRAINER);
    return words;
  }

  bool IsAnswering() const {
    for (int tries = 0; tries < 3000; ++tries) {
      if (std::filesystem::exists(RunFolder("run")) && HasTrainer(RunFolder("run"))) return true;
      usleep(10'000);
    }
    return false;
  }

  json ValueOf(const std::string& command, const json& arguments = json::object()) const {
    const Reply reply = Ask(RunFolder("run"), {command, arguments});
    EXPECT_TRUE(reply.ok) << command << ": " << reply.error;
    return reply.value;
  }
};

// A pipe into which nobody writes, and a C++ compiler that does not end.
TEST_F(ServeTest, NothingThatIsLoadedHoldsItUp) {
  const std::string hang = (folder() / "hang").string();
  const std::string number = (folder() / "number").string();
  const std::string compiler = (folder() / "c++").string();
  std::ofstream(compiler) << "#!/bin/sh\nif [ -e " + hang + " ]; then\n  echo $$ >" + number +
                                 ".part; mv " + number + ".part " + number +
                                 "; exec sleep 1000\nfi\nexec g++ \"$@\"\n";
  std::filesystem::permissions(compiler, std::filesystem::perms::owner_all);
  const ScopedEnvironment cxx("CXX", compiler);
  const ScopedEnvironment cache("TASKC_CACHE", (folder() / "cache").string());
  ChildProcess trainer(Words("train"));
  ASSERT_TRUE(IsAnswering());

  const auto swap = [&](const std::filesystem::path& file) {
    return Ask(RunFolder("run"), {"swap", {{"name", "task"}, {"file", file.string()}}});
  };
  for (const char* name : {"pipe.task", "pipe.so"}) {
    ASSERT_EQ(mkfifo((folder() / name).c_str(), 0600), 0);
    EXPECT_THAT(swap(folder() / name).error, HasSubstr("it is a named pipe; name a regular file"));
  }
  EXPECT_TRUE(swap(TaskFile("leaning")).ok);

  std::ofstream(hang) << "now";
  std::thread client([&] {
    try {
      EXPECT_FALSE(swap(TaskFile("upright")).ok);
    } catch (const UserError&) {  // the trainer has ended before it could answer
    }
  });
  pid_t hanging = 0;
  while (!(std::ifstream(number) >> hanging)) usleep(10'000);
  ValueOf("stop");
  EXPECT_EQ(trainer.Wait().exit_status, 0);
  client.join();
  // Gone, or a zombie that nobody has waited for yet.
  std::string pid, name, state = "X";
  std::ifstream("/proc/" + std::to_string(hanging) + "/stat") >> pid >> name >> state;
  EXPECT_THAT(state, testing::AnyOf("X", "Z"));
}

TEST_F(ServeTest, ARunIsLookedAtChangedAndStopped) {
  ChildProcess trainer(Words("train"));
  ASSERT_TRUE(IsAnswering());
  EXPECT_EQ(ValueOf("status")["state"], "running");
  EXPECT_EQ(ValueOf("set", {{"name", "task.limit"}, {"value", "0.25 s"}})["value"], 0.25);
  EXPECT_EQ(
      ValueOf("swap",
              {{"name", "task"}, {"file", TaskFile("upright")}, {"now", true}})["takes_effect"],
      "now");
  EXPECT_EQ(ValueOf("get", {{"name", "task.limit"}})["value"], 0.25);
  ValueOf("stop");
  EXPECT_EQ(trainer.Wait().exit_status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder() / "run" / "control.sock"));
  EXPECT_FALSE(std::filesystem::exists(folder() / "run" / "control.json"));
}

TEST_F(ServeTest, ATaskWithErrorsChangesNothing) {
  ChildProcess trainer(Words("train"));
  ASSERT_TRUE(IsAnswering());
  const ProgramResult result =
      Trainer({"ctl", "--run", RunFolder("run"), "swap", "task", TaskFile("wrong"), "--now"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("did you mean `base.velocity`?"));
  EXPECT_EQ(ValueOf("list")["tasks"].size(), 1u);
  EXPECT_EQ(ValueOf("status")["state"], "running");
}

TEST_F(ServeTest, AKilledTrainersFilesDoNotKeepTheNextFromAnswering) {
  {
    ChildProcess killed(Words("train"));
    ASSERT_TRUE(IsAnswering());
    killed.Send(SIGKILL);
    killed.Wait();
  }
  for (int tries = 0; tries < 3000 && HasTrainer(RunFolder("run")); ++tries) usleep(10'000);
  ASSERT_TRUE(std::filesystem::exists(folder() / "run" / "control.sock"));
  ChildProcess resumed({TRAINER, "resume", RunFolder("run")});
  ASSERT_TRUE(IsAnswering());
  EXPECT_EQ(ValueOf("status")["state"], "running");
}

TEST_F(ServeTest, ServeWaitsWhenAllEpisodesAreDone) {
  std::vector<std::string> words = Training("run", 2);
  words.front() = "serve";
  words.insert(words.begin(), TRAINER);
  ChildProcess trainer(words);
  ASSERT_TRUE(IsAnswering());
  json status;
  for (int tries = 0; tries < 3000 && status["state"] != "finished"; ++tries) {
    status = ValueOf("status");
    usleep(10'000);
  }
  EXPECT_EQ(status["state"], "finished");
  EXPECT_EQ(status["episodes_done"], 2);
  ValueOf("stop");
  EXPECT_EQ(trainer.Wait().exit_status, 0);
}

TEST_F(ServeTest, ThePageIsThatOfTheRunningRun) {
  if (!HAS_REPORT_PAGE) GTEST_SKIP() << "the report's page is not built";
  ChildProcess trainer(Words("train"));
  ASSERT_TRUE(IsAnswering());
  while (ValueOf("status")["episodes_done"] < 1) usleep(10'000);
  RawClient client(ConnectToTrainer(OpenRunFolder(RunFolder("run"))));
  client.Send(RequestText("GET", "/report", ""));
  const RawResponse report = client.Receive();
  EXPECT_EQ(report.status, 200) << report.body;
  EXPECT_THAT(report.body, AllOf(HasSubstr("<html"), HasSubstr("leaning")));
  client.Send(RequestText("GET", "/", ""));
  const RawResponse page = client.Receive();
  EXPECT_EQ(page.status, 200) << page.body;
  EXPECT_THAT(page.body, AllOf(HasSubstr("<html"), HasSubstr("run – live")));
}

TEST_F(ServeTest, TheRecordIsThereBeforeTheFirstEpisodeIsOver) {
  ChildProcess trainer(Words("train"));
  ASSERT_TRUE(IsAnswering());
  RawClient client(ConnectToTrainer(OpenRunFolder(RunFolder("run"))));
  client.Send(RequestText("GET", "/api/record", ""));
  const json record = json::parse(client.Receive().body);
  ASSERT_TRUE(record["ok"]) << record;
  EXPECT_EQ(record["value"]["tasks"][0]["name"], "leaning");
  EXPECT_GT(record["value"]["body"].size(), 0u);
  EXPECT_EQ(record["value"]["recordings"], json::array());
}

TEST_F(ServeTest, ManyRunsAnswerEachInItsFolder) {
  std::vector<std::string> words = Words("train");
  words.insert(words.end(), {"--runs", "2", "--jobs", "2", "--quiet"});
  ChildProcess trainer(words);
  for (const char* seed : {"seed0", "seed1"}) {
    const std::string run = RunFolder("run/" + std::string(seed));
    for (int tries = 0; tries < 3000 && !(std::filesystem::exists(run) && HasTrainer(run));
         ++tries) {
      usleep(10'000);
    }
    EXPECT_EQ(Ask(run, {"status", json::object()}).value["run"], run);
  }
  trainer.Send(SIGTERM);
  trainer.Wait();
}

TEST_F(ServeTest, ARunGoesOnWhereNobodyCanBeServed) {
  Train("run", 1, {"--quiet"});
  std::ofstream(folder() / "run" / "control.sock") << "in the way";
  const ProgramResult trained = Trainer({"resume", RunFolder("run"), "--episodes", "2", "--quiet"});
  EXPECT_EQ(trained.exit_status, 0) << trained.errors;
  EXPECT_THAT(trained.errors,
              AllOf(HasSubstr("move this file away"), HasSubstr("the run continues")));
  const ProgramResult served = Trainer({"serve", RunFolder("run"), "--quiet"});
  EXPECT_EQ(served.exit_status, 1);
  EXPECT_THAT(served.errors, HasSubstr("move this file away"));
}

TEST_F(ServeTest, ClientsThatOnlyLookChangeNothingOfWhatIsLearned) {
  constexpr int kEpisodes = 60;
  Train("alone", kEpisodes, {"--quiet"});
  ChildProcess trainer([this] {
    std::vector<std::string> words = Training("run", kEpisodes, {"--quiet"});
    words.insert(words.begin(), TRAINER);
    return words;
  }());
  ASSERT_TRUE(IsAnswering());
  std::atomic<int> answers = 0;
  const auto pester = [&](const std::vector<Request>& requests) {
    try {
      while (true) {
        for (const Request& request : requests) Ask(RunFolder("run"), request);
        ++answers;
      }
    } catch (const UserError&) {  // the trainer has ended
    }
  };
  std::jthread first(pester, std::vector<Request>{{"status", json::object()},
                                                  {"get", {{"name", "learner"}}},
                                                  {"swap", {{"name", "task"}, {"file", "/none"}}}});
  std::jthread second(pester, std::vector<Request>{{"list", json::object()},
                                                   {"graph", {{"format", "json"}}},
                                                   {"set", {{"name", "task.limit"}}},
                                                   {"nothing", json::object()}});
  std::jthread listener([this] {
    try {
      FollowEvents(RunFolder("run"), [](const json&) { usleep(10'000); });
    } catch (const UserError&) {
    }
  });
  EXPECT_EQ(trainer.Wait().exit_status, 0);
  EXPECT_GT(answers, 10);
  ExpectEqual(TraceOf("alone"), TraceOf("run"));
}

}  // namespace
}  // namespace runtime
