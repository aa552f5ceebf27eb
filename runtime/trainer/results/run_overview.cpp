#include "runtime/trainer/results/run_overview.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "runtime/analysis/report/version_difference.h"
#include "runtime/training/run/progress.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/run/run_settings.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMeanOver = ReturnStatistics::kMeanOver;

// Over those of the last episodes that have a value there and were paid by the last one's task; not
// a number where none has. `value_of`: the value with an index, of an evaluation.
template <class ValueOf>
std::vector<double> LastMeans(std::span<const EpisodeRecord> episodes, size_t count,
                              const ValueOf& value_of) {
  std::vector<double> means;
  for (size_t i = 0; i < count; ++i) {
    double sum = 0;
    int64_t values = 0;
    for (const EpisodeRecord& episode : episodes.last(std::min(episodes.size(), kMeanOver))) {
      if (episode.active.task != episodes.back().active.task) continue;
      const double value = value_of(episode.active, i);
      if (std::isnan(value)) continue;
      sum += value;
      ++values;
    }
    means.push_back(sum / static_cast<double>(values));  // 0 / 0 without a value
  }
  return means;
}

// Of each goal the last draw.
std::vector<GoalDraw> LastDraws(const Evaluation& evaluation) {
  std::map<size_t, const GoalDraw*> last;
  for (const GoalDraw& draw : evaluation.goals) last[draw.goal] = &draw;
  std::vector<GoalDraw> draws;
  for (const auto& [goal, draw] : last) draws.push_back(*draw);
  return draws;
}

std::vector<PhaseSums> LastPhases(std::span<const EpisodeRecord> episodes, size_t count) {
  const auto time = [](const Evaluation& each, size_t i) { return each.phases[i].time; };
  const auto reward = [](const Evaluation& each, size_t i) { return each.phases[i].reward; };
  const std::vector<double> times = LastMeans(episodes, count, time);
  const std::vector<double> rewards = LastMeans(episodes, count, reward);
  std::vector<PhaseSums> phases;
  for (size_t i = 0; i < count; ++i) phases.push_back({times[i], rewards[i]});
  return phases;
}

std::vector<ShadowOverview> Shadows(const RunRecord& run, std::span<const EpisodeRecord> episodes) {
  std::vector<ShadowOverview> shadows;
  if (episodes.empty()) return shadows;
  for (const Evaluation& last : episodes.back().shadows) {
    double sum = 0;
    int64_t count = 0;
    for (const EpisodeRecord& episode : episodes.last(std::min(episodes.size(), kMeanOver))) {
      for (const Evaluation& each : episode.shadows) {
        if (each.task != last.task) continue;
        sum += each.episode_return;
        ++count;
      }
    }
    shadows.push_back(
        {TaskWithId(run, last.task), last.episode_return, sum / static_cast<double>(count)});
  }
  return shadows;
}

