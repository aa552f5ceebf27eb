#include "plugins/host/plugin_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "plugins/host/plugin_error.h"
#include "plugins/host/task_frame.h"

namespace host {
namespace {

// Far beyond any task, and small enough that no product of two of them overflows.
constexpr uint32_t kLargestCount = 1u << 16;
constexpr uint32_t kLargestMemory = 1u << 28;  // bytes

// A whole number that a double holds exactly.
bool IsWhole(double value) { return value == std::trunc(value) && std::abs(value) <= 0x1p53; }

class TableCheck {
 public:
  TableCheck(const std::filesystem::path& file, const taskc_plugin& table)
      : file_(file), table_(table) {}

  void Run() const {
    CheckVersion();
    for (const char* text :
         {table_.compiler, table_.name, table_.doc, table_.robot, table_.source_hash}) {
      Require(text != nullptr, "one of its strings is null");
    }
    CheckNames(Entries(table_.links, table_.link_count, "links"), "link");
    CheckNames(Entries(table_.joints, table_.joint_count, "joints"), "joint");
    CheckNames(Entries(table_.sites, table_.site_count, "sites"), "site");
    CheckSources();
    CheckStart();
    CheckSensors();
    CheckParams();
    CheckMemory();
    CheckGoals();
    CheckObservations();
    CheckPhases();
    CheckRewardsAndEnds();
    CheckMetrics();
    CheckLogs();
    CheckRequirements();
  }

 private:
  void Require(bool condition, const std::string& otherwise) const {
    if (condition) return;
    throw PluginError(PluginDefect::kDamaged,
                      fmt::format("{}: its table is damaged: {}; build it again with `taskc build`",
                                  file_.string(), otherwise));
  }

  void CheckVersion() const {
    if (table_.abi_version != TASKC_ABI_VERSION) {
      throw PluginError(
          PluginDefect::kOtherAbi,
          fmt::format("{}: built for ABI {}, but this program needs {}: build it again with `taskc "
                      "build`",
                      file_.string(), table_.abi_version, TASKC_ABI_VERSION));
    }
    Require(table_.struct_size == sizeof(taskc_plugin),
            fmt::format("it has {} bytes, and ABI {} has {}", table_.struct_size, TASKC_ABI_VERSION,
                        sizeof(taskc_plugin)));
  }

  template <class Entry>
  std::span<const Entry> Entries(const Entry* entries, uint32_t count,
                                 std::string_view what) const {
    Require(count <= kLargestCount, fmt::format("it claims {} {}", count, what));
    Require(count == 0 || entries != nullptr, fmt::format("it has {} {}, at null", count, what));
    return {entries, count};
  }

  template <class Entry>
  void CheckNames(std::span<const Entry> entries, std::string_view what) const {
    std::set<std::string_view> names;
    for (const Entry& entry : entries) {
      Require(entry.name != nullptr && *entry.name != '\0', fmt::format("a {} has no name", what));
      Require(names.insert(entry.name).second,
              fmt::format("there are two {}s `{}`", what, entry.name));
    }
  }

  void CheckShape(std::string_view name, int32_t scalar, uint32_t rows, uint32_t columns) const {
    Require(ScalarSize(scalar) != 0, fmt::format("`{}` has an unknown scalar type", name));
    Require(rows > 0 && columns > 0 && rows <= kLargestCount && columns <= kLargestCount,
            fmt::format("`{}` has {} x {} elements", name, rows, columns));
  }

  void CheckPlace(std::string_view what, const taskc_place& place) const {
    Require(place.source < table_.source_count, fmt::format("the {} is in source {} of {}", what,
                                                            place.source + 1, table_.source_count));
  }

  void CheckReduction(std::string_view what, const char* name, int32_t reduction) const {
    Require(reduction >= TASKC_LAST && reduction <= TASKC_MEAN,
            fmt::format("the {} `{}` has an unknown reduction", what, name));
  }

  void CheckSources() const {
    const auto sources = Entries(table_.sources, table_.source_count, "sources");
    Require(!sources.empty(), "it has no source");
    for (const taskc_source& source : sources) {
      Require(source.file != nullptr && source.text != nullptr, "a source has no name or text");
    }
  }

