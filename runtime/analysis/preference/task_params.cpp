#include "runtime/analysis/preference/task_params.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "runtime/base/build_task.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/recorded_sources.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double NumberOf(const json& value, double otherwise) {
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  return value.is_number() ? value.get<double>() : otherwise;
}

TaskParam ParseParam(const json& param) {
  return {.name = param.at("name"),
          .unit = param.at("unit"),
          .initial = NumberOf(param.at("default"), 0),
          .least = NumberOf(param.at("least"), -kInfinity),
          .greatest = NumberOf(param.at("greatest"), kInfinity),
          .scales = param.at("scales"),
          .changes_course = param.at("changes_course")};
}

}  // namespace

TaskParams ParseTaskParams(const std::string& text) {
  try {
    const json task = json::parse(text);
    TaskParams params{task.at("hash"), {}};
    for (const json& param : task.at("params")) params.params.push_back(ParseParam(param));
    return params;
  } catch (const json::exception& error) {
    throw UserError(
        fmt::format("what `taskc doc --json` prints cannot be understood ({}); install taskc and "
                    "trainer of the "
                    "same version",
                    error.what()));
  }
}

TaskParams ReadTaskParams(const std::filesystem::path& task_file) {
  std::string json;
  if (!RunCompiler({"doc", task_file.string(), "--json"}, json)) {
    throw UserError(fmt::format("taskc cannot list the params of {}", task_file.string()));
  }
  return ParseTaskParams(json);
}

TaskParams ReadTaskParams(const TaskRecord& task) {
  if (task.sources.empty()) {
    throw UserError(
        fmt::format("the run does not have the text of its task {}", VersionText(task)));
  }
  const ScratchFolder scratch;
  TaskParams params = ReadTaskParams(WriteSources(task.sources, scratch.path()).task);
  if (params.task_hash != task.task_hash) {
    throw UserError(
        fmt::format("the text of {} in the run's record is from another version, {:.8}; the "
                    "record is damaged",
                    VersionText(task), params.task_hash));
  }
  return params;
}

}  // namespace runtime
