#include "runtime/analysis/study/curve_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/base/child_process.h"
#include "runtime/base/scratch_folder.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

// Of the groups of behaviors, in the order of the groups; then they begin again. As --series-1 to
// --series-8 of the pages (web/src/style/theme.css).
constexpr std::array kGroupColors = {"#1f5fa8", "#b14d15", "#2f8a57", "#8a4fae",
                                     "#8a6910", "#16808c", "#b03a63", "#5a636d"};
constexpr const char* kColorWithoutGroup = "#666f78";
constexpr int kFirstRunColumn = 5;  // after the episode, the mean and its interval

std::string ColorOf(const RunResult& run) {
  return run.group ? kGroupColors[*run.group % kGroupColors.size()] : kColorWithoutGroup;
}

// gnuplot knows `NaN` as a gap.
std::string Column(double value) {
  return std::isfinite(value) ? fmt::format(" {:.6g}", value) : " NaN";
}

std::string Style(int64_t window) {
  return fmt::format(
      "set terminal svg size 860,360 font 'DejaVu Sans,Helvetica,Arial,sans-serif,13' "
      "background rgb '#ffffff'\n"
      "set border 3 linecolor rgb '#666f78'\n"
      "set tics nomirror textcolor rgb '#5a636d' scale 0.5\n"
      "set grid linecolor rgb '#eceff1' linetype 1\n"
      "set xzeroaxis linecolor rgb '#aab2b9' linetype 1\n"
      "set xlabel 'episode' textcolor rgb '#5a636d'\n"
      "set ylabel 'return, mean of {}' textcolor rgb '#5a636d'\n"
      "set key off\nset lmargin 9\nset rmargin 2\n",
      window);
}

std::string Data(const Curves& curves) {
  std::string data = "$data << end\n";
  for (size_t i = 0; i < curves.episodes.size(); ++i) {
    const Estimate& mean = curves.means[i];
    data += fmt::format("{}", curves.episodes[i]);
    for (const double value : {mean.mean, mean.low, mean.high}) data += Column(value);
    for (const std::vector<double>& run : curves.runs) {
      data += Column(i < run.size() ? run[i] : std::nan(""));
    }
    data += "\n";
  }
  return data + "end\n";
}

std::string Plot(const ExperimentResult& result, const Curves& curves) {
  const bool has_interval = std::ranges::any_of(
      curves.means, [](const Estimate& mean) { return std::isfinite(mean.low); });
  std::string plot = "plot ";
  if (has_interval) {
    plot += "$data using 1:3:4 title '95 %' with filledcurves fillcolor rgb '#e1e7ed', ";
  }
  for (size_t run = 0; run < result.runs.size(); ++run) {
    plot += fmt::format(
        "$data using 1:{} title 'seed {}' with lines linewidth 1.25 linecolor rgb '{}', ",
        kFirstRunColumn + run, result.runs[run].run->record.seed, ColorOf(result.runs[run]));
  }
  return plot + "$data using 1:2 title 'mean' with lines linewidth 2.5 linecolor rgb '#1c2127'\n";
}

}  // namespace

std::string DrawCurves(const ExperimentResult& result, const Curves& curves) {
  const ScratchFolder scratch;
  const std::filesystem::path script = scratch.path() / "curves.gnuplot";
  WriteFile(script, Style(result.window) + Data(curves) + Plot(result, curves));
  ChildResult drawing = RunChild({"gnuplot", script.string()}, Captured::kOutput);
  if (drawing.is_success) return std::move(drawing.captured);
  throw UserError(fmt::format("gnuplot draws the curves of {}, and {}", result.experiment->name,
                              drawing.error ? "cannot be run: " + drawing.error.message() +
                                                  "; install it (in Debian: gnuplot-nox)"
                                            : "failed"));
}

}  // namespace runtime
