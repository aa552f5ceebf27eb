#include "runtime/trainer/setup/start_check.h"

#include "base/text/print.h"
#include "runtime/analysis/robot/robot_report.h"
#include "runtime/training/simulation/robot_environment.h"

namespace runtime {
namespace {

std::vector<const robot::Pose*> StartPosesOf(const TaskSetup& setup,
                                             const RobotEnvironment& environment) {
  if (!environment.start_pose().empty()) return {setup.robot.FindPose(environment.start_pose())};
  const taskc_plugin& task = setup.plugin->table();
  if (task.pose_count == 0) return {&setup.robot.poses.front()};
  std::vector<const robot::Pose*> poses;
  for (uint32_t i = 0; i < task.pose_count; ++i)
    poses.push_back(setup.robot.FindPose(task.poses[i].name));
  return poses;
}

}  // namespace

void WarnOfStart(const TaskSetup& setup) {
  for (const RobotEnvironment* environment : setup.graph.FindAll<RobotEnvironment>()) {
    const Profile& profile = FindProfile(environment->profile());
    for (const robot::Pose* pose : StartPosesOf(setup, *environment)) {
      for (const RobotProblem& problem :
           ProblemsOf(setup.robot, HoldPose(setup.robot, profile, *pose)))
        text::Print(stderr, "{}", ToText(problem));
    }
  }
}

}  // namespace runtime
