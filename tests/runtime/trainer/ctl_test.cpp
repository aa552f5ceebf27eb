// The program `trainer ctl`, and a trainer that notes what it is asked for.
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "runtime/live/control/command_table.h"
#include "runtime/live/server/server.h"
#include "tests/runtime/live/server/fake_handler.h"
#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class CtlTest : public TrainerTest {
 protected:
  void SetUp() override { server_.emplace(ServerOptions{.folder = folder()}, handler_, nullptr); }

  // "ctl --run FOLDER" and these words.
  ProgramResult Ctl(std::vector<std::string> words) const {
    words.insert(words.begin(), {"ctl", "--run", folder().string()});
    return Trainer(std::move(words));
  }

  // What the words of a command line ask the trainer for.
  json Asked(std::vector<std::string> words) const {
    words.push_back("--json");
    const ProgramResult result = Ctl(std::move(words));
    EXPECT_EQ(result.exit_status, 0) << result.errors;
    return json::parse(result.output)["value"];
  }

  static json Question(const std::string& command, const json& arguments) {
    return {{"command", command}, {"arguments", arguments}};
  }

  FakeHandler handler_;
  std::optional<Server> server_;
};

TEST_F(CtlTest, CommandLinesBecomeRequests) {
  const std::string file = (std::filesystem::current_path() / "a.task").string();
  EXPECT_EQ(Asked({"status"}), Question("status", json::object()));
  EXPECT_EQ(Asked({"load", "a.task"}), Question("load", {{"file", file}}));
  EXPECT_EQ(Asked({"load", "x/../a.task", "as", "careful"}),
            Question("load", {{"file", file}, {"name", "careful"}}));
  EXPECT_EQ(Asked({"load", "--as", "careful", "a.task"}),
            Question("load", {{"file", file}, {"name", "careful"}}));
  EXPECT_EQ(
      Asked({"swap", "task", "/a.so", "--now", "--forget"}),
      Question("swap", {{"name", "task"}, {"file", "/a.so"}, {"now", true}, {"forget", true}}));
  EXPECT_EQ(Asked({"rollback", "task", "--now"}),
            Question("rollback", {{"name", "task"}, {"now", true}}));
  EXPECT_EQ(Asked({"rollback", "task", "a1b2c3d4"}),
            Question("rollback", {{"name", "task"}, {"version", "a1b2c3d4"}}));
  EXPECT_EQ(Asked({"promote", "careful"}), Question("promote", {{"name", "careful"}}));
  EXPECT_EQ(Asked({"get", "task.gain"}), Question("get", {{"name", "task.gain"}}));
  EXPECT_EQ(Asked({"set", "task.gain", "-0.5"}),
            Question("set", {{"name", "task.gain"}, {"value", -0.5}}));
  EXPECT_EQ(Asked({"set", "task.gain", "=", "1", "->", "2", "over", "3", "episodes"}),
            Question("set", {{"name", "task.gain"}, {"from", 1.0}, {"to", 2.0}, {"episodes", 3}}));
  EXPECT_EQ(Asked({"hold", "task.side", "-1"}),
            Question("hold", {{"name", "task.side"}, {"value", -1}}));
  EXPECT_EQ(Asked({"hold", "task.velocity", "0.5", "-0.1"}),
            Question("hold", {{"name", "task.velocity"}, {"value", {0.5, -0.1}}}));
  EXPECT_EQ(Asked({"release", "task.velocity"}), Question("release", {{"name", "task.velocity"}}));
  EXPECT_EQ(Asked({"connect", "task.reward", "learner.reward"}),
            Question("connect", {{"first", "task.reward"}, {"second", "learner.reward"}}));
  EXPECT_EQ(Asked({"module", "add", "NgNet", "net", "units=20", "file=a.task"}),
            Question("module_add", {{"type", "NgNet"},
                                    {"name", "net"},
                                    {"parameters", {{"units", 20}, {"file", file}}}}));
  EXPECT_EQ(Asked({"module", "remove", "net"}), Question("module_remove", {{"name", "net"}}));
  EXPECT_EQ(Asked({"step"}), Question("step", json::object()));
  EXPECT_EQ(Asked({"step", "10", "--episodes"}),
            Question("step", {{"count", 10}, {"unit", "episode"}}));
  EXPECT_EQ(Asked({"graph", "--format", "dot"}), Question("graph", {{"format", "dot"}}));
}

