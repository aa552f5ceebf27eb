#include "runtime/analysis/preference/recorded_params.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include "runtime/base/user_error.h"

namespace runtime {

std::map<std::string, RecordedParam> RecordedParams(const RunRecord& run) {
  using Kind = RecordedParam::Kind;
  const TaskRecord& task = run.tasks.front();
  toml::table agent;
  try {
    agent = toml::parse(run.agent);
  } catch (const toml::parse_error&) {
    // Then it has no modules, either.
  }
  const toml::table* const module = agent["modules"][task.module].as_table();
  if (module == nullptr) {
    throw UserError(
        fmt::format("the run's agent has no module `{}`, so that the params of {} are "
                    "not known",
                    task.module, VersionText(task)));
  }
  std::map<std::string, RecordedParam> params;
  for (const auto& [name, value] : *module) {
    if (const auto* condition = value.as_boolean()) {
      params[std::string(name)] = {condition->get() ? 1. : 0., Kind::kCondition};
    } else if (const auto* whole = value.as_integer()) {
      params[std::string(name)] = {static_cast<double>(whole->get()), Kind::kWhole};
    } else if (const auto* real = value.as_floating_point()) {
      params[std::string(name)] = {real->get(), Kind::kReal};
    }
  }
  return params;
}

}  // namespace runtime
