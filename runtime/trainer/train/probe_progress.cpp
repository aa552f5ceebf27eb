#include "runtime/trainer/train/probe_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text/print.h"

namespace runtime {
namespace {

using Clock = std::chrono::steady_clock;

int64_t EpisodesOf(const std::vector<RunProgress>& runs) {
  int64_t episodes = 0;
  for (const RunProgress& run : runs) episodes += run.episodes;
  return episodes;
}

}  // namespace

ProbeProgress::ProbeProgress(ProgressStyle style, const ProbeBudget& budget)
    : style_(style),
      budget_(budget),
      start_(Clock::now()),
      live_(stdout, style == ProgressStyle::kText) {}

void ProbeProgress::Follow(const std::vector<RunProgress>& runs) {
  runs_ = &runs;
  if (episodes_before_ < 0) episodes_before_ = EpisodesOf(runs);
  Refresh();
}

void ProbeProgress::OnMessage(const RunProgress& run, std::string_view text) {
  Erase();
  text::Print(stderr, "{}: {}\n", run.name, text);
}

void ProbeProgress::OnStopping(bool at_once) {
  Erase();
  text::Print(stderr, "{}\n",
              at_once ? "stopping at once"
                      : "stopping after the current episodes; what was found is kept ... Ctrl-C "
                        "again to stop at once");
}

void ProbeProgress::Refresh() {
  if (!IsForPeople(style_)) return;
  const bool is_live = live_.is_on_terminal();
  const auto between = is_live ? std::chrono::milliseconds(200) : std::chrono::seconds(30);
  if (Clock::now() - last_ < between) return;
  last_ = Clock::now();
  if (is_live) return live_.Show(Line() + "\n");
  text::Print("{}\n", Line());
  std::fflush(stdout);
}

std::string ProbeProgress::Line() const {
  double best = -std::numeric_limits<double>::infinity();
  for (const RunProgress& run : *runs_) best = std::fmax(best, run.best_return);
  const double left = SecondsLeft();
  return FittingLine({{fmt::format("{} searches", runs_->size()), 3},
                      {fmt::format("{} episodes", EpisodesOf(*runs_)), 2},
                      {std::isfinite(best) ? fmt::format("best {:.4g}", best) : "", 0},
                      {left >= 0 ? fmt::format("{} left", DurationText(left)) : "", 1}},
                     live_.columns());
}

double ProbeProgress::SecondsLeft() const {
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  if (budget_.episodes == 0) return std::max(budget_.seconds - elapsed, 0.0);
  const int64_t done = EpisodesOf(*runs_);
  if (done <= episodes_before_) return -1;
  const int64_t planned = budget_.episodes * static_cast<int64_t>(runs_->size());
  return elapsed / static_cast<double>(done - episodes_before_) *
         static_cast<double>(std::max<int64_t>(planned - done, 0));
}

}  // namespace runtime