TEST_F(CtlTest, EveryCommandOfTheTableCanBeGiven) {
  for (const CommandSpec& command : Commands()) {
    std::string words = command.name;
    std::ranges::replace(words, '_', ' ');
    std::vector<std::string> line = {"ctl"};
    line.push_back(words.substr(0, words.find(' ')));
    if (words.find(' ') != std::string::npos) line.push_back(words.substr(words.find(' ') + 1));
    line.push_back("--help");
    const ProgramResult result = Trainer(line);
    EXPECT_EQ(result.exit_status, 0) << words;
    EXPECT_THAT(result.output, HasSubstr(command.doc));
  }
}

TEST_F(CtlTest, WrongLinesAreRefusedBeforeTheTrainerHearsOfThem) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"swop"},
                                             {"status", "now"},
                                             {"swap", "task"},
                                             {"step", "x"},
                                             {"set", "task.gain"},
                                             {"hold", "task.side"},
                                             {"load", "a.task", "is", "b"},
                                             {"module", "add", "NgNet", "net", "units"}}) {
    const ProgramResult result = Ctl(words);
    EXPECT_EQ(result.exit_status, 2) << words.front();
    EXPECT_THAT(result.errors, testing::StartsWith("trainer: error: "));
  }
  EXPECT_THAT(Trainer({"ctl", "swop"}).errors, HasSubstr("did you mean `trainer ctl swap`?"));
  EXPECT_EQ(handler_.count(), 0);
}

TEST_F(CtlTest, ARefusalIsAnError) {
  const ProgramResult text = Ctl({"unload", "shadow"});
  EXPECT_EQ(text.exit_status, 1);
  EXPECT_EQ(text.errors, "there is no task module `shadow`\nthere is `task`\n");
  const ProgramResult with_json = Ctl({"unload", "shadow", "--json"});
  EXPECT_EQ(with_json.exit_status, 1);
  EXPECT_EQ(json::parse(with_json.output),
            (json{{"ok", false}, {"error", "there is no task module `shadow`\nthere is `task`"}}));
}

TEST_F(CtlTest, PeopleGetText) {
  EXPECT_EQ(Ctl({"pause"}).output, "arguments  -\ncommand    pause\n");
}

TEST_F(CtlTest, FindsTheRunByItself) {
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(folder());
  const ProgramResult none = Trainer({"ctl", "status"});
  std::filesystem::create_directories("runs/one");
  std::ofstream("runs/one/run.db") << "a run";
  const Server other({.folder = "runs/one"}, handler_, nullptr);
  const ProgramResult one = Trainer({"ctl", "status", "--json"});
  std::filesystem::current_path(here);
  EXPECT_EQ(none.exit_status, 1);
  EXPECT_THAT(none.errors, HasSubstr("--run DIR"));
  EXPECT_EQ(one.exit_status, 0) << one.errors;
}

TEST_F(CtlTest, SaysThatNoTrainerIsThere) {
  server_.reset();
  const ProgramResult result = Ctl({"status"});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr(folder().string()), HasSubstr("trainer resume")));
}

TEST_F(CtlTest, ThePageHasAnAddress) {
  const ProgramResult page = Ctl({"page"});
  EXPECT_EQ(page.exit_status, 0) << page.errors;
  EXPECT_EQ(page.output, server_->page_address() + "\n");
  EXPECT_EQ(json::parse(Ctl({"page", "--json"}).output)["value"], server_->page_address());
  server_.reset();
  const ProgramResult none = Ctl({"page"});
  EXPECT_EQ(none.exit_status, 1);
  EXPECT_THAT(none.errors, HasSubstr("no trainer is running there"));
}

