#include "runtime/live/workers/run_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/text/print.h"

namespace runtime {
namespace {

std::string ReturnText(const RunProgress& run, double value) {
  return run.episodes == 0 || !std::isfinite(value) ? "-" : fmt::format("{:.2f}", value);
}

int64_t EpisodesLeft(const RunProgress& run) {
  return run.is_over() ? 0 : std::max<int64_t>(run.episodes_planned - run.episodes, 0);
}

// Seconds of one episode, from those of all runs that this program has seen; 0: none yet.
double SecondsPerEpisode(const std::vector<RunProgress>& runs) {
  double seconds = 0;
  int64_t episodes = 0;
  for (const RunProgress& run : runs) {
    seconds += run.wall_seconds;
    episodes += run.episodes_here;
  }
  return episodes == 0 ? 0 : seconds / static_cast<double>(episodes);
}

std::string TimeLeft(const RunProgress& run) {
  if (run.state != RunProgressState::kRunning || run.episodes_here == 0) return "";
  return DurationText(run.wall_seconds / static_cast<double>(run.episodes_here) *
                      static_cast<double>(EpisodesLeft(run)));
}

// What a user wants to see of runs that are too many for the screen.
std::vector<RunProgress> OnlyActive(const std::vector<RunProgress>& runs) {
  std::vector<RunProgress> active;
  std::ranges::copy_if(runs, std::back_inserter(active), [](const RunProgress& run) {
    return run.state == RunProgressState::kRunning || run.state == RunProgressState::kFailed;
  });
  return active;
}

struct Column {
  std::string head;
  int rank = 0;      // as of a LineField
  size_t width = 0;  // at least
  std::function<std::string(const RunProgress&)> text;
};

constexpr size_t kLeastName = 8;
constexpr std::string_view kBetween = "  ";

// Behind the names; wide enough for what stands in them.
std::vector<Column> ColumnsOf(const std::vector<RunProgress>& runs) {
  const auto state = [](const RunProgress& run) { return fmt::format("{:<8}", NameOf(run.state)); };
  const auto episodes = [](const RunProgress& run) {
    return fmt::format("{}/{}", run.episodes, run.episodes_planned);
  };
  const auto last = [](const RunProgress& run) { return ReturnText(run, run.last_return); };
  const auto best = [](const RunProgress& run) { return ReturnText(run, run.best_return); };
  std::vector<Column> columns = {{"state   ", 2, 8, state},
                                 {"episodes", 1, 11, episodes},
                                 {"last", 5, 9, last},
                                 {"best", 4, 9, best},
                                 {"left", 3, 8, TimeLeft}};
  for (Column& column : columns) {
    for (const RunProgress& run : runs) {
      column.width = std::max(column.width, column.text(run).size());
    }
  }
  return columns;
}

// The longest name, or what the episodes leave of the line.
size_t NameWidth(const std::vector<RunProgress>& runs, const std::vector<Column>& all,
                 size_t columns) {
  size_t longest = kLeastName;
  for (const RunProgress& run : runs) longest = std::max(longest, run.name.size());
  const size_t others = kBetween.size() + std::ranges::min_element(all, {}, &Column::rank)->width;
  return std::min(longest, std::max(columns, others + kLeastName) - others);
}

// Names differ at their ends.
std::string FittingName(const std::string& name, size_t columns) {
  if (name.size() <= columns) return name;
  return "…" + name.substr(name.size() - columns + 1);
}

}  // namespace

std::string_view NameOf(RunProgressState state) {
  switch (state) {
    case RunProgressState::kWaiting:
      return "waiting";
    case RunProgressState::kRunning:
      return "running";
    case RunProgressState::kFinished:
      return "finished";
    case RunProgressState::kStopped:
      return "stopped";
    case RunProgressState::kFailed:
      break;
  }
  return "failed";
}

std::string RunTable(const std::vector<RunProgress>& runs, size_t columns) {
  const std::vector<Column> all = ColumnsOf(runs);
  const size_t name_width = NameWidth(runs, all, columns);
  const auto line = [&](const std::string& name, const auto& text_of) {
    std::vector<LineField> fields = {
        {fmt::format("{:<{}}", FittingName(name, name_width), name_width), 0}};
    for (const Column& column : all) {
      fields.push_back({fmt::format("{:>{}}", text_of(column), column.width), column.rank});
    }
    std::string text = FittingLine(fields, columns, kBetween);
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string text = line("run", [](const Column& column) { return column.head; });
  for (const RunProgress& run : runs) {
    text += line(run.name, [&](const Column& column) { return column.text(run); });
  }
  return text;
}

std::string RunSummary(const std::vector<RunProgress>& runs, int jobs, size_t columns) {
  std::string states;
  for (const auto state :
       {RunProgressState::kRunning, RunProgressState::kFinished, RunProgressState::kWaiting,
        RunProgressState::kStopped, RunProgressState::kFailed}) {
    const auto count = std::ranges::count(runs, state, &RunProgress::state);
    if (count == 0) continue;
    states += fmt::format("{}{} {}", states.empty() ? "" : ", ", count, NameOf(state));
  }
  int64_t done = 0;
  int64_t planned = 0;
  int64_t left = 0;
  for (const RunProgress& run : runs) {
    done += run.episodes;
    planned += run.episodes_planned;
    left += EpisodesLeft(run);
  }
  const double seconds = SecondsPerEpisode(runs) * static_cast<double>(left) / jobs;
  return FittingLine({{states, 2},
                      {fmt::format("{}/{} episodes", done, planned), 0},
                      {seconds > 0 ? fmt::format("{} left", DurationText(seconds)) : "", 1}},
                     columns, "   ");
}

RunTablePrinter::RunTablePrinter(ProgressStyle style, int jobs, std::FILE* output,
                                 std::FILE* warnings)
    : style_(style),
      jobs_(jobs),
      output_(output),
      warnings_(warnings),
      live_(output, style == ProgressStyle::kText) {}

void RunTablePrinter::Follow(const std::vector<RunProgress>& runs) {
  runs_ = &runs;
  Refresh(true);
}

void RunTablePrinter::Finish() {
  if (!IsForPeople(style_)) return;
  Erase();
  text::Print(output_, "{}{}\n", RunTable(*runs_, live_.columns()),
              RunSummary(*runs_, jobs_, live_.columns()));
  std::fflush(output_);
}

void RunTablePrinter::OnStart() {
  if (live_.is_on_terminal()) Refresh(true);
}

void RunTablePrinter::OnLine(const RunProgress& run, std::string_view json) {
  if (style_ == ProgressStyle::kJson) {
    // The worker's object with one more member in front.
    text::Print(output_, "{{\"run\":{},{}\n", nlohmann::json(run.name).dump(), json.substr(1));
    std::fflush(output_);
    return;
  }
  Refresh(false);
}

void RunTablePrinter::OnMessage(const RunProgress& run, std::string_view text) {
  Erase();
  text::Print(warnings_, "{}: {}\n", run.name, text);
  std::fflush(warnings_);
  Refresh(true);
}

void RunTablePrinter::OnStopping(bool at_once) {
  Erase();
  text::Print(warnings_, "{}\n",
              at_once ? "stopping at once"
                      : "stopping after the current episodes (saving) ... "
                        "Ctrl-C again to stop at once");
  std::fflush(warnings_);
  Refresh(true);
}

void RunTablePrinter::Refresh(bool at_once) {
  if (!IsForPeople(style_)) return;
  const auto now = std::chrono::steady_clock::now();
  const bool is_live = live_.is_on_terminal();
  const auto between = is_live ? std::chrono::milliseconds(200) : std::chrono::seconds(30);
  if (now - last_ < between && !(at_once && is_live)) return;
  last_ = now;
  if (is_live) return live_.Show(FittingTable());
  text::Print(output_, "{}\n", RunSummary(*runs_, jobs_));
  std::fflush(output_);
}

// Where not all runs have room, those that are running, as many as have.
std::string RunTablePrinter::FittingTable() const {
  constexpr size_t kBesidesRuns = 3;  // the head, the summary and the cursor's line
  const size_t rows = std::max(live_.rows(), kBesidesRuns) - kBesidesRuns;
  const size_t columns = live_.columns();
  std::vector<RunProgress> shown = runs_->size() > rows ? OnlyActive(*runs_) : *runs_;
  if (shown.size() > rows)
    shown.erase(shown.begin() + static_cast<std::ptrdiff_t>(rows), shown.end());
  return RunTable(shown, columns) + RunSummary(*runs_, jobs_, columns) + "\n";
}

void RunTablePrinter::Erase() { live_.Erase(); }

}  // namespace runtime
