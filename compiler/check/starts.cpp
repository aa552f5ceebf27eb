#include "compiler/check/starts.h"

#include <algorithm>
#include <limits>

#include "compiler/check/hidden_memory.h"
#include "compiler/check/report.h"
#include "compiler/check/statements.h"
#include "compiler/check/stream.h"
#include "compiler/check/type.h"

namespace compiler {
namespace {

constexpr Unit kRadians{.radian = 1};

const StartDeclaration* FindStart(const SyntaxTree& tree) {
  const StartDeclaration* found = nullptr;
  for (const Declaration& declaration : tree.declarations)
    if (const auto* start = std::get_if<StartDeclaration>(&declaration.node)) found = start;
  return found;
}

bool CheckPose(const Identifier& pose, const robot::RobotDescription& robot,
               const TaskScope& scope) {
  if (robot.FindPose(pose.text) != nullptr) return true;
  std::vector<std::string> poses;
  for (const robot::Pose& each : robot.poses) poses.push_back(each.name);
  Report(scope.diagnostics, code::kUnknownPose, pose.span,
         fmt::format("the {} has no pose `{}`", robot.name, pose.text),
         {.help = Suggest(pose.span, pose.text, poses, "poses")});
  return false;
}

void NoteStops(const robot::RobotDescription& robot, CheckedStart& start) {
  for (const robot::Joint& joint : robot.joints) {
    start.joints.push_back(joint.name);
    start.low.push_back(joint.low);
    start.high.push_back(joint.high);
  }
}

// Of the pose, row by row.
double ElementIn(const robot::Pose& pose, StartValue value, uint32_t element) {
  switch (value) {
    case StartValue::kJointAngle:
      return pose.joint_angles[element];
    case StartValue::kBasePosition:
      return pose.position[element];
    case StartValue::kJointVelocity:
    case StartValue::kBaseRoll:
    case StartValue::kBasePitch:
    case StartValue::kBaseYaw:
    case StartValue::kBaseVelocity:
    case StartValue::kBaseAngularVelocity:
      break;
  }
  return 0;
}

std::string Joined(const std::vector<Identifier>& path, size_t length) {
  std::string text = path[0].text;
  for (size_t i = 1; i < length; ++i) text += '.' + path[i].text;
  return text;
}

}  // namespace

std::optional<StartTable::Found> StartTable::Find(const std::vector<Identifier>& path) const {
  for (size_t length = path.size(); length > 0; --length) {
    const std::string name = Joined(path, length);
    const auto* found = std::ranges::find(kStartValues, name, &StartValueDescription::name);
    if (found == std::end(kStartValues)) continue;
    return Found{MemoryOf(*found, Cover(path[0].span, path[length - 1].span)), length};
  }
  return std::nullopt;
}

CheckedExpression StartTable::Read(const Found& found, Span span) const {
  const CheckedMemory& memory = task_.memory[found.memory];
  return {span, memory.type, memory.unit, MemoryRead{found.memory}};
}

uint32_t StartTable::MemoryOf(const StartValueDescription& description, Span span) const {
  std::vector<CheckedStartValue>& values = task_.start.values;
  const auto known = std::ranges::find(values, description.value, &CheckedStartValue::value);
  if (known != values.end()) return known->memory;
  Type type = kRealType;
  Unit unit = kRadians;
  if (const auto sensor = sensors_.Find(std::string(description.name))) {
    type = sensors_.list()[*sensor].type;
    unit = sensors_.list()[*sensor].unit;
  }
  // No reset takes away what the host has put there.
  const uint32_t memory = AddHiddenMemory("start#" + std::string(description.name), type, unit,
                                          MemoryScope::kPerRun, span, task_);
  CheckedStartValue added{
      .value = description.value, .name = std::string(description.name), .memory = memory};
  SetRange(added, type.size());
  values.push_back(added);
  return added.memory;
}

void StartTable::SetRange(CheckedStartValue& added, uint32_t size) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  added.minimum.assign(size, kInfinity);
  added.maximum.assign(size, -kInfinity);
  for (const std::string& name : task_.start.poses) {
    const robot::Pose& pose = *robot_.FindPose(name);
    for (uint32_t i = 0; i < size; ++i) {
      const double element = ElementIn(pose, added.value, i);
      added.minimum[i] = std::min(added.minimum[i], element);
      added.maximum[i] = std::max(added.maximum[i], element);
    }
  }
}

void CheckStart(const SyntaxTree& tree, const robot::RobotDescription* robot, LogTable& logs,
                TaskScope& scope, CheckedTask& task) {
  const StartDeclaration* declared = FindStart(tree);
  if (declared == nullptr || !scope.knows_robot) return;
  const Identifier& first = declared->poses.front();
  if (robot == nullptr) {
    Report(scope.diagnostics, code::kPoseWithoutRobot, first.span,
           fmt::format("there is no pose `{}` without a robot", first.text),
           {.help = "write `for ROBOT` after the task's name, or leave out `start`"});
    return;
  }
  bool are_known = true;
  for (const Identifier& pose : declared->poses) {
    are_known = CheckPose(pose, *robot, scope) && are_known;
    task.start.poses.push_back(pose.text);
  }
  task.start.stream = StreamOf("start#");
  task.start.span = Cover(first.span, declared->poses.back().span);
  if (!declared->block || !are_known) return;
  NoteStops(*robot, task.start);
  const StartTable table(scope.sensors, *robot, task);
  CheckStartBlock(*declared->block, table, logs, scope, task);
}

std::string ListOfStartValues() {
  std::vector<std::string> names;
  for (const StartValueDescription& each : kStartValues) names.emplace_back(each.name);
  return List(names);
}

bool IsStartValue(std::string_view name) {
  return std::ranges::find(kStartValues, name, &StartValueDescription::name) !=
         std::end(kStartValues);
}

}  // namespace compiler