TEST_F(CtlTest, EventsComeAsTheyHappenUntilTheTrainerEnds) {
  ChildProcess text({TRAINER, "ctl", "events", "--run", folder().string()});
  ChildProcess with_json({TRAINER, "ctl", "--run", folder().string(), "events", "--json"});
  for (ChildProcess* process : {&text, &with_json}) {
    std::jthread greeter([this](std::stop_token stop) {
      while (!stop.stop_requested()) {
        server_->Publish({{"event", "state"}, {"state", "running"}});
        usleep(10'000);
      }
    });
    ASSERT_TRUE(process->WaitForLines(1));
  }
  server_->Publish({{"event", "warning"}, {"text", "it is late"}});
  server_.reset();
  const ProgramResult lines = text.Wait();
  EXPECT_EQ(lines.exit_status, 0) << lines.errors;
  EXPECT_THAT(lines.output, AllOf(testing::StartsWith("the run is running\n"),
                                  testing::EndsWith("\nwarning: it is late\n")));
  EXPECT_THAT(with_json.Wait().output,
              testing::EndsWith("\n{\"event\":\"warning\",\"text\":\"it is late\"}\n"));
}

TEST_F(CtlTest, WatchSwapsOnEverySave) {
  std::filesystem::copy_file(TaskFile("leaning"), folder() / "base.task");
  const std::filesystem::path task = folder() / "it's.task";
  std::ofstream(task) << "task its extends \"base.task\"\n";
  ChildProcess watch(
      {TRAINER, "ctl", "watch", task.string(), "--now", "--json", "--run", folder().string()});
  ASSERT_TRUE(watch.WaitForLines(1));
  std::ofstream(task, std::ios::app) << "\n";
  EXPECT_TRUE(watch.WaitForLines(2));
  std::ofstream(folder() / "base.task", std::ios::app) << "\n";
  EXPECT_TRUE(watch.WaitForLines(3));
  // As many editors save.
  std::filesystem::copy_file(task, folder() / "new");
  std::filesystem::rename(task, folder() / "it's.task~");
  std::filesystem::rename(folder() / "new", task);
  EXPECT_TRUE(watch.WaitForLines(4));
  watch.Send(SIGINT);
  const ProgramResult result = watch.Wait();
  EXPECT_EQ(result.signal, SIGINT);
  std::istringstream lines(result.output);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(json::parse(line),
            (json{{"watching", {(folder() / "base.task").string(), task.string()}}}));
  while (std::getline(lines, line)) {
    const json reply = json::parse(line);
    EXPECT_EQ(reply["value"],
              Question("swap", {{"name", "task"}, {"file", task.string()}, {"now", true}}));
    EXPECT_GE(reply["milliseconds"], 0);
  }
}

TEST_F(CtlTest, WatchGoesOnWhereTheTaskIsWrongUntilTheTrainerEnds) {
  const std::filesystem::path task = folder() / "wrong.task";
  std::ofstream(task) << "task wrong";
  ChildProcess watch({TRAINER, "ctl", "watch", task.string(), "--run", folder().string()});
  ASSERT_TRUE(watch.WaitForLines(1));
  std::ofstream(task) << "task still wrong";
  ASSERT_TRUE(watch.WaitForLines(2));
  server_.reset();
  const ProgramResult result = watch.Wait();
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.output, HasSubstr("wrong.task takes effect: "));
  EXPECT_THAT(result.errors, AllOf(HasSubstr("the trainer has ended"),
                                   HasSubstr("trainer resume " + folder().string())));
}

TEST_F(CtlTest, WatchNeedsATrainer) {
  server_.reset();
  const ProgramResult result = Ctl({"watch", TaskFile("leaning")});
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.errors, HasSubstr("no trainer is running for this run"));
}

TEST_F(CtlTest, WatchNeedsAFile) {
  EXPECT_EQ(Ctl({"watch", (folder() / "absent.task").string()}).exit_status, 2);
}

}  // namespace
}  // namespace runtime
