#include "runtime/live/control/view_layout.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "plugins/host/scalar_bytes.h"
#include "runtime/core/module/element_names.h"
#include "runtime/training/run/recorder.h"
#include "runtime/training/run/timeline.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

constexpr size_t kOfEpisode = 3;  // time, return, actions

// Puts numbers into a row.
class Row {
 public:
  explicit Row(std::span<float> out) : out_(out) {}

  void Add(double number) { out_[next_++] = static_cast<float>(number); }
  void Add(std::span<const double> numbers) {
    for (const double number : numbers) Add(number);
  }
  void AddNothing(size_t count) {
    for (size_t i = 0; i < count; ++i) Add(std::numeric_limits<double>::quiet_NaN());
  }
  // `place`: null where there is nothing yet.
  void Add(const std::byte* place, taskc_int32 scalar, size_t count) {
    if (place == nullptr) return AddNothing(count);
    for (size_t i = 0; i < count; ++i)
      Add(host::LoadScalar(place + i * host::ScalarSize(scalar), scalar));
  }
  std::span<float> Take(size_t count) {
    next_ += count;
    return out_.subspan(next_ - count, count);
  }

 private:
  std::span<float> out_;
  size_t next_ = 0;
};

template <class Entry>
size_t SizeOf(const Entry& entry) {
  return size_t{entry.rows} * entry.columns;
}

// The phase is one number, and so is how long it has lasted in the episode, in all its passes.
constexpr size_t kOfPhase = 2;

Json Single(const char* kind, const char* name, const char* unit, const char* doc) {
  return {{"kind", kind}, {"name", name}, {"type", "real"},
          {"unit", unit}, {"doc", doc},   {"size", 1}};
}

void AddPlace(const taskc_place& place, Json& value) {
  value["source"] = place.source;
  value["line"] = place.line;
}

// Of a sensor, a variable or a goal.
template <class Entry>
Json Compound(const char* kind, const Entry& entry, const Context& context) {
  const ObservedValue value = {.name = entry.name,
                               .type = entry.type,
                               .unit = entry.unit,
                               .size = SizeOf(entry),
                               .minimum = 0,
                               .maximum = 0};
  Json json = {{"kind", kind},       {"name", entry.name}, {"type", entry.type},
               {"unit", entry.unit}, {"doc", ""},          {"size", value.size}};
  if (value.size > 1) json["elements"] = ElementNames(value, *context.robot);
  return json;
}

template <class Entry>
std::span<const Entry> Table(const Entry* entries, taskc_uint32 count) {
  return {entries, count};
}

// `metrics`: empty where there is none yet.
void WriteTask(const TaskInstance& task, std::span<const double> metrics, Row& row) {
  const taskc_plugin& table = task.table();
  const host::TaskFrame& frame = task.frame();
  row.Add(frame.terms());
  row.Add(metrics);
  row.AddNothing(table.metric_count - metrics.size());
  for (const taskc_goal& goal : Table(table.goals, table.goal_count)) {
    row.Add(frame.Bytes(goal).data(), goal.scalar, SizeOf(goal));
  }
  if (table.phase_count > 0) {
    row.Add(static_cast<double>(task.phases().present()));
    row.Add(task.phases().sums()[task.phases().present()].time);
  }
  for (const taskc_memory& variable : Table(table.memory, table.memory_count)) {
    row.Add(frame.Bytes(variable).data(), variable.scalar, SizeOf(variable));
  }
  for (size_t i = 0; i < table.sensor_count; ++i) {
    row.Add(static_cast<const std::byte*>(frame.sensor(i)), table.sensors[i].scalar,
            SizeOf(table.sensors[i]));
  }
  for (const taskc_log_state& log : frame.logs()) {
    row.Add(log.count > 0 ? log.last : std::numeric_limits<double>::quiet_NaN());
  }
}

