// The base of environments of one's own: a state, sensors that look at it, and a step that changes
// it. docs/environments.md leads through one.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "runtime/core/module/action_limits.h"
#include "runtime/core/module/context.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/training/environment/environment.h"

namespace runtime {

// A world that moves in equal time steps, and is acted on by a vector.
//
//   in   action: a vector of the size of the limits; unconnected: 0, or the limit nearest to it
//   out  time: `real [s]`, since the start of the episode
//        action_limits: of the actions
//        one port for each sensor that was added
class SteppedEnvironment : public Environment {
 public:
  double time_step() const final { return time_step_; }
  double time() const final { return time_; }
  void RunTimeStep() final;

 protected:
  // Without a time step and limits: Prepare() tells them.
  SteppedEnvironment(std::string name, const Context& context);
  SteppedEnvironment(std::string name, const Context& context, double time_step,
                     ActionLimits limits);

  // Offers a sensor with the type and unit that a task declares it with: "vec2", "m". `elements`:
  // where they lie, row by row; they are doubles, but bools for a "bool" and an array of bools,
  // long longs for an "int" and an array of those (throws UserError for others). The pointer stays
  // valid as long as this object; what it points to changes in Begin() and Step() only.
  void AddSensor(const std::string& name, const std::string& type, const std::string& unit,
                 const double* elements);
  void AddSensor(const std::string& name, const std::string& type, const std::string& unit,
                 const bool* elements);
  void AddSensor(const std::string& name, const std::string& type, const std::string& unit,
                 const long long* elements);

  // The first state of an episode. `seed` is all that it may depend on (Random(seed), random.h).
  virtual void Begin(uint64_t seed) = 0;
  // The state one time step later. `action` is within the limits, and every element a number.
  virtual void Step(const Eigen::VectorXd& action) = 0;

  // From Begin() or Step(): the world itself ends the episode, after this time step's reward. Most
  // do not: ends belong to the task. While a learner finishes its action, the state stays what it
  // is. `reason` lives as long as this object.
  void EndEpisode(EndKind kind, const char* reason);

  // For what is told only when it is needed: SetSteps(), before anybody asks. Called often.
  virtual void Prepare() {}
  // Throws UserError unless the limits are limits, and the time step is above 0.
  void SetSteps(double time_step, ActionLimits limits);

 private:
  struct Sensor {
    Sensor(Module* owner, const std::string& name, const std::string& type, const void* elements)
        : data{elements}, port(owner, name, &data, type) {}
    SensorData data;
    SensorOut port;
  };

  // `kind`: of the elements, "bool", "int" or "".
  void OfferSensor(const std::string& name, const std::string& type, const std::string& unit,
                   const std::string& kind, const void* elements);
  void Start() final;
  void BeginEpisode(const StartDraw& draw) final;
  void ReadAction();
  const ActionLimits& Limits();

  const uint64_t run_seed_;
  double time_step_ = 0;
  ActionLimits limits_;
  std::deque<Sensor> sensors_;
  In<Eigen::VectorXd> action_in_{this, "action", "", In<Eigen::VectorXd>::Need::kOptional};
  Out<ActionLimits> limits_out_{this, "action_limits", Bind<&SteppedEnvironment::Limits>{}};

  Eigen::VectorXd action_;
  int64_t steps_ = 0;  // done in this episode
  double time_ = 0;
  bool is_started_ = false;  // an episode
  bool is_over_ = false;     // for the world
  bool end_is_told_ = false;
  EpisodeEnd end_;
};

}  // namespace runtime
