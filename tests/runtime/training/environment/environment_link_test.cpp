#include "runtime/training/environment/environment_link.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/core/module/values.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kGreeting =
    R"({"taskc_environment": 1, "time_step": 0.02, "action": {"low": [-1], "high": [1]},
        "sensors": [{"name": "place", "type": "vec2", "unit": "m"}, {"name": "left", "type": "bool"}]})";

std::string OneLine(std::string text) {
  std::erase(text, '\n');
  return text + "\n";
}

// A program that listens, in a thread of this one.
class EnvironmentLinkTest : public testing::Test {
 protected:
  using Answer = std::function<void(LocalSocket&)>;

  // Greets whoever connects, and does the rest as `answer` says; then it is gone.
  void Listen(Answer answer, const std::string& greeting = kGreeting) {
    listener_.emplace(path());
    thread_ = std::thread([this, greeting, answer = std::move(answer)] {
      std::optional<LocalSocket> socket = listener_->Accept(std::chrono::seconds(60));
      if (!socket) return;
      socket->Write(OneLine(greeting));
      answer(*socket);
    });
  }
  void TearDown() override {
    if (thread_.joinable()) thread_.join();
  }
  std::filesystem::path path() const { return folder_.path() / "s"; }

  template <class Action>
  static std::string Refusal(Action action) {
    try {
      action();
    } catch (const UserError& error) {
      return error.what();
    }
    return "nothing was refused";
  }
  // What follows when the reply to the reset is this line.
  std::string RefusalOf(const std::string& reply) {
    Listen([&](LocalSocket& socket) {
      socket.ReadLine();
      socket.Write(reply + "\n");
    });
    EnvironmentLink link(path());
    link.ExpectNumbers(3);
    const std::string refusal = Refusal([&] { link.Reset(1, 5); });
    thread_.join();
    listener_.reset();
    return refusal;
  }

  const ScratchFolder folder_;
  std::optional<LocalListener> listener_;
  std::thread thread_;
};

std::vector<double> Numbers(const EnvironmentLink& link) {
  return {link.numbers().begin(), link.numbers().end()};
}

TEST_F(EnvironmentLinkTest, SpeaksTextToWhoKnowsNothingElse) {
  std::vector<std::string> requests;
  Listen([&](LocalSocket& socket) {
    requests.push_back(*socket.ReadLine());
    socket.Write("{\"sensors\": [1, 2, 0]}\n");
    requests.push_back(*socket.ReadLine());
    socket.Write(
        "{\"sensors\": [3, 4, 1], \"end\": {\"kind\": \"failure\", \"reason\": \"left\"}}\n");
  });
  EnvironmentLink link(path());
  EXPECT_EQ(link.greeting().time_step, 0.02);
  EXPECT_EQ(link.greeting().sensors[0].unit, "m");
  EXPECT_FALSE(link.greeting().speaks_binary);
  link.ExpectNumbers(3);
  EXPECT_EQ(link.Reset(12, 99).end, std::nullopt);
  EXPECT_THAT(Numbers(link), ElementsAre(1, 2, 0));
  const EnvironmentReply reply = link.Step(Eigen::VectorXd::Constant(1, 0.5));
  thread_.join();
  EXPECT_EQ(reply.end, EndKind::kFailure);
  EXPECT_EQ(reply.reason, "left");
  EXPECT_THAT(Numbers(link), ElementsAre(3, 4, 1));
  EXPECT_THAT(requests, ElementsAre(R"({"reset":{"episode":12,"seed":99}})", R"({"step":[0.5]})"));
}