void WriteContacts(const Environment& environment, Row& row) {
  std::vector<uint8_t> bits(ContactBytes(static_cast<size_t>(environment.link_count())));
  environment.CaptureContacts(bits);
  for (int i = 0; i < environment.link_count(); ++i) {
    row.Add(bits[static_cast<size_t>(i / 8)] >> i % 8 & 1);
  }
}

}  // namespace

ViewLayout::ViewLayout(const EpisodeModules& modules, const Context& context)
    : links_(modules.environment.link_count()), poses_(modules.environment.pose_count()) {
  const UniversalTask& active = *modules.tasks.active;
  tasks_.emplace_back(&active, active.instance().id());
  Json values = Json::array();
  AddTask(active, context, values);
  for (const UniversalTask* shadow : modules.tasks.shadows) {
    tasks_.emplace_back(shadow, shadow->instance().id());
    values.push_back(Single("shadow", shadow->name().c_str(), "", shadow->plugin().name));
  }
  size_ = kOfEpisode + static_cast<size_t>(poses_ * Recorder::kFloatsPerLink + links_);
  for (const Json& value : values) size_ += value["size"].get<size_t>();
  const Json json = {{"module", active.name()},
                     {"task", active.plugin().name},
                     {"hash", active.plugin().source_hash},
                     {"links", links_},
                     {"poses", poses_},
                     {"size", size_},
                     {"values", std::move(values)}};
  json_ = json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void ViewLayout::AddTask(const UniversalTask& task, const Context& context, Json& values) {
  const taskc_plugin& table = task.plugin();
  for (const taskc_reward_term& term : Table(table.terms, table.term_count)) {
    AddPlace(term.place, values.emplace_back(Single("term", term.name, "", term.doc)));
  }
  for (const taskc_metric& metric : Table(table.metrics, table.metric_count)) {
    values.push_back(Single("metric", metric.name, metric.unit, metric.doc));
  }
  for (const taskc_goal& goal : Table(table.goals, table.goal_count)) {
    values.emplace_back(Compound("goal", goal, context))["doc"] = goal.doc;
  }
  if (table.phase_count > 0) {
    Json& phase = values.emplace_back(Single("phase", "phase", "", ""));
    phase["size"] = kOfPhase;
    for (const taskc_phase& each : Table(table.phases, table.phase_count)) {
      Json& described = phase["phases"].emplace_back(Json{{"name", each.name}, {"doc", each.doc}});
      AddPlace(each.place, described);
    }
  }
  for (const taskc_memory& variable : Table(table.memory, table.memory_count)) {
    values.push_back(Compound("memory", variable, context));
  }
  for (const taskc_sensor& sensor : Table(table.sensors, table.sensor_count)) {
    values.push_back(Compound("sensor", sensor, context));
  }
  for (const taskc_log& log : Table(table.logs, table.log_count)) {
    AddPlace(log.place, values.emplace_back(Single("log", log.name, log.unit, log.doc)));
  }
}

bool ViewLayout::Fits(const EpisodeModules& modules) const {
  const auto is_same = [](const auto& known, const UniversalTask* task) {
    return known.first == task && known.second == task->instance().id();
  };
  return is_same(tasks_.front(), modules.tasks.active) &&
         std::ranges::equal(std::span(tasks_).subspan(1), modules.tasks.shadows, is_same) &&
         links_ == modules.environment.link_count() && poses_ == modules.environment.pose_count();
}

void ViewLayout::Write(const EpisodeModules& modules, int64_t steps, std::span<float> out) const {
  UniversalTask& active = *modules.tasks.active;
  Row row(out);
  row.Add(modules.environment.time());
  row.Add(modules.learner.episode_return());
  row.Add(modules.learner.action_count());
  modules.environment.CapturePose(row.Take(static_cast<size_t>(poses_ * Recorder::kFloatsPerLink)));
  WriteContacts(modules.environment, row);
  const Environment::Peek peek(modules.environment);
  WriteTask(active.instance(), steps > 0 ? active.MeasureNow() : std::span<const double>(), row);
  for (const UniversalTask* shadow : modules.tasks.shadows) row.Add(shadow->episode_return());
}

}  // namespace runtime
