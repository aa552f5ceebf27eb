#include "compiler/driver/robot_option.h"

#include <utility>

#include "compiler/analyze/find_robot.h"

namespace compiler {

robot::RobotDescription GetRobot(const std::string& name, const std::filesystem::path& file,
                                 const Session& session) {
  Diagnostics diagnostics;
  auto robot = FindRobot({name, {}}, file, session.robots, diagnostics);
  if (robot) return std::move(*robot);
  const Diagnostic& mistake = diagnostics.list().front();
  throw CallError(mistake.message + (mistake.help.empty() ? "" : "; " + mistake.help.text));
}

}  // namespace compiler
