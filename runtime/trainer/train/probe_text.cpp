#include "runtime/trainer/train/probe_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "runtime/analysis/study/behavior_groups.h"
#include "runtime/training/run/progress.h"

namespace runtime {
namespace {

std::string Joined(const std::vector<std::string>& texts) {
  return fmt::format("{}", fmt::join(texts, "  "));
}

// "forward +406.3  turning -4.1", what paid or cost most first; terms of 0 are left out.
std::string TermsText(const TaskRecord& task, const std::vector<double>& sums) {
  std::vector<size_t> order(sums.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [&](size_t i) { return std::abs(sums[i]); });
  std::vector<std::string> texts;
  for (const size_t i : order) {
    if (sums[i] != 0) texts.push_back(fmt::format("{} {:+.4g}", task.terms[i].name, sums[i]));
  }
  return Joined(texts);
}

std::string MetricsText(const TaskRecord& task, const std::vector<double>& values) {
  std::vector<std::string> texts;
  for (size_t i = 0; i < task.metrics.size(); ++i) {
    const CurveRecord& metric = task.metrics[i];
    texts.push_back(fmt::format("{} {:.4g}{}", metric.name, values[i],
                                metric.unit.empty() ? "" : " " + metric.unit));
  }
  return Joined(texts);
}

std::string FindText(const Find& find, size_t index, const ProbeResults& results) {
  const Evaluation& active = find.episode.active;
  std::string text =
      fmt::format("{}  {:.4g}  after {:.2f} s: {}, {}\n", GroupName(index), active.episode_return,
                  find.episode.simulated_seconds, active.end_kind, active.end_reason);
  const auto add = [&](const std::string& line) {
    if (!line.empty()) text += "   " + line + "\n";
  };
  add(TermsText(results.task(), active.terms));
  add(MetricsText(results.task(), active.metrics));
  add(fmt::format("at most {:.2f} m/s fast and {:.2f} m high", find.extremes.speed,
                  find.extremes.height));
  if (!find.is_sound()) {
    add(
        fmt::format("no find: {} is beyond what the robot's description calls possible; the "
                    "simulation has gone astray",
                    fmt::join(find.beyond, " and ")));
  }
  add(fmt::format("{}, episode {}; {} of {} searches found such a motion", find.run,
                  find.episode.number, find.searches, results.searches));
  return text;
}

}  // namespace

std::string ProbeText(const ProbeResults& results) {
  std::string text =
      fmt::format("{}: {} searches, {} episodes, {} of CPU time\n", results.task().task,
                  results.searches, results.episodes, DurationText(results.cpu_seconds));
  for (size_t i = 0; i < results.finds.size(); ++i) {
    text += "\n" + FindText(results.finds[i], i, results);
  }
  if (results.left_out > 0) text += fmt::format("\n{} more with less\n", results.left_out);
  if (results.diverged > 0) {
    text += fmt::format("\n{} of the episodes diverged\n", results.diverged);
  }
  for (const std::string& note : results.notes) text += "\n" + note + "\n";
  return text;
}

}  // namespace runtime
