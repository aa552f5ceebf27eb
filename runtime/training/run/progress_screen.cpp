#include "runtime/training/run/progress_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <string_view>

#include "base/text/print.h"
#include "base/text/utf8.h"
#include "runtime/training/run/return_statistics.h"

namespace runtime {
namespace {

constexpr std::string_view kBetween = "  ";
constexpr size_t kLeastBar = 8;  // shorter ones say nothing
constexpr size_t kLongestBar = 40;
constexpr size_t kMostTerms = 8;
constexpr size_t kLongestName = 24;

constexpr const char* kHeights[] = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr const char* kEighths[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};

std::string Repeated(std::string_view text, size_t count) {
  std::string repeated;
  for (size_t i = 0; i < count; ++i) repeated += text;
  return repeated;
}

// There is no best return while all episodes have diverged.
std::string BestText(double best_return) {
  return std::isfinite(best_return) ? fmt::format("{:.4g}", best_return) : "none";
}

// Room behind a text for a bar; 0 where that is too short.
size_t RoomBehind(std::string_view text, size_t columns) {
  const size_t used = text::DisplayWidth(text) + kBetween.size();
  const size_t room = columns > used ? std::min(columns - used, kLongestBar) : 0;
  return room < kLeastBar ? 0 : room;
}

// A bar of `width`, of which `part` (0 to 1) is full, in eighths of a character.
std::string FilledBar(double part, size_t width) {
  const double clamped = std::isfinite(part) ? std::clamp(part, 0., 1.) : 0;
  const auto eighths = static_cast<size_t>(std::lround(8 * clamped * static_cast<double>(width)));
  return Repeated("█", eighths / 8) + kEighths[eighths % 8];
}

std::string ProgressBar(double part, size_t width) {
  const std::string bar = FilledBar(part, width);
  return bar + Repeated("░", width - text::DisplayWidth(bar));
}

// From the least to the greatest of the values; level where they are all the same.
std::string SparkLine(const std::vector<double>& values) {
  if (values.empty()) return "";
  const auto [low, high] = std::ranges::minmax(values);
  std::string line;
  for (const double value : values) {
    const double height = high > low ? (value - low) / (high - low) : 0.5;
    line += kHeights[std::clamp(static_cast<int>(8 * height), 0, 7)];
  }
  return line;
}

std::string EpisodesLine(const ProgressValues& values, size_t columns) {
  const double part =
      static_cast<double>(values.episode) / static_cast<double>(values.episodes_planned);
  const auto percent = static_cast<int>(100 * std::clamp(part, 0., 1.));
  const LineField episodes = {fmt::format("episode {}/{}", values.episode, values.episodes_planned),
                              0};
  std::vector<LineField> fields = {episodes,
                                   {fmt::format("{} %", percent), 2},
                                   {fmt::format("{} left", DurationText(values.remaining)), 1}};
  const std::string without = FittingLine(fields, columns);
  const size_t room = RoomBehind(without, columns);
  if (room == 0) return without;
  fields.insert(fields.begin() + 1, {ProgressBar(part, room), 0});
  return FittingLine(fields, columns);
}

std::string ReturnsLine(const ProgressPicture& picture, size_t columns) {
  const ProgressValues& values = picture.values;
  std::string line =
      FittingLine({{fmt::format("return {:.4g}", values.last_return), 2},
                   {fmt::format("mean of {} {:.4g}", ReturnStatistics::kMeanOver, values.mean), 0},
                   {fmt::format("best {}", BestText(values.best_return)), 1}},
                  columns);
  const size_t room = RoomBehind(line, columns);
  if (room == 0) return line;
  return line.append(kBetween).append(SparkLine(picture.history.Means(room)));
}

std::string SpeedLine(const ProgressValues& values, size_t columns) {
  return FittingLine({{fmt::format("{:.1f}x real time", values.simulated_seconds_per_second), 0},
                      {fmt::format("{} elapsed", DurationText(values.elapsed)), 1}},
                     columns);
}

// The `count` terms that are worth most, in their own order.
std::vector<TermMean> Largest(const std::vector<TermMean>& terms, size_t count) {
  std::vector<size_t> order(terms.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater{}, [&](size_t i) {
    return std::isfinite(terms[i].mean) ? std::abs(terms[i].mean) : -1;
  });
  order.resize(std::min(count, order.size()));
  std::ranges::sort(order);
  std::vector<TermMean> largest;
  for (const size_t i : order) largest.push_back(terms[i]);
  return largest;
}

// A name that is too long without its end.
std::string ShortName(const std::string& name) {
  if (text::DisplayWidth(name) <= kLongestName || name.size() <= kLongestName) return name;
  return name.substr(0, kLongestName - 1) + "…";
}

// A line for each term: its name, its mean and a bar, all bars to the same scale.
std::vector<std::string> TermLines(const std::vector<TermMean>& terms, size_t columns) {
  size_t name_width = 0;
  size_t number_width = 0;
  double most = 0;
  for (const TermMean& term : terms) {
    name_width = std::max<size_t>(name_width, text::DisplayWidth(ShortName(term.name)));
    number_width = std::max(number_width, fmt::format("{:.4g}", term.mean).size());
    if (std::isfinite(term.mean)) most = std::max(most, std::abs(term.mean));
  }
  std::vector<std::string> lines;
  for (const TermMean& term : terms) {
    std::string line = fmt::format("  {:<{}}  {:>{}.4g}", ShortName(term.name), name_width,
                                   term.mean, number_width);
    if (text::DisplayWidth(line) > columns) continue;
    if (const size_t room = RoomBehind(line, columns); room > 0 && most > 0) {
      const double part = std::abs(term.mean) / most;
      const auto full = static_cast<size_t>(std::lround(part * static_cast<double>(room)));
      const std::string bar = term.mean < 0 ? Repeated("▒", full) : FilledBar(part, room);
      if (!bar.empty()) line.append(kBetween).append(bar);
    }
    lines.push_back(line);
  }
  return lines;
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

std::string ProgressScreen(const ProgressPicture& picture, size_t columns, size_t rows) {
  // In the order in which they get rows; terms get what is left.
  const std::string returns = rows > 1 ? ReturnsLine(picture, columns) : "";
  const std::string speed = rows > 2 ? SpeedLine(picture.values, columns) : "";
  const size_t room = std::min(rows > 3 ? rows - 3 : 0, kMostTerms);
  std::vector<std::string> lines = {EpisodesLine(picture.values, columns), returns};
  std::ranges::move(TermLines(Largest(picture.terms, room), columns), std::back_inserter(lines));
  lines.push_back(speed);
  std::string screen;
  for (const std::string& line : lines) {
    if (!line.empty()) screen += line + "\n";
  }
  return screen;
}

}  // namespace runtime
