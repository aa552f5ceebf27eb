// Where the plugins of these tests are, and the robot that they are for.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "plugins/robot/robot_description.h"
#include "runtime/base/user_error.h"
#include "runtime/core/task/plugin.h"

namespace runtime {

inline std::filesystem::path PluginFile(const std::string& name) {
  return std::filesystem::path(PLUGIN_FOLDER) / (name + ".so");
}

inline std::shared_ptr<const Plugin> LoadTask(const std::string& name) {
  return std::make_shared<Plugin>(PluginFile(name));
}

// Three links, two joints and a site.
inline robot::RobotDescription Walker() {
  robot::RobotDescription walker;
  walker.name = "walker";
  walker.links.resize(3);
  walker.joints.resize(2);
  walker.sites.resize(1);
  return walker;
}

// What the action complains about, without the folder of the plugins.
template <class Action>
std::string MessageOf(Action action) {
  try {
    action();
  } catch (const UserError& error) {
    std::string message = error.what();
    const std::string folder = std::string(PLUGIN_FOLDER) + "/";
    if (message.starts_with(folder)) message.erase(0, folder.size());
    return message;
  }
  return "no error";
}

}  // namespace runtime
