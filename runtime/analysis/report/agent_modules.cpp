#include "runtime/analysis/report/agent_modules.h"

#include <toml++/toml.h>

#include <sstream>

namespace runtime {

nlohmann::json AgentModules(const std::string& agent) {
  toml::table table;
  try {
    table = toml::parse(agent);
  } catch (const toml::parse_error&) {
    return nlohmann::json::object();
  }
  const toml::table* modules = table["modules"].as_table();
  if (modules == nullptr) return nlohmann::json::object();
  std::ostringstream text;
  text << toml::json_formatter(*modules);
  return nlohmann::json::parse(text.str());
}

}  // namespace runtime
