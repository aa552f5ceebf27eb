// Importing robots from texts.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <string>

#include "plugins/robot/robot_description.h"
#include "runtime/base/user_error.h"
#include "runtime/import/import_robot.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {

class ImportRobotTest : public testing::Test {
 protected:
  ImportedRobot Import(const std::string& text, const std::string& name = "model.urdf",
                       std::optional<bool> fixed = std::nullopt) {
    std::ofstream(folder_.path() / name) << text;
    return ImportRobot({.file = folder_.path() / name,
                        .name = "robot" + std::to_string(++count_),
                        .folder = folder_.path() / "robots",
                        .fixed_base = fixed});
  }
  robot::RobotDescription Read(const std::string& text, const std::string& name = "model.urdf") {
    return robot::ReadRobot(Import(text, name).file);
  }
  std::string ErrorOf(const std::string& text, const std::string& name = "model.urdf") {
    try {
      Import(text, name);
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  int count_ = 0;
};

// A URDF link of 1 kg with this shape.
inline std::string Link(const std::string& name, const std::string& shape, double mass = 1) {
  return "<link name=\"" + name + "\"><inertial><mass value=\"" + std::to_string(mass) +
         "\"/><inertia ixx=\"0.01\" iyy=\"0.012\" izz=\"0.014\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>"
         "</inertial><collision><geometry>" +
         shape + "</geometry></collision></link>\n";
}

inline const std::string kBox = "<box size=\"0.2 0.3 0.1\"/>";

inline std::string TwoLinks(const std::string& joint) {
  return "<robot name=\"two\">\n" + Link("body", kBox) +
         Link("leg", "<cylinder radius=\"0.03\" length=\"0.2\"/>", 0.5) + "<joint name=\"hip\" " +
         joint +
         "<parent link=\"body\"/><child link=\"leg\"/><origin xyz=\"0.05 0 -0.15\"/></joint>\n"
         "</robot>\n";
}

}  // namespace runtime
