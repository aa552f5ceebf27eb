// What clients get to see of a run.
#pragma once

#include <nlohmann/json.hpp>

#include "runtime/live/control/live_graph.h"
#include "runtime/live/control/schedules.h"
#include "runtime/training/run/run_records.h"

namespace runtime {

// {"tasks": [...], "modules": [...], "schedules": [...]}
nlohmann::json ListJson(const LiveGraph& graph, const Schedules& schedules, const RunRecord& run);

// "active" or "shadow"
const char* RoleName(const UniversalTask& task);

// {"module", "task", "hash"}
nlohmann::json TaskJson(const std::string& module, const TaskRecord& task);

// Of "task.weight" its value with what belongs to it; of "task" all parameters. Throws UserError
// for an unknown name.
nlohmann::json ParametersJson(const LiveGraph& graph, const std::string& name);

// {"text"}: the graph as `text`, `json` or `dot`. Throws UserError for another format.
nlohmann::json GraphReply(const LiveGraph& graph, const std::string& format);

}  // namespace runtime
