#include "runtime/run/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

constexpr std::chrono::milliseconds kBetweenLiveLines{100};
constexpr std::chrono::seconds kBetweenPlainLines{10};

// A wrapped line could not be erased: cut it to the width of the terminal.
std::string FitToTerminal(std::string line, int descriptor) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 1) {
    line.resize(std::min(line.size(), static_cast<size_t>(size.ws_col) - 1));
  }
  return line;
}

// There is no best return while all episodes have diverged.
std::string BestText(double best_return) {
  return std::isfinite(best_return) ? fmt::format("{:.4g}", best_return) : "none";
}

using Json = nlohmann::ordered_json;

// `values` under the names of their `records`.
template <class Record>
Json ByName(const std::vector<Record>& records, const std::vector<double>& values) {
  Json json = Json::object();
  for (size_t i = 0; i < values.size(); ++i) json[records[i].name] = values[i];
  return json;
}

Json EvaluationJson(const Evaluation& evaluation, const TaskRecord& task) {
  return {{"task", task.task},
          {"return", evaluation.episode_return},
          {"end", {{"kind", evaluation.end_kind}, {"reason", evaluation.end_reason}}},
          {"terms", ByName(task.terms, evaluation.terms)},
          {"metrics", ByName(task.metrics, evaluation.metrics)},
          {"logs", ByName(task.logs, evaluation.logs)}};
}

}  // namespace

std::string DurationText(double seconds) {
  const auto whole = static_cast<int64_t>(std::max(0.0, seconds));
  const int64_t hours = whole / 3600;
  const int64_t minutes = whole / 60 % 60;
  if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
  return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string ProgressLine(const ProgressValues& values) {
  return fmt::format(
      "episode {}/{}  return {:.4g}  mean of {} {:.4g}  best {}  {:.1f}x real time  "
      "{} elapsed, {} left",
      values.episode, values.episodes_planned, values.last_return, ReturnStatistics::kMeanOver,
      values.mean, BestText(values.best_return), values.simulated_seconds_per_second,
      DurationText(values.elapsed), DurationText(values.remaining));
}

nlohmann::ordered_json EpisodeJson(const EpisodeRecord& episode, const RunRecord& run) {
  const Evaluation& active = episode.active;
  Json json = {{"episode", episode.number}};
  json.update(EvaluationJson(active, TaskWithId(run, active.task)));
  json.update({{"steps", episode.steps},
               {"actions", episode.actions},
               {"simulated_seconds", episode.simulated_seconds},
               {"wall_seconds", episode.wall_seconds},
               {"cpu_seconds", episode.cpu_seconds},
               {"faults", active.faults},
               {"violations", active.violations},
               {"learner", Json::object()}});
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
      is_live_(style == ProgressStyle::kText && isatty(fileno(output)) != 0) {
  values_.episodes_planned = run.episodes_planned;
}

Progress::~Progress() {
  if (line_is_shown_) fmt::print(output_, "\n");
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
    fmt::print(output_, "{}\n",
               EpisodeJson(episode, run_).dump(-1, ' ', false, Json::error_handler_t::replace));
    std::fflush(output_);
  }
  if (style_ != ProgressStyle::kText) return;
  const auto between =
      is_live_ ? Clock::duration(kBetweenLiveLines) : Clock::duration(kBetweenPlainLines);
  const bool is_first = episodes_here_ == 1;
  const bool is_last = values_.episode == values_.episodes_planned;
  if (!is_first && !is_last && now - last_line_ < between) return;
  last_line_ = now;
  Show();
}

void Progress::Show() {
  const std::string line = ProgressLine(values_);
  if (is_live_) {
    fmt::print(output_, "\r{}\x1b[K", FitToTerminal(line, fileno(output_)));
    line_is_shown_ = true;
  } else {
    fmt::print(output_, "{}\n", line);
  }
  std::fflush(output_);
}

void Progress::EraseLiveLine() {
  if (!line_is_shown_) return;
  fmt::print(output_, "\r\x1b[K");
  std::fflush(output_);
  line_is_shown_ = false;
}

void Progress::Warn(const std::string& text) {
  EraseLiveLine();
  fmt::print(warnings_, "{}\n", text);
  std::fflush(warnings_);
}

void Progress::Note(const std::string& text) {
  if (style_ != ProgressStyle::kText) return;
  EraseLiveLine();
  fmt::print(output_, "{}\n", text);
  std::fflush(output_);
}

}  // namespace runtime
