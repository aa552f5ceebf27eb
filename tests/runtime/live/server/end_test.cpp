// How a server begins and ends.
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <future>

#include "tests/runtime/live/server/follower.h"
#include "tests/runtime/live/server/server_test.h"

namespace runtime {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

class EndTest : public ServerTest {
 protected:
  std::chrono::duration<double> TimeToEnd() {
    const auto begin = Clock::now();
    server_.reset();
    return Clock::now() - begin;
  }
};

TEST_F(EndTest, LeavesNothingBehind) {
  Start();
  EXPECT_LT(TimeToEnd(), 300ms);
  EXPECT_TRUE(std::filesystem::is_empty(folder()));
  EXPECT_FALSE(HasTrainer(folder()));
  EXPECT_THAT(ErrorOf([&] {
                Ask(folder(), {"status", json::object()});
              }),
              HasSubstr("no trainer is running for this run; `trainer resume"));
}

TEST_F(EndTest, IsPromptWhileClientsAreConnected) {
  Start();
  RawClient idle = OnPort();
  RawClient half = OnPort();
  half.Send("POST /api/sta");
  RawClient waiting = OnPort();
  waiting.Send(RequestText("POST", "/api/save", Credentials()));
  const ReplyHandler reply = handler_.TakeSave();
  Follower follower(folder());
  follower.WaitUntilItHears(*server_);
  EXPECT_LT(TimeToEnd(), 300ms);
  for (RawClient* client : {&idle, &half, &waiting}) EXPECT_TRUE(client->IsClosed());
  follower.Wait();
  reply({.value = "too late"});
}

TEST_F(EndTest, IsPromptWhereClientsTakeNothing) {
  const std::string page(20'000'000, 'x');
  server_.emplace(ServerOptions{.folder = folder()}, handler_,
                  [&](Page, const std::string&, const std::string&) { return page; });
  RawClient client = OnSocket();
  client.Send(RequestText("GET", "/", ""));
  std::this_thread::sleep_for(100ms);
  EXPECT_LT(TimeToEnd(), 1500ms);
}

TEST_F(EndTest, RepliesAndEventsOfTheLastMomentArrive) {
  Start();
  Follower follower(folder());
  follower.WaitUntilItHears(*server_);
  std::future<Reply> saving = std::async(std::launch::async, [this] {
    return Ask(folder(), {"save", json::object()});
  });
  const ReplyHandler reply = handler_.TakeSave();
  server_->Publish({{"event", "state"}, {"state", "finished"}});
  reply({.value = "saved"});
  EXPECT_LT(TimeToEnd(), 300ms);
  EXPECT_EQ(saving.get().value, "saved");
  EXPECT_EQ(follower.Wait().back()["state"], "finished");
}

TEST_F(EndTest, AClientIsToldWhereTheTrainerEndsBeforeItReplies) {
  Start();
  std::future<std::string> error = std::async(std::launch::async, [this] {
    return ErrorOf([this] { Ask(folder(), {"save", json::object()}); });
  });
  handler_.TakeSave();
  server_.reset();
  EXPECT_THAT(error.get(), HasSubstr("before it answered"));
}

TEST_F(EndTest, ASocketOfAKilledTrainerIsReplaced) {
  const pid_t killed = fork();
  if (killed == 0) {
    const Descriptor run_folder = OpenRunFolder(folder());
    const ControlSocket socket(run_folder, folder());
    _exit(0);
  }
  int status = 0;
  waitpid(killed, &status, 0);
  ASSERT_EQ(status, 0);
  ASSERT_TRUE(std::filesystem::exists(folder() / "control.sock"));
  std::ofstream(folder() / "control.json") << "{";
  std::ofstream(folder() / "control.json.part") << "{";
  EXPECT_FALSE(HasTrainer(folder()));
  Start();
  EXPECT_TRUE(Ask(folder(), {"status", json::object()}).ok);
  server_.reset();
  EXPECT_TRUE(std::filesystem::is_empty(folder()));
}

TEST_F(EndTest, ALivingTrainersSocketIsNot) {
  Start();
  EXPECT_THAT(ErrorOf([this] { Server({.folder = folder()}, handler_, {}); }),
              HasSubstr("another trainer listens here"));
  EXPECT_TRUE(Ask(folder(), {"status", json::object()}).ok);
}

TEST_F(EndTest, AFileOfTheUsersIsNotRemoved) {
  std::ofstream(folder() / "control.sock") << "mine";
  EXPECT_THAT(ErrorOf([this] { Server({.folder = folder()}, handler_, {}); }),
              HasSubstr("move this file away"));
  EXPECT_EQ(std::filesystem::file_size(folder() / "control.sock"), 4u);
}

TEST_F(EndTest, APortThatIsTakenIsAnError) {
  Start();
  const TemporaryFolder other;
  const ServerOptions options = {.folder = other.path(), .port = static_cast<uint16_t>(port_)};
  EXPECT_THAT(ErrorOf([&] { Server(options, handler_, {}); }),
              testing::AllOf(HasSubstr("cannot listen"), HasSubstr("--port")));
  EXPECT_TRUE(std::filesystem::is_empty(other.path()));
}

TEST_F(EndTest, AFolderMayHaveALongPath) {
  std::filesystem::path deep = folder();
  for (int i = 0; i < 10; ++i) deep /= std::string(40, 'x');
  std::filesystem::create_directories(deep);
  const Server server({.folder = deep}, handler_, {});
  EXPECT_TRUE(Ask(deep, {"status", json::object()}).ok);
}

}  // namespace
}  // namespace runtime
