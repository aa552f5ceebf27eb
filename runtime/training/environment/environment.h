// What a run knows of the world that a task is learned in: a robot's, or any other.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plugins/robot/start_state.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/values.h"

namespace runtime {

// Something that is drawn for each episode.
struct DrawnValue {
  const char* name;
  const char* unit;
  const char* doc;
  double value;
};

// Runs episodes, their record, checkpoints, live changes and evaluations know environments by this
// class only: whatever module is one can be learned in. One of one's own derives from
// SteppedEnvironment (stepped_environment.h), which does most of it.
//
//   out ports  one for each sensor, with its name, type and unit (sensor_data.h). What they offer
//   is
//              the state after the last step, from start_of_episode on
//   signals    start_of_episode; in every time step start_of_time_step(length [s]), then for each
//              physics step start_of_physics_step(length) and end_of_physics_step(length), then
//              end_of_time_step(length); where there are no finer steps, the time step is the one
//              physics step.
//              end_of_episode where the environment itself ends the episode. After one that has
//              diverged it sends nothing until the next episode. After any other it goes on with
//              its events while it is asked to: a learner may end an episode with its action
//   in port    whatever it is acted on by; it is read after start_of_time_step
//
// The state of an episode follows from the run's seed, the episode's number (episode_seed.h) and
// the actions alone: then a run that is repeated or resumed is the same, bit for bit. What lasts
// longer than an episode belongs into Save() and Load().
//
// Errors: whatever makes the run impossible is a UserError, from any function; the run ends, and
// what it has saved stays. Nothing allocates or locks in a time step.
class Environment : public Module {
 public:
  static constexpr const char* kRole = "environment";  // for ModuleGraph::FindOnly()

  // How an episode of a robot is to start, if anything is said of it; after `attempt` other
  // answers.
  using StartDraw = std::function<std::optional<robot::StartState>(uint32_t attempt)>;

  explicit Environment(std::string name) : Module(std::move(name)) {}

  // Of all time steps [s]; known once the module has started.
  virtual double time_step() const = 0;
  // Since the start of the episode [s].
  virtual double time() const = 0;

  // The number in the run of the episode that starts next; else it is one more than the last.
  void SetNextEpisode(int64_t number) { episode_ = number - 1; }
  // Begins an episode: its first state, then the signal. What has no robot does not ask `draw`.
  void StartDrawnEpisode(const StartDraw& draw) {
    CountEpisode();
    BeginEpisode(draw);
  }
  // One time step; nothing if the episode has diverged, or none has been started.
  virtual void RunTimeStep() = 0;

  // What is recorded for replays: so many poses, of a robot one for each link; or nothing.
  virtual int pose_count() const { return 0; }
  // x, y, z, qw, qx, qy, qz of each frame in the world frame. Precondition: `out` has 7 elements
  // for each pose; an episode was started.
  virtual void CapturePose(std::span<float> /*out*/) const {}
  // The first of these that are links of a robot.
  virtual int link_count() const { return 0; }
  // Which links touch something, as the sensor `contact` says: bit i % 8 of element i / 8 for link
  // i. Precondition: an element for each 8 links that were begun; an episode was started.
  virtual void CaptureContacts(std::span<uint8_t> /*out*/) const {}

  // As long as it lives, whoever reads the sensors leaves no trace in the episode, not even in one
  // that diverges later. Not from inside a signal.
  class Peek {
   public:
    explicit Peek(Environment& environment) : environment_(environment) {
      environment_.StartPeek();
    }
    Peek(const Peek&) = delete;
    Peek& operator=(const Peek&) = delete;
    ~Peek() { environment_.EndPeek(); }

   private:
    Environment& environment_;
  };

  // What the present episode has drawn of its world, to be recorded with it.
  virtual std::vector<DrawnValue> drawn() const { return {}; }

  // How the same world is computed, where there is a choice: "fast-tree". "": there is none.
  virtual const std::string& profile() const {
    static const std::string kNone;
    return kNone;
  }

  // Why there cannot be two of it at a time, as a sentence; "": there can. Then episodes are run
  // side by side in copies of the agent (episodes_ahead.h).
  virtual std::string WhyOnlyOne() const { return ""; }

 protected:
  virtual void BeginEpisode(const StartDraw& draw) = 0;
  void CountEpisode() { ++episode_; }
  // The number in the run of the episode that runs or ran last.
  int64_t episode() const { return episode_; }

  Signal<> start_of_episode_{this, "start_of_episode"};
  Signal<double> start_of_time_step_{this, "start_of_time_step"};
  Signal<double> start_of_physics_step_{this, "start_of_physics_step"};
  Signal<double> end_of_physics_step_{this, "end_of_physics_step"};
  Signal<double> end_of_time_step_{this, "end_of_time_step"};
  Signal<EpisodeEnd> end_of_episode_{this, "end_of_episode"};

 private:
  // For what computes sensors when they are read.
  virtual void StartPeek() {}
  virtual void EndPeek() {}

  int64_t episode_ = 0;
};

}  // namespace runtime
