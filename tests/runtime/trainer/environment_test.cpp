// `trainer environment` as a program at the other end of its socket knows it.
#include <gmock/gmock.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/local_socket.h"
#include "tests/runtime/trainer/child_process.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class EnvironmentTest : public testing::Test {
 protected:
  EnvironmentTest()
      : environment_({TRAINER, "environment", TASKS "/swaying.task", "--socket", Path().string(),
                      "--profile", "fast-tree"}) {
    EXPECT_TRUE(environment_.WaitForLines(1));
  }

  std::filesystem::path Path() const { return folder_.path() / "s"; }

 private:
  TemporaryFolder folder_;
  ChildProcess environment_;
};

class Client {
 public:
  explicit Client(const std::filesystem::path& path)
      : socket_(path, std::chrono::seconds(5)), greeting_(json::parse(*socket_.ReadLine())) {}

  const json& greeting() const { return greeting_; }

  json Ask(const json& request) {
    EXPECT_TRUE(socket_.Write(request.dump() + "\n"));
    return json::parse(socket_.ReadLine().value_or("null"));
  }
  json Step() { return Ask({{"step", std::vector(Size("action"), 0.1)}}); }

  void SpeakBinary() { socket_.Write("{\"format\": \"binary\"}\n"); }
  void WriteReset(uint64_t seed) {
    Write(uint8_t{1});
    Write(seed);
  }
  void WriteStep() {
    Write(uint8_t{2});
    for (size_t i = 0; i < Size("action"); ++i) Write(0.1);
  }
  void WriteSet(uint32_t param, double value) {
    Write(uint8_t{3});
    Write(param);
    Write(value);
  }
  // Of the next reply; nothing where the connection was closed.
  std::optional<double> ReadReward() {
    uint8_t end = 0;
    double reward = 0;
    if (!Read(end) || !Read(reward)) return std::nullopt;
    double observed = 0;
    for (size_t i = 0; i < Size("observation"); ++i) Read(observed);
    return reward;
  }

 private:
  size_t Size(const char* part) const {
    if (part == std::string("action")) return greeting_["action"]["low"].size();
    size_t size = 0;
    for (const json& value : greeting_["observation"]) size += value["size"].get<size_t>();
    return size;
  }
  template <class Number>
  void Write(Number number) {
    socket_.Write({reinterpret_cast<const char*>(&number), sizeof number});
  }
  template <class Number>
  bool Read(Number& number) {
    return socket_.Read(std::as_writable_bytes(std::span(&number, 1)));
  }

  LocalSocket socket_;
  const json greeting_;
};

TEST_F(EnvironmentTest, SaysWhichParamsTheTaskHas) {
  const Client client(Path());
  EXPECT_EQ(
      client.greeting()["params"],
      json::array(
          {{{"name", "task.gain"}, {"unit", "1/s"}, {"value", 2.0}, {"low", 0.0}, {"high", 5.0}}}));
}

TEST_F(EnvironmentTest, SetsAParameterFromTheNextDecisionOn) {
  Client client(Path());
  Client other(Path());
  EXPECT_EQ(client.Ask({{"set", "task.gain"}, {"value", "5 1/s"}}),
            json({{"set", "task.gain"}, {"value", 5.0}}));
  for (Client* each : {&client, &other}) each->Ask({{"reset", {{"seed", 1}}}});
  const double first = client.Step()["reward"];
  EXPECT_GT(first, other.Step()["reward"].get<double>());
  client.Ask({{"set", "task.gain"}, {"value", 2}});
  EXPECT_EQ(client.Step(), other.Step());
}

TEST_F(EnvironmentTest, RefusesAValueAndGoesOn) {
  Client client(Path());
  const auto refusal = [&](const char* parameter, const json& value) {
    return client.Ask({{"set", parameter}, {"value", value}})["error"].get<std::string>();
  };
  EXPECT_EQ(refusal("task.gain", 6), "`task.gain` must lie in 0 .. 5, and 6 does not");
  EXPECT_EQ(refusal("task.gain", "2 m"), "`task.gain` is a number in 1/s, and `2 m` is not one");
  EXPECT_EQ(refusal("task.gain", nullptr), "`task.gain` cannot be null");
  EXPECT_THAT(refusal("task.gian", 1), HasSubstr("did you mean `gain`?"));
  EXPECT_THAT(refusal("environment.profile", "fast"), HasSubstr("has no effect any more"));
  EXPECT_THAT(client.Ask({{"set", "task.gain"}})["error"].get<std::string>(),
              HasSubstr("a request is "));
  EXPECT_TRUE(client.Ask({{"reset", {{"seed", 1}}}}).contains("observation"));
}

TEST_F(EnvironmentTest, SetsAParamByItsNumberInBinaryMessages) {
  Client text(Path());
  text.Ask({{"set", "task.gain"}, {"value", 5}});
  text.Ask({{"reset", {{"seed", 1}}}});
  Client client(Path());
  client.SpeakBinary();
  client.WriteReset(1);
  EXPECT_EQ(client.ReadReward(), 0);
  client.WriteSet(0, 5);
  client.WriteStep();
  EXPECT_EQ(client.ReadReward(), text.Step()["reward"].get<double>());
}

TEST_F(EnvironmentTest, EndsAConnectionThatSetsWhatDoesNotFitInBinaryMessages) {
  for (const auto& [param, value] : {std::pair<uint32_t, double>{0, 6}, {1, 1}}) {
    Client client(Path());
    client.SpeakBinary();
    client.WriteSet(param, value);
    client.WriteReset(1);
    EXPECT_EQ(client.ReadReward(), std::nullopt) << param;
  }
}

}  // namespace
}  // namespace runtime
