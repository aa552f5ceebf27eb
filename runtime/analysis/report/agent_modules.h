// The agent of a run, as the page puts it into words.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace runtime {

// The table `modules` of an agent file: for each module its type and parameters. An agent that is
// no TOML has none: its text is shown all the same.
nlohmann::json AgentModules(const std::string& agent);

}  // namespace runtime
