#include "runtime/live/client/known_names.h"

#include <nlohmann/json.hpp>

#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"

namespace runtime {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

json ValueOf(const std::filesystem::path& run, const Request& request) {
  const Reply reply = Ask(run, request);
  if (!reply.ok) throw UserError(reply.error);
  return reply.value;
}

// The task modules, or their goals.
Names NamesOfTasks(const std::filesystem::path& run, NamedPart part) {
  const json list = ValueOf(run, {"list", json::object()});
  Names names;
  for (const json& task : list["tasks"]) {
    if (part == NamedPart::kTaskModule) names.push_back(task["module"]);
    if (part != NamedPart::kGoal) continue;
    for (const json& goal : task["goals"]) names.push_back(goal["name"]);
  }
  return names;
}

Names NamesInGraph(const json& graph, NamedPart part) {
  const bool has_both = part == NamedPart::kModuleOrParameter;
  Names names;
  for (const json& module : graph["modules"]) {
    const auto name = module["name"].get<std::string>();
    if (part == NamedPart::kModule || has_both) names.push_back(name);
    if (part == NamedPart::kParameter || has_both) {
      for (const auto& [parameter, value] : module["parameters"].items())
        names.push_back(name + "." + parameter);
    }
    if (part != NamedPart::kPort) continue;
    for (const json& port : module["ports"])
      names.push_back(name + "." + port["name"].get<std::string>());
  }
  return names;
}

}  // namespace

Names KnownNames(const std::filesystem::path& run, NamedPart part) {
  if (part == NamedPart::kTaskModule || part == NamedPart::kGoal) return NamesOfTasks(run, part);
  const json graph = ValueOf(run, {"graph", {{"format", "json"}}});
  return NamesInGraph(json::parse(graph["text"].get<std::string>()), part);
}

}  // namespace runtime
