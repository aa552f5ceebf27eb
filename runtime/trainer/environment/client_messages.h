// The messages between `trainer environment` and who connects to it: docs/environments.md.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runtime/base/local_socket.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/observations.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

struct ResetRequest {
  std::optional<uint64_t> seed;
};
struct StepRequest {};  // the action is in ClientMessages::action()
struct SetRequest {
  std::string parameter;  // "task.weight"
  ParameterValue value;
};
struct ForeignRequest {
  std::string what;
};
using ClientRequest = std::variant<ResetRequest, StepRequest, SetRequest, ForeignRequest>;

// A param of the task, as the greeting lists it.
struct OfferedParam {
  std::string name;  // "task.weight"
  std::string unit;
  double minimum = 0;
  double maximum = 0;
  ParameterValue value;
};

// What is wrong with a request ends no connection in the text format, and ends it in the binary
// one.
struct ClientIsGone {};

class ClientMessages {
 public:
  explicit ClientMessages(LocalSocket socket) : socket_(std::move(socket)) {}

  // All that wait for or send a message throw ClientIsGone.

  // `about`: a JSON object, to which the action, the observation and the params are added.
  void Greet(const std::string& about, int action_size, const ObservationLayout& observation,
             std::vector<OfferedParam> params);
  ClientRequest Wait();
  const Eigen::VectorXd& action() const { return action_; }

  // Replies to a reset, and to a step after which the episode goes on.
  void TellStart(const Eigen::VectorXd& observation);
  void TellStep(const Eigen::VectorXd& observation, double reward, double time);
  // Replies to the step that was the episode's last. `task`: the names of what it evaluates.
  void TellEnd(const Eigen::VectorXd& observation, double reward, const EpisodeRecord& episode,
               const TaskRecord& task);
  // Replies to a request that has set a parameter; to a binary one nothing.
  void TellSet(const std::string& parameter, const ParameterValue& value);
  void TellError(const std::string& what);

  // From any thread: who waits here is told that the client is gone.
  void Interrupt() const { socket_.Interrupt(); }

 private:
  ClientRequest WaitForText();
  ClientRequest WaitForBinary();
  SetRequest ReadBinarySet();
  template <class Value>
  Value ReadBinary();
  void Send(const std::string& bytes);
  void SendBinary(uint8_t end, double reward, const Eigen::VectorXd& observation);

  LocalSocket socket_;
  bool is_binary_ = false;
  Eigen::VectorXd action_;
  std::vector<OfferedParam> params_;
  std::string bytes_;
};

}  // namespace runtime
