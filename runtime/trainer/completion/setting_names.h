#pragma once

#include <string>
#include <vector>

namespace runtime {

// What `--set` changes in the agent of a command line, which may not be finished:
// "learner.temperature=". Nothing where the line names no task. Throws UserError or CallError where
// the task cannot be built, or the agent does not fit.
std::vector<std::string> SettingNames(const std::vector<std::string>& line);

}  // namespace runtime
