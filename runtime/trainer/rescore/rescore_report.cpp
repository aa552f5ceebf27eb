#include "runtime/trainer/rescore/rescore_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

std::string EndText(const Judgment& judgment) {
  return fmt::format("{:.2f} s: {}{}{}", judgment.end_time, judgment.end_kind,
                     judgment.end_reason.empty() ? "" : ", ", judgment.end_reason);
}

std::string DifferenceText(const RescoredEpisode& episode) {
  const auto& difference = episode.first_difference;
  return difference ? fmt::format("{:.3f} s: {}", difference->time, difference->what) : "none";
}

std::string CorrelationText(const RankCorrelation& order) {
  if (std::isnan(order.spearman)) return "cannot be told";
  return fmt::format("Spearman {:.3f}, Kendall {:.3f}", order.spearman, order.kendall);
}

std::map<std::string, double> MeanTerms(const RescoredRun& run) {
  std::map<std::string, double> means;
  for (const RescoredEpisode& episode : run.episodes)
    for (const auto& [term, sum] : episode.new_task.terms)
      means[term] += sum / static_cast<double>(run.episodes.size());
  return means;
}

std::string RunText(const RescoredRun& run) {
  size_t width = std::string_view("rescored").size();  // of the ends
  for (const RescoredEpisode& episode : run.episodes)
    width = std::max({width, EndText(episode.old_task).size(), EndText(episode.new_task).size()});
  std::string text = fmt::format("{} ({}, {})\n  {:>8} {:>12} {:>12}  {:<{}}  {:<{}}  {}\n",
                                 run.name, run.task, run.profile, "episode", "return", "rescored",
                                 "ended", width, "rescored", width, "differ from");
  for (const RescoredEpisode& episode : run.episodes) {
    text += fmt::format("  {:>8} {:>12.4f} {:>12.4f}  {:<{}}  {:<{}}  {}\n", episode.number,
                        episode.recorded_return, episode.new_task.episode_return,
                        EndText(episode.old_task), width, EndText(episode.new_task), width,
                        DifferenceText(episode));
  }
  text +=
      fmt::format("  {:>8} {:>12.4f} {:>12.4f}\n", "mean", run.recorded_return(), run.new_return());
  for (const auto& [term, mean] : MeanTerms(run))
    text += fmt::format("  {:>21} {:>12.4f}\n", term, mean);
  if (run.episodes.size() > 1)
    text += fmt::format("  order of the episodes: {}\n", CorrelationText(OrderOf(run)));
  for (const std::string& why : run.left_out) text += fmt::format("  left out: {}\n", why);
  return text;
}

struct Ranks {
  std::vector<double> old_ranks;
  std::vector<double> new_ranks;
};

Ranks RanksOfRuns(const std::vector<RescoredRun>& runs) {
  std::vector<double> old_returns, new_returns;
  for (const RescoredRun& run : runs) {
    old_returns.push_back(run.recorded_return());
    new_returns.push_back(run.new_return());
  }
  return {RanksOf(old_returns), RanksOf(new_returns)};
}

std::string RankingText(const std::vector<RescoredRun>& runs) {
  const auto [old_ranks, new_ranks] = RanksOfRuns(runs);
  size_t width = 3;
  for (const RescoredRun& run : runs) width = std::max(width, run.name.size());
  std::string text = fmt::format("{:<{}} {:>12} {:>6} {:>12} {:>6}\n", "run", width, "return",
                                 "rank", "rescored", "rank");
  for (size_t i = 0; i < runs.size(); ++i) {
    text +=
        fmt::format("{:<{}} {:>12.4f} {:>6g} {:>12.4f} {:>6g}\n", runs[i].name, width,
                    runs[i].recorded_return(), old_ranks[i], runs[i].new_return(), new_ranks[i]);
  }
  return text + fmt::format("order of the runs: {}\n", CorrelationText(OrderOf(runs)));
}

Json ToJson(const Judgment& judgment) {
  return {{"return", judgment.episode_return}, {"end_kind", judgment.end_kind},
          {"end_reason", judgment.end_reason}, {"end_time", judgment.end_time},
          {"terms", judgment.terms},           {"metrics", judgment.metrics}};
}

Json ToJson(const RescoredEpisode& episode) {
  Json json = {{"episode", episode.number},
               {"recorded_return", episode.recorded_return},
               {"old", ToJson(episode.old_task)},
               {"new", ToJson(episode.new_task)},
               {"first_difference", nullptr}};
  if (episode.first_difference)
    json["first_difference"] = {{"time", episode.first_difference->time},
                                {"what", episode.first_difference->what}};
  return json;
}

Json ToJson(const RankCorrelation& order) {
  const auto number = [](double value) { return std::isnan(value) ? Json() : Json(value); };
  return {{"spearman", number(order.spearman)}, {"kendall", number(order.kendall)}};
}

// What the numbers do not say: a sentence each.
std::vector<std::string> RescoreCaveats() {
  return {
      "the behavior was learned for the old task: what would be learned for the new one is "
      "another question",
      "what comes after a recorded episode's end is not seen: a task that would end later is "
      "judged up to there",
      "both tasks have the defaults of their params, draw their goals as in a run with this "
      "seed, and begin with the memory of a new run; what was changed meanwhile is not repeated"};
}

}  // namespace

std::string RescoreText(const std::string& new_task, const std::vector<RescoredRun>& runs) {
  std::string text = fmt::format("rescored by {}\n\n", new_task);
  for (const RescoredRun& run : runs) text += RunText(run) + "\n";
  if (runs.size() > 1) text += RankingText(runs) + "\n";
  for (const std::string& caveat : RescoreCaveats()) text += "note: " + caveat + "\n";
  return text;
}

Json RescoreJson(const std::string& new_task, const std::vector<RescoredRun>& runs) {
  Json json = {{"task", new_task}, {"runs", Json::array()}, {"order", ToJson(OrderOf(runs))}};
  const auto [old_ranks, new_ranks] = RanksOfRuns(runs);
  for (size_t i = 0; i < runs.size(); ++i) {
    const RescoredRun& run = runs[i];
    Json& entry = json["runs"].emplace_back(Json{{"run", run.name},
                                                 {"task", run.task},
                                                 {"profile", run.profile},
                                                 {"recorded_return", run.recorded_return()},
                                                 {"recorded_rank", old_ranks[i]},
                                                 {"new_return", run.new_return()},
                                                 {"new_rank", new_ranks[i]},
                                                 {"order", ToJson(OrderOf(run))},
                                                 {"episodes", Json::array()},
                                                 {"left_out", run.left_out}});
    for (const RescoredEpisode& episode : run.episodes)
      entry["episodes"].push_back(ToJson(episode));
  }
  json["caveats"] = RescoreCaveats();
  return json;
}

}  // namespace runtime
