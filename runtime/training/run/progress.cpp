#include "runtime/training/run/progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/print.h"

namespace runtime {
namespace {

constexpr std::chrono::milliseconds kBetweenLivePictures{100};
constexpr std::chrono::seconds kBetweenPlainLines{10};

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
    : style_(style),
      run_(run),
      output_(output),
      warnings_(warnings),
      live_(output, style == ProgressStyle::kText) {}

void Progress::Recall(const EpisodeRecord& episode) { Count(episode); }

// Terms of another task are others, whatever they are called.
void Progress::Count(const EpisodeRecord& episode) {
  picture_.history.Add(episode.active.episode_return);
  if (episode.active.task != task_) last_terms_.clear();
  task_ = episode.active.task;
  last_terms_.push_back(episode.active.terms);
  if (last_terms_.size() > ReturnStatistics::kMeanOver) last_terms_.pop_front();
}

void Progress::FinishEpisode(const EpisodeRecord& episode, const ReturnStatistics& statistics) {
  Count(episode);
  ProgressValues& values = picture_.values;
  values.episode = episode.number;
  values.episodes_planned = run_.episodes_planned;
  values.last_return = statistics.last();
  values.mean = statistics.mean();
  values.best_return = statistics.best();
  ++episodes_here_;
  simulated_seconds_ += episode.simulated_seconds;
  const auto now = Clock::now();
  values.elapsed = std::chrono::duration<double>(now - start_).count();
  values.simulated_seconds_per_second = simulated_seconds_ / std::max(values.elapsed, 1e-3);
  values.remaining = values.elapsed / static_cast<double>(episodes_here_) *
                     static_cast<double>(values.episodes_planned - values.episode);
  if (style_ == ProgressStyle::kJson) {
    text::Print(
        output_, "{}\n",
        EpisodeJson(episode, run_).dump(-1, ' ', false, OrderedJson::error_handler_t::replace));
    std::fflush(output_);
  }
  if (!IsForPeople(style_)) return;
  const auto between =
      live_.is_on_terminal() ? Clock::duration(kBetweenLivePictures) : kBetweenPlainLines;
  const bool is_first = episodes_here_ == 1;
  const bool is_last = values.episode == values.episodes_planned;
  if (!is_first && !is_last && now - last_shown_ < between) return;
  last_shown_ = now;
  Show();
}

void Progress::Show() {
  if (!live_.is_on_terminal()) {
    text::Print(output_, "{}\n", ProgressLine(picture_.values));
    std::fflush(output_);
    return;
  }
  const TaskRecord& task = TaskWithId(run_, task_);
  picture_.terms.clear();
  for (size_t i = 0; i < task.terms.size(); ++i) {
    double sum = 0;
    for (const std::vector<double>& terms : last_terms_) sum += terms[i];
    picture_.terms.push_back({task.terms[i].name, sum / static_cast<double>(last_terms_.size())});
  }
  const size_t rows = live_.rows();
  live_.Show(ProgressScreen(picture_, live_.columns(), rows == kAnyWidth ? rows : rows - 1));
  is_shown_ = true;
}

void Progress::Print(std::FILE* output, const std::string& text) {
  live_.Erase();
  text::Print(output, "{}\n", text);
  std::fflush(output);
  if (is_shown_) Show();
}

void Progress::Warn(const std::string& text) { Print(warnings_, text); }

void Progress::Note(const std::string& text) {
  if (IsForPeople(style_)) Print(output_, text);
}

void Progress::Leave() {
  if (!is_shown_) return;
  Show();
  live_.Leave();
  is_shown_ = false;
}

}  // namespace runtime
