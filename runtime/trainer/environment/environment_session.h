// One client of `trainer environment`: a robot in its task for whoever is at the other end of a
// connection.
#pragma once

#include <cstdint>

#include "runtime/trainer/environment/client_messages.h"
#include "runtime/trainer/environment/decision_process.h"
#include "runtime/trainer/setup/task_setup.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// What all clients share, which outlives them.
struct SharedEnvironment {
  const TaskSetup& setup;
  TaskRecord task;
  double discount = 1;  // of potentials
};

class EnvironmentSession {
 public:
  // Throws UserError.
  EnvironmentSession(const SharedEnvironment& shared, LocalSocket socket);

  // Serves the client until it is gone, in this thread. Throws UserError where the environment
  // cannot go on.
  void Run();
  // From any thread: as if the client was gone.
  void Interrupt() { messages_.Interrupt(); }

 private:
  void Greet();
  void Answer(const ResetRequest& request);
  void Answer(const StepRequest& request);
  void Answer(const SetRequest& request);
  void Answer(const ForeignRequest& request);

  const SharedEnvironment& shared_;
  ClientMessages messages_;
  DecisionProcess process_;
};

}  // namespace runtime
