#include "runtime/training/run/fault_explanation.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "plugins/host/scalar_bytes.h"
#include "runtime/base/build_task.h"
#include "runtime/base/child_process.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/recorded_sources.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

using FaultJson = nlohmann::ordered_json;

FaultJson NumberJson(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  return number;
}

FaultJson ElementsJson(std::span<const std::byte> bytes, taskc_int32 scalar) {
  FaultJson elements = FaultJson::array();
  const size_t size = host::ScalarSize(scalar);
  for (size_t at = 0; at + size <= bytes.size(); at += size) {
    elements.push_back(NumberJson(host::LoadScalar(bytes.data() + at, scalar)));
  }
  return elements;
}

// One place in the task's texts.
std::string PlaceText(const FaultJson& part, const TaskRecord& task) {
  const auto source = part.at("source").get<size_t>();
  return fmt::format("{}:{}:{}", task.sources.at(source).file, part.at("line").get<int>(),
                     part.at("column").get<int>());
}

std::string Read(const FaultJson& fault, const TaskRecord& task) {
  std::string text = fmt::format("`{}` ({}) is {}", fault.at("text").get<std::string>(),
                                 PlaceText(fault, task), fault.at("value").get<std::string>());
  const char* between = ", where ";
  for (const FaultJson& operand : fault.at("operands")) {
    text += fmt::format("{}`{}` is {}", between, operand.at("text").get<std::string>(),
                        operand.at("value").get<std::string>());
    between = " and ";
  }
  return text;
}

}  // namespace

std::string FaultText(const taskc_plugin& plugin, const FaultState& state) {
  FaultJson json = {{"event", state.event()},
                    {"term", state.term()},
                    {"time_step", state.time_step()},
                    {"seed", state.seed()},
                    {"discount", NumberJson(state.discount())},
                    {"outcome", state.outcome()},
                    {"params", FaultJson::array()},
                    {"sensors", FaultJson::array()},
                    {"memory", FaultJson::array()}};
  for (const double param : state.params()) json["params"].push_back(NumberJson(param));
  for (size_t i = 0; i < plugin.sensor_count; ++i) {
    json["sensors"].push_back(ElementsJson(state.sensor(i), plugin.sensors[i].scalar));
  }
  for (size_t i = 0; i < plugin.memory_count; ++i) {
    const taskc_memory& variable = plugin.memory[i];
    json["memory"].push_back(ElementsJson(state.memory(variable), variable.scalar));
  }
  return json.dump();
}

std::string ExplainFault(const RunRecord& run, int64_t task, const taskc_plugin& plugin,
                         const FaultState& state) {
  const TaskRecord& record = TaskWithId(run, task);
  if (record.sources.empty()) return "";
  try {
    const ScratchFolder scratch;
    const std::filesystem::path robots = WriteRobot(run, scratch.path() / "robots");
    const RecordedSources sources = WriteSources(record.sources, scratch.path() / "sources");
    const std::filesystem::path file = scratch.path() / "fault.json";
    WriteFile(file, FaultText(plugin, state));
    const ChildResult result = RunChild({CompilerProgram().string(), "fault", sources.task.string(),
                                         file.string(), "--robots", robots.string(), "--json"},
                                        Captured::kOutputOnly);
    if (result.error || !result.is_success) return "";
    return Read(FaultJson::parse(result.captured).at("tasks").at(0).at("fault"), record);
  } catch (const UserError&) {  // no folder, no process: then it is not explained
    return "";
  } catch (const FaultJson::exception&) {  // of a compiler of another version
    return "";
  }
}

}  // namespace runtime
