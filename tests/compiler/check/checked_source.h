// Tasks as text, parsed and checked: what the tests of the checker start from.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "compiler/check/check.h"
#include "compiler/compose/compose.h"
#include "plugins/robot/robot_description.h"

namespace compiler {

inline const robot::RobotDescription& Humanoid() {
  static const robot::RobotDescription robot =
      robot::ReadRobot(SOURCE_DIR "/plugins/humanoid/robot.toml");
  return robot;
}

// A task that was parsed and checked, for the humanoid or for no robot. What it imports and extends
// is on the disk, and its tables and worlds are in tests/compiler/check/tables.
struct CheckedSource {
  static inline const std::filesystem::path kTables = SOURCE_DIR "/tests/compiler/check/tables";

  CheckedSource(const std::string& path, const std::string& text) {
    const FileReader read = [&](const std::filesystem::path& file) {
      if (file == path) return std::optional(text);
      const bool is_kept = file.extension() == ".csv" || file.extension() == ".toml";
      return ReadFromDisk(is_kept ? kTables / file : file);
    };
    const auto tree = Compose(path, read, sources, diagnostics);
    if (!tree) return;
    is_parsed = true;
    task = Check(*tree, tree->robot ? &Humanoid() : nullptr, diagnostics);
  }
  explicit CheckedSource(const std::string& text) : CheckedSource("a.task", text) {}

  std::string Messages() const { return Render(sources, diagnostics, false); }

  Sources sources;
  Diagnostics diagnostics;
  bool is_parsed = false;
  std::optional<CheckedTask> task;
};

// A task that must be free of errors.
inline CheckedTask CheckTask(const std::string& text) {
  CheckedSource checked(text);
  EXPECT_TRUE(checked.task) << checked.Messages();
  return checked.task ? std::move(*checked.task) : CheckedTask{};
}

// A task for the humanoid that consists of some declarations and the block of `end_of_time_step`.
inline std::string TaskText(const std::string& declarations, const std::string& block) {
  return "task tested for humanoid\n" + declarations + "\non end_of_time_step {\n" + block +
         "\n}\n";
}

// What the checker makes of an expression inside an event.
inline CheckedExpression CheckText(const std::string& expression,
                                   const std::string& declarations = "") {
  CheckedTask task = CheckTask(TaskText(declarations, "let tested = " + expression));
  CheckedBlock& body = task.events[static_cast<size_t>(EventKind::kEndOfTimeStep)].body;
  if (body.empty()) return {};
  return std::move(std::get<CheckedLet>(body.back().node).value);
}

// "vec3 [m/s]"
inline std::string TypeOf(const std::string& expression, const std::string& declarations = "") {
  const CheckedExpression checked = CheckText(expression, declarations);
  const std::string unit = ToString(checked.unit);
  return ToString(checked.type) + (unit.empty() ? "" : " [" + unit + "]");
}

}  // namespace compiler
