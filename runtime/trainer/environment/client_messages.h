// The messages between `trainer environment` and who connects to it: docs/environments.md.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "runtime/base/local_socket.h"
#include "runtime/core/module/observations.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

struct ResetRequest {
  std::optional<uint64_t> seed;
};
struct StepRequest {};  // the action is in ClientMessages::action()
struct ForeignRequest {
  std::string what;
};
using ClientRequest = std::variant<ResetRequest, StepRequest, ForeignRequest>;

// What is wrong with a request ends no connection in the text format, and ends it in the binary
// one.
struct ClientIsGone {};

class ClientMessages {
 public:
  explicit ClientMessages(LocalSocket socket) : socket_(std::move(socket)) {}

  // All that wait for or send a message throw ClientIsGone.

  // `about`: a JSON object, to which the action and the observation are added.
  void Greet(const std::string& about, int action_size, const ObservationLayout& observation);
  ClientRequest Wait();
  const Eigen::VectorXd& action() const { return action_; }

  // Replies to a reset, and to a step after which the episode goes on.
  void TellStart(const Eigen::VectorXd& observation);
  void TellStep(const Eigen::VectorXd& observation, double reward, double time);
  // Replies to the step that was the episode's last. `task`: the names of what it evaluates.
  void TellEnd(const Eigen::VectorXd& observation, double reward, const EpisodeRecord& episode,
               const TaskRecord& task);
  void TellError(const std::string& what);

  // From any thread: who waits here is told that the client is gone.
  void Interrupt() const { socket_.Interrupt(); }

 private:
  ClientRequest WaitForText();
  ClientRequest WaitForBinary();
  void Send(const std::string& bytes);
  void SendBinary(int kind, double reward, const Eigen::VectorXd& observation);

  LocalSocket socket_;
  bool is_binary_ = false;
  Eigen::VectorXd action_;
  std::string bytes_;
};

}  // namespace runtime
