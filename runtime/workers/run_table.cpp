#include "runtime/workers/run_table.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace runtime {
namespace {

std::string ReturnText(const RunProgress& run, double value) {
  return run.episodes == 0 || !std::isfinite(value) ? "-" : fmt::format("{:.2f}", value);
}

int64_t EpisodesLeft(const RunProgress& run) {
  const bool is_over =
      run.state == RunProgressState::kFinished || run.state == RunProgressState::kFailed;
  return is_over ? 0 : std::max<int64_t>(run.episodes_planned - run.episodes, 0);
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

// Lines of the terminal; many where there is none.
size_t TerminalHeight(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 ? size.ws_row : 1000;
}

// What a user wants to see of runs that are too many for the screen.
std::vector<RunProgress> OnlyActive(const std::vector<RunProgress>& runs) {
  std::vector<RunProgress> active;
  std::ranges::copy_if(runs, std::back_inserter(active), [](const RunProgress& run) {
    return run.state == RunProgressState::kRunning || run.state == RunProgressState::kFailed;
  });
  return active;
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

std::string RunTable(const std::vector<RunProgress>& runs) {
  size_t width = 8;
  for (const RunProgress& run : runs) width = std::max(width, run.name.size());
  std::string text = fmt::format("{:<{}}  {:<8}  {:>11}  {:>9}  {:>9}  {:>8}\n", "run", width,
                                 "state", "episodes", "last", "best", "left");
  for (const RunProgress& run : runs) {
    std::string line = fmt::format(
        "{:<{}}  {:<8}  {:>11}  {:>9}  {:>9}  {:>8}", run.name, width, NameOf(run.state),
        fmt::format("{}/{}", run.episodes, run.episodes_planned), ReturnText(run, run.last_return),
        ReturnText(run, run.best_return), TimeLeft(run));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string RunSummary(const std::vector<RunProgress>& runs, int jobs) {
  std::string text;
  for (const auto state :
       {RunProgressState::kRunning, RunProgressState::kFinished, RunProgressState::kWaiting,
        RunProgressState::kStopped, RunProgressState::kFailed}) {
    const auto count = std::ranges::count(runs, state, &RunProgress::state);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, NameOf(state));
  }
  int64_t done = 0;
  int64_t planned = 0;
  int64_t left = 0;
  for (const RunProgress& run : runs) {
    done += run.episodes;
    planned += run.episodes_planned;
    left += EpisodesLeft(run);
  }
  text += fmt::format("   {}/{} episodes", done, planned);
  const double seconds = SecondsPerEpisode(runs);
  if (seconds > 0 && left > 0) {
    text += fmt::format("   {} left", DurationText(seconds * static_cast<double>(left) / jobs));
  }
  return text;
}

RunTablePrinter::RunTablePrinter(ProgressStyle style, int jobs, std::FILE* output,
                                 std::FILE* warnings)
    : style_(style),
      jobs_(jobs),
      output_(output),
      warnings_(warnings),
      is_live_(style == ProgressStyle::kText && isatty(fileno(output)) != 0) {}

void RunTablePrinter::Follow(const std::vector<RunProgress>& runs) {
  runs_ = &runs;
  Refresh(true);
}

void RunTablePrinter::Finish() {
  if (style_ != ProgressStyle::kText) return;
  Erase();
  fmt::print(output_, "{}{}\n", RunTable(*runs_), RunSummary(*runs_, jobs_));
  std::fflush(output_);
}

void RunTablePrinter::OnLine(const RunProgress& run, std::string_view json) {
  if (style_ == ProgressStyle::kJson) {
    // The worker's object with one more member in front.
    fmt::print(output_, "{{\"run\":{},{}\n", nlohmann::json(run.name).dump(), json.substr(1));
    std::fflush(output_);
    return;
  }
  Refresh(false);
}

void RunTablePrinter::OnMessage(const RunProgress& run, std::string_view text) {
  Erase();
  fmt::print(warnings_, "{}: {}\n", run.name, text);
  std::fflush(warnings_);
  Refresh(true);
}

void RunTablePrinter::Refresh(bool at_once) {
  if (style_ != ProgressStyle::kText) return;
  const auto now = std::chrono::steady_clock::now();
  const auto between = is_live_ ? std::chrono::milliseconds(200) : std::chrono::seconds(30);
  if (now - last_ < between && !(at_once && is_live_)) return;
  last_ = now;
  if (!is_live_) {
    fmt::print(output_, "{}\n", RunSummary(*runs_, jobs_));
  } else {
    Erase();
    constexpr size_t kBesidesRuns = 3;  // the head, the summary and the cursor's line
    const bool all_fit = runs_->size() + kBesidesRuns <= TerminalHeight(fileno(output_));
    const std::string table =
        RunTable(all_fit ? *runs_ : OnlyActive(*runs_)) + RunSummary(*runs_, jobs_) + "\n";
    fmt::print(output_, "{}", table);
    lines_shown_ = static_cast<int>(std::ranges::count(table, '\n'));
  }
  std::fflush(output_);
}

void RunTablePrinter::Erase() {
  if (lines_shown_ > 0) fmt::print(output_, "\x1b[{}A\r\x1b[J", lines_shown_);
  lines_shown_ = 0;
}

}  // namespace runtime