  void CheckStart() const {
    const auto poses = Entries(table_.poses, table_.pose_count, "poses");
    for (const taskc_pose& pose : poses) {
      Require(pose.name != nullptr && *pose.name != '\0', "a pose has no name");
    }
    Require(poses.size() < 2 || table_.draw_pose != nullptr, "nothing draws its poses");
    const auto values = Entries(table_.start_values, table_.start_value_count, "start values");
    CheckNames(values, "start value");
    for (const taskc_start_value& value : values) {
      constexpr std::string_view kNames[] = {
          "joint.angle", "joint.velocity", "base.position", "base.roll",
          "base.pitch",  "base.yaw",       "base.velocity", "base.angular_velocity"};
      Require(std::ranges::find(kNames, value.name) != std::end(kNames),
              fmt::format("no start has a `{}`", value.name));
      CheckShape(value.name, TASKC_REAL, value.rows, 1);
      Require(LiesInside(value.offset, uint64_t{value.rows} * sizeof(double), alignof(double)),
              fmt::format("the start value `{}` is not in its memory", value.name));
    }
  }

  void CheckSensors() const {
    const auto sensors = Entries(table_.sensors, table_.sensor_count, "sensors");
    CheckNames(sensors, "sensor");
    for (const taskc_sensor& sensor : sensors) {
      Require(sensor.doc != nullptr && sensor.type != nullptr && sensor.unit != nullptr,
              fmt::format("the sensor `{}` has no text, type or unit", sensor.name));
      CheckShape(sensor.name, sensor.scalar, sensor.rows, sensor.columns);
      Require(sensor.read_by >> TASKC_READER_COUNT == 0,
              fmt::format("the sensor `{}` is read by unknown events", sensor.name));
    }
  }

  void CheckParams() const {
    const auto params = Entries(table_.params, table_.param_count, "params");
    CheckNames(params, "param");
    for (const taskc_param& param : params) {
      Require(param.doc != nullptr && param.unit != nullptr,
              fmt::format("the param `{}` has no text or unit", param.name));
      CheckShape(param.name, param.scalar, 1, 1);
      Require(std::isfinite(param.initial) && param.minimum <= param.initial &&
                  param.initial <= param.maximum,
              fmt::format("the param `{}` is {}, not within {} .. {}", param.name, param.initial,
                          param.minimum, param.maximum));
      Require(param.scalar == TASKC_REAL || IsWhole(param.initial),
              fmt::format("the param `{}` is {}, not an integer", param.name, param.initial));
    }
  }

  void CheckMemory() const {
    Require(table_.memory_size <= kLargestMemory,
            fmt::format("it needs {} bytes of memory", table_.memory_size));
    Require(table_.memory_size == 0 || table_.initialize != nullptr,
            "nothing initializes its memory");
    const auto memory = Entries(table_.memory, table_.memory_count, "variables");
    CheckNames(memory, "variable");
    for (const taskc_memory& variable : memory) {
      Require(variable.type != nullptr && variable.unit != nullptr,
              fmt::format("the variable `{}` has no type or unit", variable.name));
      CheckShape(variable.name, variable.scalar, variable.rows, variable.columns);
      Require(variable.scope >= TASKC_PER_RUN && variable.scope <= TASKC_PER_ACTION,
              fmt::format("the variable `{}` has an unknown scope", variable.name));
      Require(LiesInside(variable.offset, SizeInBytes(variable), ScalarSize(variable.scalar)),
              fmt::format("the variable `{}` lies outside the memory", variable.name));
    }
  }

  bool LiesInside(uint64_t offset, uint64_t size, size_t alignment) const {
    return offset + size <= table_.memory_size && offset % alignment == 0;
  }

  void CheckGoals() const {
    const auto goals = Entries(table_.goals, table_.goal_count, "goals");
    CheckNames(goals, "goal");
    for (const taskc_goal& goal : goals) {
      Require(goal.doc != nullptr && goal.type != nullptr && goal.unit != nullptr,
              fmt::format("the goal `{}` has no text, type or unit", goal.name));
      CheckShape(goal.name, goal.scalar, goal.rows, goal.columns);
      Require(LiesInside(goal.offset, SizeInBytes(goal), ScalarSize(goal.scalar)) &&
                  LiesInside(goal.held_offset, 1, 1) &&
                  LiesInside(goal.draw_offset, sizeof(taskc_int64), sizeof(taskc_int64)),
              fmt::format("the goal `{}` lies outside the memory", goal.name));
    }
  }

