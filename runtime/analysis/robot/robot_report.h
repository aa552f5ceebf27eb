// A robot and how its poses hold, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "plugins/robot/robot_description.h"
#include "runtime/analysis/robot/body_properties.h"
#include "runtime/analysis/robot/held_pose.h"
#include "runtime/analysis/robot/robot_problems.h"

namespace runtime {

struct RobotReport {
  RobotReport(const robot::RobotDescription& described, const Profile& profile);

  // Whether there is something that no run should be started with: a simulation that diverges.
  bool HasFailed() const;

  const robot::RobotDescription& robot;  // outlives the report
  BodyProperties body;
  std::vector<HeldPose> poses;  // all, in their order
  std::vector<RobotProblem> problems;
};

std::string ToText(const RobotReport& report);
nlohmann::ordered_json ToJson(const RobotReport& report);

// "warning: TEXT\n  help: HELP\n"
std::string ToText(const RobotProblem& problem);

}  // namespace runtime
