#include "runtime/training/run/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/print.h"

namespace runtime {
namespace {

constexpr std::chrono::milliseconds kBetweenLiveLines{100};
constexpr std::chrono::seconds kBetweenPlainLines{10};

// There is no best return while all episodes have diverged.
std::string BestText(double best_return) {
  return std::isfinite(best_return) ? fmt::format("{:.4g}", best_return) : "none";
}

using OrderedJson = nlohmann::ordered_json;

// `values` under the names of their `records`.
template <class Record>
OrderedJson ByName(const std::vector<Record>& records, const std::vector<double>& values) {
  OrderedJson json = OrderedJson::object();
  for (size_t i = 0; i < values.size(); ++i) json[records[i].name] = values[i];
  return json;
}

// What the robot was told, in the order of time.
OrderedJson GoalsJson(const Evaluation& evaluation, const TaskRecord& task) {
  OrderedJson json = OrderedJson::array();
  for (const GoalDraw& draw : evaluation.goals)
    json.push_back(
        {{"name", task.goals[draw.goal].name}, {"time", draw.time}, {"value", draw.value}});
  return json;
}

OrderedJson PhasesJson(const Evaluation& evaluation, const TaskRecord& task) {
  OrderedJson json = OrderedJson::object();
  for (size_t i = 0; i < evaluation.phases.size(); ++i)
    json[task.phases[i].name] = {{"time", evaluation.phases[i].time},
                                 {"return", evaluation.phases[i].reward}};
  return json;
}

OrderedJson EvaluationJson(const Evaluation& evaluation, const TaskRecord& task) {
  return {{"task", task.task},
          {"return", evaluation.episode_return},
          {"end", {{"kind", evaluation.end_kind}, {"reason", evaluation.end_reason}}},
          {"terms", ByName(task.terms, evaluation.terms)},
          {"metrics", ByName(task.metrics, evaluation.metrics)},
          {"logs", ByName(task.logs, evaluation.logs)},
          {"goals", GoalsJson(evaluation, task)},
          {"phases", PhasesJson(evaluation, task)}};
}

}  // namespace

std::string DurationText(double seconds) {
  const auto whole = static_cast<int64_t>(std::max(0.0, seconds));
  const int64_t hours = whole / 3600;
  const int64_t minutes = whole / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
  return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string ProgressLine(const ProgressValues& values, size_t columns) {
  return FittingLine(
      {{fmt::format("episode {}/{}", values.episode, values.episodes_planned), 0},
       {fmt::format("return {:.4g}", values.last_return), 4},
       {fmt::format("mean of {} {:.4g}", ReturnStatistics::kMeanOver, values.mean), 2},
       {fmt::format("best {}", BestText(values.best_return)), 3},
       {fmt::format("{:.1f}x real time", values.simulated_seconds_per_second), 5},
       {fmt::format("{} elapsed", DurationText(values.elapsed)), 6},
       {fmt::format("{} left", DurationText(values.remaining)), 1}},
      columns);
}

nlohmann::ordered_json EpisodeJson(const EpisodeRecord& episode, const RunRecord& run) {
  const Evaluation& active = episode.active;
  OrderedJson json = {{"episode", episode.number}};
  json.update(EvaluationJson(active, TaskWithId(run, active.task)));
  json.update({{"steps", episode.steps},
               {"actions", episode.actions},
               {"simulated_seconds", episode.simulated_seconds},
               {"wall_seconds", episode.wall_seconds},
               {"cpu_seconds", episode.cpu_seconds},
               {"faults", active.faults},
               {"violations", active.violations},
               {"learner", OrderedJson::object()}});
  for (const NamedValue& each : episode.learner) json["learner"][each.name] = each.value;
  for (const Evaluation& shadow : episode.shadows) {
    const TaskRecord& task = TaskWithId(run, shadow.task);
    json["shadows"][task.module] = EvaluationJson(shadow, task);
  }
  return json;
}

Progress::Progress(ProgressStyle style, const RunRecord& run, std::FILE* output,
                   std::FILE* warnings)
    : style_(style), run_(run), output_(output), warnings_(warnings), live_(output) {
  values_.episodes_planned = run.episodes_planned;
}

void Progress::FinishEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics) {
  values_.episode = episode.number;
  values_.last_return = statistics.last();
  values_.mean = statistics.mean();
  values_.best_return = statistics.best();
  ++episodes_here_;
  simulated_seconds_ += episode.simulated_seconds;
  const auto now = Clock::now();
  values_.elapsed = std::chrono::duration<double>(now - start_).count();
  values_.simulated_seconds_per_second = simulated_seconds_ / std::max(values_.elapsed, 1e-3);
  values_.remaining = values_.elapsed / static_cast<double>(episodes_here_) *
                      static_cast<double>(values_.episodes_planned - values_.episode);
  if (style_ == ProgressStyle::kJson) {
    text::Print(
        output_, "{}\n",
        EpisodeJson(episode, run_).dump(-1, ' ', false, OrderedJson::error_handler_t::replace));
    std::fflush(output_);
  }
  if (style_ != ProgressStyle::kText) return;
  const auto between =
      live_.is_on_terminal() ? Clock::duration(kBetweenLiveLines) : kBetweenPlainLines;
  const bool is_first = episodes_here_ == 1;
  const bool is_last = values_.episode == values_.episodes_planned;
  if (!is_first && !is_last && now - last_line_ < between) return;
  last_line_ = now;
  Show();
}

void Progress::Show() {
  if (live_.is_on_terminal()) {
    return live_.Show(ProgressLine(values_, live_.columns()) + "\n");
  }
  text::Print(output_, "{}\n", ProgressLine(values_));
  std::fflush(output_);
}

void Progress::Warn(const std::string& text) {
  live_.Erase();
  text::Print(warnings_, "{}\n", text);
  std::fflush(warnings_);
}

void Progress::Note(const std::string& text) {
  if (style_ != ProgressStyle::kText) return;
  live_.Erase();
  text::Print(output_, "{}\n", text);
  std::fflush(output_);
}

}  // namespace runtime