  void CheckObservations() const {
    Require(table_.observation_size <= kLargestCount,
            fmt::format("it observes {} numbers", table_.observation_size));
    const auto observations =
        Entries(table_.observations, table_.observation_count, "observations");
    CheckNames(observations, "observation");
    for (const taskc_observation& each : observations) {
      Require(each.doc != nullptr && each.type != nullptr && each.unit != nullptr,
              fmt::format("the observation `{}` has no text, type or unit", each.name));
      CheckShape(each.name, each.scalar, each.rows, each.columns);
      const uint64_t size = uint64_t{each.rows} * each.columns;
      Require(each.offset + size <= table_.observation_size,
              fmt::format("the observation `{}` lies outside of what is observed", each.name));
      Require(each.minimum <= each.maximum,
              fmt::format("the observation `{}` has no range", each.name));
    }
    Require(observations.empty() || table_.observe != nullptr, "nothing computes what it observes");
  }

  void CheckPhases() const {
    const auto phases = Entries(table_.phases, table_.phase_count, "phases");
    if (phases.empty()) return;
    CheckNames(phases, "phase");
    for (const taskc_phase& phase : phases) {
      Require(phase.doc != nullptr, fmt::format("the phase `{}` has no text", phase.name));
      CheckPlace(fmt::format("phase `{}`", phase.name), phase.place);
    }
    Require(LiesInside(table_.phase_offset, sizeof(taskc_int64), sizeof(taskc_int64)) &&
                LiesInside(table_.phase_time_offset, sizeof(double), sizeof(double)),
            "the phases lie outside the memory");
  }

  void CheckRewardsAndEnds() const {
    const auto terms = Entries(table_.terms, table_.term_count, "reward terms");
    CheckNames(terms, "reward term");
    for (const taskc_reward_term& term : terms) {
      Require(term.doc != nullptr, fmt::format("the reward term `{}` has no text", term.name));
      CheckPlace(fmt::format("reward term `{}`", term.name), term.place);
    }
    for (const taskc_end& end : Entries(table_.ends, table_.end_count, "ends")) {
      Require(end.reason != nullptr, "an end has no reason");
      Require(end.kind >= TASKC_SUCCESS && end.kind <= TASKC_TRUNCATED,
              fmt::format("the end `{}` is of an unknown kind", end.reason));
      CheckPlace(fmt::format("end `{}`", end.reason), end.place);
    }
  }

  void CheckMetrics() const {
    const auto metrics = Entries(table_.metrics, table_.metric_count, "metrics");
    CheckNames(metrics, "metric");
    for (const taskc_metric& metric : metrics) {
      Require(metric.doc != nullptr && metric.unit != nullptr,
              fmt::format("the metric `{}` has no text or unit", metric.name));
      CheckReduction("metric", metric.name, metric.reduction);
    }
    Require(metrics.empty() || table_.measure != nullptr, "nothing measures its metrics");
  }

  void CheckLogs() const {
    const auto logs = Entries(table_.logs, table_.log_count, "logs");
    CheckNames(logs, "log");
    for (const taskc_log& log : logs) {
      Require(log.doc != nullptr && log.unit != nullptr,
              fmt::format("the log `{}` has no text or unit", log.name));
      CheckReduction("log", log.name, log.reduction);
      CheckPlace(fmt::format("log `{}`", log.name), log.place);
    }
  }

  void CheckRequirements() const {
    for (const taskc_requirement& requirement :
         Entries(table_.requirements, table_.requirement_count, "requirements")) {
      Require(requirement.reason != nullptr, "a requirement has no reason");
      CheckPlace(fmt::format("requirement `{}`", requirement.reason), requirement.place);
    }
  }

  const std::filesystem::path& file_;
  const taskc_plugin& table_;
};

}  // namespace

void CheckPlugin(const std::filesystem::path& file, const taskc_plugin* table) {
  if (table == nullptr) {
    throw PluginError(
        PluginDefect::kDamaged,
        fmt::format("{}: returns no table; build it again with `taskc build`", file.string()));
  }
  TableCheck(file, *table).Run();
}

}  // namespace host
