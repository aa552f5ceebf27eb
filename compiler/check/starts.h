// How the first state of an episode is drawn: `start standing or lying { joint.angle += ... }`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/check/log_table.h"
#include "compiler/check/task_scope.h"
#include "compiler/syntax/syntax_tree.h"
#include "plugins/robot/robot_description.h"

namespace compiler {

// What the block of a start can read and set.
struct StartValueDescription {
  std::string_view name;  // those of sensors have the sensor's type
  StartValue value;
  std::string_view doc;
};
inline constexpr StartValueDescription kStartValues[] = {
    {"joint.angle", StartValue::kJointAngle, "The joints' angles, at first those of the pose."},
    {"joint.velocity", StartValue::kJointVelocity, "How fast the joints turn, at first 0."},
    {"base.position", StartValue::kBasePosition,
     "Where the base is, at first where the pose has it; `z` is above what touches the ground."},
    {"base.roll", StartValue::kBaseRoll,
     "By how much the pose is turned about the world's x axis, at first 0."},
    {"base.pitch", StartValue::kBasePitch,
     "By how much the pose is turned about the world's y axis, after the roll; at first 0."},
    {"base.yaw", StartValue::kBaseYaw,
     "By how much the pose is turned about the world's z axis, after the pitch; at first 0."},
    {"base.velocity", StartValue::kBaseVelocity, "The base's velocity in the world, at first 0."},
    {"base.angular_velocity", StartValue::kBaseAngularVelocity,
     "How fast the whole robot turns, in the world; at first 0."},
};

// Those of a task, with the memory that they live in while a start is drawn.
class StartTable {
 public:
  // Refers to both, which must outlive this.
  StartTable(const SensorCatalog& sensors, const robot::RobotDescription& robot, CheckedTask& task)
      : sensors_(sensors), robot_(robot), task_(task) {}

  // The longest value that `path` begins with, as the memory that holds it, and how many names it
  // has; nothing: it begins with none.
  struct Found {
    uint32_t memory = 0;
    size_t length = 0;
  };
  std::optional<Found> Find(const std::vector<Identifier>& path) const;
  CheckedExpression Read(const Found& found, Span span) const;

 private:
  uint32_t MemoryOf(const StartValueDescription& description, Span span) const;
  // Over the poses in which an episode may begin; one for each element.
  void SetRange(CheckedStartValue& added, uint32_t size) const;

  const SensorCatalog& sensors_;
  const robot::RobotDescription& robot_;
  CheckedTask& task_;
};

// Checks the poses, and the block where there is one. Precondition: all that is declared is known.
void CheckStart(const SyntaxTree& tree, const robot::RobotDescription* robot, LogTable& logs,
                TaskScope& scope, CheckedTask& task);

// "`joint.angle`, ... and `base.angular_velocity`"
std::string ListOfStartValues();

// "base.yaw": is it something that a start sets?
bool IsStartValue(std::string_view name);

}  // namespace compiler