TEST_F(EnvironmentLinkTest, SpeaksBinaryToWhoUnderstandsIt) {
  std::string line;
  std::array<std::byte, 9> reset, step;
  Listen(
      [&](LocalSocket& socket) {
        const std::array<double, 3> numbers = {1, 2, 0};
        const auto reply = [&](char end) {
          std::string bytes(1, end);
          bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
          socket.Write(bytes);
        };
        line = *socket.ReadLine();
        ASSERT_TRUE(socket.Read(reset));
        reply(0);
        ASSERT_TRUE(socket.Read(step));
        reply(3);
      },
      kGreeting.substr(0, kGreeting.size() - 1) + R"(, "formats": ["json", "binary"]})");
  EnvironmentLink link(path());
  link.ExpectNumbers(3);
  EXPECT_EQ(link.Reset(12, 99).end, std::nullopt);
  const EnvironmentReply reply = link.Step(Eigen::VectorXd::Constant(1, 0.5));
  thread_.join();
  EXPECT_EQ(reply.end, EndKind::kTruncated);
  EXPECT_THAT(Numbers(link), ElementsAre(1, 2, 0));
  EXPECT_EQ(line, R"({"format":"binary"})");
  uint64_t seed = 0;
  double action = 0;
  std::memcpy(&seed, &reset[1], sizeof seed);
  std::memcpy(&action, &step[1], sizeof action);
  EXPECT_EQ(reset[0], std::byte{1});
  EXPECT_EQ(seed, 99u);
  EXPECT_EQ(step[0], std::byte{2});
  EXPECT_EQ(action, 0.5);
}

TEST_F(EnvironmentLinkTest, SaysWhenTheOtherSideIsGone) {
  Listen([](LocalSocket& socket) {
    for (int i = 0; i < 3; ++i) {
      socket.ReadLine();
      socket.Write("{\"sensors\": [1, 2, 0]}\n");
    }
    socket.ReadLine();
  });
  EnvironmentLink link(path());
  link.ExpectNumbers(3);
  link.Reset(12, 99);
  const Eigen::VectorXd action = Eigen::VectorXd::Zero(1);
  link.Step(action);
  link.Step(action);
  EXPECT_EQ(Refusal([&] { link.Step(action); }),
            "the environment at " + path().string() +
                " has closed the connection in episode 12 after 2 time steps");
}

TEST_F(EnvironmentLinkTest, RefusesRepliesThatAreNone) {
  EXPECT_THAT(RefusalOf("hello"), HasSubstr("replies with `hello`: "));
  EXPECT_THAT(RefusalOf("{}"), HasSubstr("docs/environments.md says what a reply is"));
  EXPECT_THAT(RefusalOf(R"({"sensors": [1, 2]})"),
              HasSubstr("`sensors` has 2 numbers, and its sensors have 3"));
  EXPECT_THAT(RefusalOf(R"({"sensors": [1, null, 2]})"), HasSubstr("must be number, but is null"));
  EXPECT_THAT(RefusalOf(R"({"sensors": [1, 1, 2], "end": {"kind": "boredom"}})"),
              HasSubstr("`kind` is no end"));
}

TEST(EnvironmentGreeting, RefusesWhatIsNone) {
  const auto refusal = [](const std::string& line) -> std::string {
    try {
      ParseGreeting(line);
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(kGreeting), "");
  EXPECT_THAT(refusal("HTTP/1.1 400"),
              HasSubstr("it greets with `HTTP/1.1 400`, which is no greeting of an environment"));
  EXPECT_THAT(refusal(R"({"taskc_environment": 2})"),
              HasSubstr("it speaks version 2, and this program version 1"));
  EXPECT_THAT(refusal(R"({"taskc_environment": 1})"), HasSubstr("time_step"));
}

TEST_F(EnvironmentLinkTest, NobodyListens) {
  EXPECT_THAT(Refusal([&] { const LocalSocket socket(path(), std::chrono::milliseconds(1)); }),
              HasSubstr("nobody answers at this socket"));
}

TEST_F(EnvironmentLinkTest, APlaceIsTakenOnlyOnce) {
  {
    const LocalListener first(path());
    EXPECT_THAT(Refusal([&] { const LocalListener second(path()); }),
                HasSubstr("there is such a file already, or somebody listens there"));
  }
  const LocalListener third(path());  // the first has cleaned up
}

}  // namespace
}  // namespace runtime
