// What a program says to an environment of another program, over a socket: docs/environments.md has
// the messages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/local_socket.h"
#include "runtime/core/module/action_limits.h"
#include "runtime/core/module/values.h"

namespace runtime {

// A sensor that the environment has.
struct OfferedSensor {
  std::string name;
  std::string type;
  std::string unit;
};

// What the environment says of itself when somebody connects.
struct EnvironmentGreeting {
  double time_step = 0;  // [s]
  ActionLimits limits;
  std::vector<OfferedSensor> sensors;
  bool speaks_binary = false;
};

// How an episode goes on after a reset or a step.
struct EnvironmentReply {
  std::optional<EndKind> end;  // by which the environment has ended it
  std::string reason;          // "": it says none
};

// The greeting with all that it must have. Throws UserError, which says what is wrong with it.
EnvironmentGreeting ParseGreeting(const std::string& line);

class EnvironmentLink {
 public:
  // Connects and reads the greeting. Throws UserError, with the path, here and below.
  explicit EnvironmentLink(const std::filesystem::path& path);

  const EnvironmentGreeting& greeting() const { return greeting_; }

  // How many numbers a reply has. Before the first reset.
  void ExpectNumbers(size_t count) { numbers_.resize(count); }

  EnvironmentReply Reset(int64_t episode, uint64_t seed);
  // In the binary format nothing is allocated.
  EnvironmentReply Step(const Eigen::VectorXd& action);
  // The sensors' elements after the last reply, all finite, in the order of the greeting.
  std::span<const double> numbers() const { return numbers_; }

 private:
  EnvironmentReply Exchange(const std::string& request);
  EnvironmentReply ReadText();
  EnvironmentReply ReadBinary();
  [[noreturn]] void ThrowGone() const;
  [[noreturn]] void ThrowForeign(const std::string& reply, const std::string& what) const;

  std::filesystem::path path_;
  LocalSocket socket_;
  EnvironmentGreeting greeting_;
  std::vector<double> numbers_;
  std::string request_;
  int64_t episode_ = 0;  // 0: none yet
  int64_t steps_ = 0;    // of this episode
};

}  // namespace runtime
