// An environment that is another program, in whatever language: docs/environments.md.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/core/task/plugin.h"
#include "runtime/training/environment/environment_link.h"
#include "runtime/training/environment/stepped_environment.h"

namespace runtime {

// Parameter: `path` of the socket at which the program listens.
//
// Out ports: one for each sensor of the task that the run begins with, which the program has to
// have. Time steps, limits of actions and the order of the sensors are what it says itself.
//
// Whatever becomes of the program is a UserError: the run ends there, and what it has saved stays.
class SocketEnvironment : public SteppedEnvironment {
 public:
  static constexpr const char* kType = "SocketEnvironment";  // in agent files

  SocketEnvironment(std::string name, const Context& context);
  ~SocketEnvironment() override;

  // The program may have but one state.
  std::string WhyOnlyOne() const override;

 private:
  // What a task reads of a sensor, and where it is in a reply.
  struct SocketSensor {
    const taskc_sensor& sensor;
    std::vector<double> elements;  // enough room for elements of any kind
    size_t first = 0;
  };

  void Prepare() override;
  void Begin(uint64_t seed) override;
  void Step(const Eigen::VectorXd& action) override;

  void FindSensors();
  void Take(const EnvironmentReply& reply);

  std::string path_;
  std::shared_ptr<const Plugin> task_;  // whose table the sensors are of
  std::deque<SocketSensor> sensors_;
  std::unique_ptr<EnvironmentLink> link_;
  std::string reason_;
};

}  // namespace runtime