// Appends lines of a name and a value.
class Lines {
 public:
  template <class... Arguments>
  void Add(const char* name, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format("{:<10} {}\n", name,
                         fmt::format(format, std::forward<Arguments>(arguments)...));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void AddMeans(const char* name, const std::vector<CurveRecord>& curves,
              const std::vector<double>& means, Lines& lines) {
  for (size_t i = 0; i < curves.size(); ++i) {
    lines.Add(name, "{}: {:.6g}{} on average over the last {}", curves[i].name, means[i],
              curves[i].unit.empty() ? "" : " " + curves[i].unit, kMeanOver);
  }
}

void AddGoals(const RunOverview& overview, Lines& lines) {
  for (const GoalDraw& draw : overview.goals) {
    const GoalRecord& goal = overview.task.goals[draw.goal];
    lines.Add("goal", "{}: {:.6g}{} at the end of the last episode", goal.name,
              fmt::join(draw.value, ", "), goal.unit.empty() ? "" : " " + goal.unit);
  }
}

// As `taskc diff` has it, line by line.
void AddDifference(std::string_view difference, Lines& lines) {
  while (!difference.empty()) {
    const std::string_view line = difference.substr(0, difference.find('\n'));
    lines.Add("", "  {}", line);
    difference.remove_prefix(std::min(line.size() + 1, difference.size()));
  }
}

// Which task ran when, where there was more than one, and what each changed; shadows; changes.
void AddHistory(const RunOverview& overview, Lines& lines) {
  if (overview.versions.size() > 1) {
    for (size_t i = 0; i < overview.versions.size(); ++i) {
      const TaskSpan& span = overview.versions[i];
      lines.Add("version", "episodes {} to {}: {}", span.first, span.last,
                VersionText(TaskWithId(overview.run, span.task)));
      if (i > 0) AddDifference(overview.differences[i - 1], lines);
    }
  }
  for (const ShadowOverview& shadow : overview.shadows) {
    lines.Add("shadow", "{}, {}: {:.6g} on average over the last {}", shadow.task.module,
              VersionText(shadow.task), shadow.mean_return, kMeanOver);
  }
  for (const ChangeRecord& change : overview.changes) {
    lines.Add("change", "episode {}{}: {}", change.episode,
              change.step == 0 ? "" : fmt::format(", step {}", change.step), change.text);
  }
}

// What comes after the last checkpoint is lost where a trainer is killed.
std::string WhatIsRepeated(const RunOverview& overview) {
  const int64_t repeated = overview.episodes - overview.checkpoint_episode;
  if (repeated <= 0 || overview.state != RunStateName(RunState::kInterrupted)) return "";
  const std::string where =
      overview.checkpoint_episode == 0
          ? "there is no checkpoint yet"
          : fmt::format("the last checkpoint is at {}", overview.checkpoint_episode);
  return fmt::format(" recorded; {}: `resume` repeats {}", where,
                     repeated == 1 ? "1 episode" : fmt::format("{} episodes", repeated));
}

Json Phases(const RunOverview& overview) {
  Json json = Json::object();
  for (size_t i = 0; i < overview.phases.size(); ++i) {
    json[overview.task.phases[i].name] = {{"time", overview.phases[i].time},
                                          {"return", overview.phases[i].reward}};
  }
  return json;
}

Json MeansByName(const std::vector<CurveRecord>& curves, const std::vector<double>& means) {
  Json json = Json::object();
  for (size_t i = 0; i < curves.size(); ++i) json[curves[i].name] = means[i];
  return json;
}

Json GoalsByName(const RunOverview& overview) {
  Json json = Json::object();
  for (const GoalDraw& draw : overview.goals) {
    json[overview.task.goals[draw.goal].name] = draw.value;
  }
  return json;
}

Json Versions(const RunOverview& overview) {
  Json json = Json::array();
  for (size_t i = 0; i < overview.versions.size(); ++i) {
    const TaskSpan& span = overview.versions[i];
    const TaskRecord& task = TaskWithId(overview.run, span.task);
    json.push_back({{"task", task.task},
                    {"task_file", task.task_file},
                    {"task_hash", task.task_hash},
                    {"first_episode", span.first},
                    {"last_episode", span.last},
                    {"difference", i > 0 ? overview.differences[i - 1] : ""}});
  }
  return json;
}

Json Shadows(const RunOverview& overview) {
  Json json = Json::object();
  for (const ShadowOverview& shadow : overview.shadows) {
    json[shadow.task.module] = {{"task", shadow.task.task},
                                {"task_hash", shadow.task.task_hash},
                                {"last_return", shadow.last_return},
                                {"mean_of_last_20", shadow.mean_return}};
  }
  return json;
}

Json Changes(const RunOverview& overview) {
  Json json = Json::array();
  for (const ChangeRecord& change : overview.changes) {
    json.push_back({{"episode", change.episode},
                    {"step", change.step},
                    {"at", change.at},
                    {"kind", KindOf(change.change)},
                    {"text", change.text}});
  }
  return json;
}

}  // namespace

RunOverview ReadOverview(const std::filesystem::path& folder) {
  const RunDatabase database = RunDatabase::OpenToRead(folder);
  RunOverview overview;
  auto [run, episodes] = database.ReadRunAndEpisodes();
  overview.run = std::move(run);
  overview.state = RunStateName(database.ReadState());
  overview.started_at = database.ReadValue("started_at");
  overview.finished_at = database.ReadValue("finished_at");
  overview.task = episodes.empty() ? overview.run.tasks.front()
                                   : TaskWithId(overview.run, episodes.back().active.task);
  overview.episodes = static_cast<int64_t>(episodes.size());
  overview.checkpoint_episode = database.ReadCheckpointEpisode();
  for (const EpisodeRecord& episode : episodes) {
    overview.returns.Add(episode);
    overview.simulated_seconds += episode.simulated_seconds;
    overview.wall_seconds += episode.wall_seconds;
    overview.faults += episode.active.faults;
    overview.violations += episode.active.violations;
    ++overview.ends[{episode.active.end_kind, episode.active.end_reason}];
  }
  overview.metrics = LastMeans(episodes, overview.task.metrics.size(),
                               [](const Evaluation& each, size_t i) { return each.metrics[i]; });
  overview.logs = LastMeans(episodes, overview.task.logs.size(),
                            [](const Evaluation& each, size_t i) { return each.logs[i]; });
  overview.phases = LastPhases(episodes, overview.task.phases.size());
  if (!episodes.empty()) {
    overview.goals = LastDraws(episodes.back().active);
    overview.learner = episodes.back().learner;
  }
  overview.versions = ActiveTasks(episodes);
  for (size_t i = 1; i < overview.versions.size(); ++i) {
    overview.differences.push_back(
        VersionDifference(overview.run, TaskWithId(overview.run, overview.versions[i - 1].task),
                          TaskWithId(overview.run, overview.versions[i].task)));
  }
  overview.shadows = Shadows(overview.run, episodes);
  overview.changes = database.ReadChanges();
  return overview;
}

std::string OverviewText(const RunOverview& overview) {
  const RunRecord& run = overview.run;
  Lines lines;
  lines.Add("task", "{} ({})", overview.task.task, overview.task.task_file);
  if (!run.robot.empty()) lines.Add("robot", "{}, profile {}", run.robot, run.profile);
  lines.Add("seed", "{}", run.seed);
  lines.Add("state", "{}, since {}", overview.state,
            overview.finished_at.empty() ? overview.started_at : overview.finished_at);
  for (const Setting& setting : SettingsOf(run)) {
    lines.Add("setting", "{} = {} ({})", setting.name, setting.value, setting.origin);
  }
  const std::string command = TrainCommand(run);
  if (!command.empty()) lines.Add("command", "{}", command);
  lines.Add("episodes", "{} of {}{}", overview.episodes, run.episodes_planned,
            WhatIsRepeated(overview));
  if (overview.episodes > 0) {
    if (overview.returns.best_episode() > 0) {
      lines.Add("best", "{:.6g} (episode {})", overview.returns.best(),
                overview.returns.best_episode());
    }
    lines.Add("last 20", "{:.6g} on average", overview.returns.mean());
    AddMeans("metric", overview.task.metrics, overview.metrics, lines);
    AddMeans("log", overview.task.logs, overview.logs, lines);
    AddGoals(overview, lines);
    for (size_t i = 0; i < overview.phases.size(); ++i) {
      lines.Add("phase", "{}: {:.6g} s with a return of {:.6g} on average over the last {}",
                overview.task.phases[i].name, overview.phases[i].time, overview.phases[i].reward,
                kMeanOver);
    }
    for (const NamedValue& each : overview.learner) {
      lines.Add("learner", "{}: {:.6g} in the last episode", each.name, each.value);
    }
    lines.Add("time", "{} simulated in {}", DurationText(overview.simulated_seconds),
              DurationText(overview.wall_seconds));
  }
  if (overview.faults > 0)
    lines.Add("faults", "{} rewards or learning steps were not finite or too large",
              overview.faults);
  if (overview.violations > 0) {
    lines.Add("violations", "{} times a requirement of the task did not hold", overview.violations);
  }
  for (const auto& [end, count] : overview.ends) {
    lines.Add("ends", "{} {}: {}", count, end.first, end.second);
  }
  AddHistory(overview, lines);
  return lines.text();
}

Json OverviewJson(const RunOverview& overview) {
  const RunRecord& run = overview.run;
  Json ends = Json::array();
  for (const auto& [end, count] : overview.ends) {
    ends.push_back({{"kind", end.first}, {"reason", end.second}, {"count", count}});
  }
  Json learner = Json::object();
  for (const NamedValue& each : overview.learner) learner[each.name] = each.value;
  Json json = {{"task", overview.task.task},
               {"task_file", overview.task.task_file},
               {"task_hash", overview.task.task_hash},
               {"robot", run.robot},
               {"profile", run.profile},
               {"agent", run.agent},
               {"settings", SettingsJson(run)},
               {"command", TrainCommand(run)},
               {"seed", run.seed},
               {"state", overview.state},
               {"started_at", overview.started_at},
               {"finished_at", overview.finished_at},
               {"episodes", overview.episodes},
               {"checkpoint_episode", overview.checkpoint_episode},
               {"episodes_planned", run.episodes_planned},
               {"simulated_seconds", overview.simulated_seconds},
               {"wall_seconds", overview.wall_seconds},
               {"faults", overview.faults},
               {"violations", overview.violations},
               {"mean_of_last_20", overview.returns.mean()},
               {"metrics", MeansByName(overview.task.metrics, overview.metrics)},
               {"logs", MeansByName(overview.task.logs, overview.logs)},
               {"goals", GoalsByName(overview)},
               {"phases", Phases(overview)},
               {"learner", learner},
               {"ends", ends},
               {"versions", Versions(overview)},
               {"shadows", Shadows(overview)},
               {"changes", Changes(overview)}};
  if (overview.returns.best_episode() > 0) {
    json["best"] = {{"episode", overview.returns.best_episode()},
                    {"return", overview.returns.best()}};
  }
  return json;
}

}  // namespace runtime
