// What a recorded episode was driven by: with it the simulation runs again, bit for bit, without
// the learner, and other tasks can say what they think of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plugins/robot/start_state.h"

namespace runtime {

struct Tape {
  std::string start_pose;  // of the environment; "": `start`, or else the robot's first pose
  std::optional<robot::StartState> start;  // that the task drew
  double discount = 1;                     // the learner's, at the episode's end
  bool ends_at_once = false;               // the learner's: episodes end in the middle of actions
  size_t joints = 0;
  std::vector<double> targets;  // [time step][joint], as the controller was told them [rad]
  // How many actions have started right after the episode's start, and then in each time step.
  std::vector<uint8_t> actions;

  size_t steps() const { return actions.empty() ? 0 : actions.size() - 1; }
  std::span<const double> TargetsOf(size_t step) const {
    return std::span(targets).subspan(step * joints, joints);
  }
  bool operator==(const Tape&) const = default;
};

// Compressed. Targets hardly change from step to step, and many joints follow the same coordinate:
// what is compressed are the differences of each joint's bits, joint by joint and byte by byte.
std::string Pack(const Tape& tape);

// Throws UserError where it is damaged.
Tape Unpack(std::string_view packed);

// Of an episode of the run in `folder`; "" where there is none. Throws UserError.
std::string ReadTape(const std::filesystem::path& folder, int64_t episode);

}  // namespace runtime
