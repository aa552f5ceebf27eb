#include "runtime/analysis/study/study_document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "runtime/analysis/study/curve_plot.h"
#include "runtime/analysis/study/figures.h"
#include "runtime/analysis/study/group_strip.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kDocumentName = "README.md";
constexpr int kDocumentStripHeight =
    120;  // [px]: a repository keeps every version of every picture

bool IsNumber(const Json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

// About four significant digits; "–" for what is not a number.
std::string Number(const Json& value) {
  if (!IsNumber(value)) return "–";
  const auto number = value.get<double>();
  const double size = std::abs(number);
  const int decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : 3;
  const std::string sign = number < 0 ? "−" : "";
  if (size != 0 && size < 1e-3) return fmt::format("{}{:.2e}", sign, size);
  return fmt::format("{}{:.{}f}", sign, size, decimals);
}

std::string Whole(const Json& value) {
  return IsNumber(value) ? fmt::format("{:.0f}", value.get<double>()) : "–";
}

// "10.1 … 14.5", or "–" where there are too few runs for it.
std::string Between(const Json& low, const Json& high) {
  if (!IsNumber(low) || !IsNumber(high)) return "–";
  return fmt::format("{} … {}", Number(low), Number(high));
}

std::string Interval(const Json& estimate) { return Between(estimate["low"], estimate["high"]); }
std::string Range(const Json& estimate) { return Between(estimate["least"], estimate["greatest"]); }

std::string Row(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

// The names of the columns, all but the first to the right.
std::string Head(const std::vector<std::string>& names) {
  std::vector<std::string> alignments(names.size(), "---:");
  alignments.front() = "---";
  return Row(names) + Row(alignments);
}

std::string WithUnit(const Json& metric) {
  const std::string name = metric["name"];
  const std::string unit = metric["unit"];
  return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string OverviewRow(const Json& experiment) {
  const std::string name = experiment["name"];
  const Json& final_return = experiment["final_return"];
  return Row({fmt::format("[{}](#{})", name, name), Whole(final_return["count"]),
              Number(final_return["mean"]), Interval(final_return), Range(final_return),
              Number(experiment["best_return"]["greatest"]),
              Whole(experiment["episodes_to_80_percent"]["mean"]),
              Number(experiment["cpu_minutes_to_80_percent"]["mean"]),
              std::to_string(experiment["groups"].size())});
}

std::string Overview(const Json& experiments) {
  std::string text = Head({"experiment", "runs", "final return", "95 %", "least … greatest",
                           "best episode", "episodes to 80 %", "CPU min to 80 %", "groups"});
  for (const Json& experiment : experiments) text += OverviewRow(experiment);
  return text;
}

// What the figures are of, so that they can be made again.
std::string Provenance(const Json& experiment) {
  std::vector<std::string> seeds;
  for (const Json& run : experiment["runs"]) seeds.push_back(run["seed"].dump());
  return fmt::format(
      "Robot `{}`, task `{}` ({}), profile `{}`, {} episodes, seeds {}; taskc {}. Final values are "
      "means of the last {} episodes.\n",
      experiment["robot"].get<std::string>(), experiment["task"].get<std::string>(),
      experiment["task_hash"].get<std::string>().substr(0, 8),
      experiment["profile"].get<std::string>(), experiment["runs"][0]["episodes_planned"].dump(),
      fmt::join(seeds, ", "), experiment["version"].get<std::string>(),
      experiment["mean_over"].dump());
}

// What was set, and how the runs are made again.
std::string Settings(const Json& experiment) {
  std::string text;
  for (const Json& setting : experiment["settings"]) {
    text += fmt::format("{}`{} = {}`", text.empty() ? "\nSettings: " : ", ",
                        setting["name"].get<std::string>(), setting["value"].get<std::string>());
  }
  if (!text.empty()) text += ".\n";
  const std::string command = experiment["command"];
  return command.empty() ? text : text + fmt::format("\n    {}\n", command);
}

std::string KeyFigures(const Json& experiment) {
  std::string text = Head({"", "mean", "95 %", "least … greatest"});
  const auto add = [&](const std::string& name, const Json& estimate) {
    text += Row({name, Number(estimate["mean"]), Interval(estimate), Range(estimate)});
  };
  add("final return", experiment["final_return"]);
  add("best episode", experiment["best_return"]);
  add("episodes to 80 %", experiment["episodes_to_80_percent"]);
  add("CPU minutes to 80 %", experiment["cpu_minutes_to_80_percent"]);
  add("CPU minutes in total", experiment["cpu_minutes"]);
  for (const Json& metric : experiment["metrics"]) add(WithUnit(metric), metric["value"]);
  return text;
}

// A share of 1 as "100 %"; `text` makes the number.
template <class Text>
std::string Percent(const Json& share, Text text) {
  return IsNumber(share) ? text(Json(100 * share.get<double>())) + " %" : "–";
}

std::string Terms(const Json& experiment) {
  std::string text = Head({"term", "per episode", "share"});
  for (const Json& term : experiment["terms"]) {
    text += Row({term["name"], Number(term["value"]["mean"]), Percent(term["share"], Number)});
  }
  return text;
}

// What remains in other profiles; nothing where no run was evaluated.
std::string Evaluations(const Json& experiment) {
  if (experiment["evaluations"].empty()) return "";
  std::string text =
      Head({"without learning, in", "runs", "return", "95 %", "remains", "median of the runs"});
  for (const Json& evaluation : experiment["evaluations"]) {
    const Json& there = evaluation["return"];
    text +=
        Row({evaluation["profile"], Whole(there["count"]), Number(there["mean"]), Interval(there),
             Percent(evaluation["share"], Whole), Percent(evaluation["median_share"], Whole)});
  }
  return text + "\n";
}

std::string Runs(const Json& experiment) {
  std::vector<std::string> names = {
      "seed",    "episodes", "final return", "best", "episodes to 80 %", "CPU min to 80 %",
      "CPU min", "group"};
  for (const Json& metric : experiment["metrics"]) names.push_back(WithUnit(metric));
  std::string text = Head(names);
  for (const Json& run : experiment["runs"]) {
    const Json& group = run["group"];
    std::vector<std::string> cells = {run["seed"].dump(),
                                      run["episodes"].dump(),
                                      Number(run["final_return"]),
                                      Number(run["best_return"]),
                                      Whole(run["episodes_to_80_percent"]),
                                      Number(run["cpu_minutes_to_80_percent"]),
                                      Number(run["cpu_minutes"]),
                                      group.is_null() ? "–" : GroupName(group.get<size_t>())};
    for (const Json& metric : experiment["metrics"]) {
      cells.push_back(Number(run["metrics"].value(metric["name"].get<std::string>(), Json())));
    }
    text += Row(cells);
  }
  return text;
}

std::string SeedsOf(const Json& group, const Json& experiment) {
  std::vector<std::string> seeds;
  for (const Json& run : group["runs"]) {
    seeds.push_back(experiment["runs"][run.get<size_t>()]["seed"].dump());
  }
  return fmt::format("{} {}", seeds.size() == 1 ? "seed" : "seeds", fmt::join(seeds, ", "));
}

std::string GroupText(const Json& group, const Json& experiment) {
  std::string text =
      fmt::format("**Group {}**: {:.0f} % of the runs ({}). ", group["name"].get<std::string>(),
                  100 * group["share"].get<double>(), SeedsOf(group, experiment));
  for (const Json& sentence : group["sentences"]) text += sentence.get<std::string>() + " ";
  text += fmt::format("Final return {}", Number(group["final_return"]["mean"]));
  for (const Json& metric : group["metrics"]) {
    text += fmt::format(", {} {}", WithUnit(metric), Number(metric["value"]["mean"]));
  }
  return text + ".\n";
}

class Document {
 public:
  Document(const StudyResults& results, std::filesystem::path output)
      : results_(results), output_(std::move(output)) {}

  std::filesystem::path Write(const std::string& title) const {
    Json experiments = Json::array();
    for (const ExperimentResult& result : results_.experiments) {
      experiments.push_back(Figures(result, results_.sentences));
    }
    std::string text = fmt::format("# {}\n\n{}\n", title, Overview(experiments));
    for (size_t i = 0; i < experiments.size(); ++i) {
      text += Experiment(results_.experiments[i], experiments[i]);
    }
    for (const std::string& note : results_.notes) text += fmt::format("Note: {}\n\n", note);
    const std::filesystem::path file = output_ / kDocumentName;
    WriteFile(file, text);
    return file;
  }

 private:
  std::string Experiment(const ExperimentResult& result, const Json& experiment) const {
    const std::string name = experiment["name"];
    const Curves curves = CurvesOf(result);
    if (curves.episodes.empty()) return fmt::format("## {}\n\nNo episode yet.\n\n", name);
    const std::string plot = name + ".svg";
    WriteFile(output_ / plot, DrawCurves(result, curves));
    std::string text = fmt::format(
        "## {}\n\n{}\n"
        "![Learning curves: each run in the color of its group, their mean and its 95 % interval]"
        "({})\n\n{}\n{}\n{}",
        name, Provenance(experiment) + Settings(experiment), plot, KeyFigures(experiment),
        Terms(experiment), Evaluations(experiment));
    for (size_t group = 0; group < result.groups.size(); ++group) {
      text += GroupText(experiment["groups"][group], experiment) + "\n";
      text += Strip(result, group, fmt::format("{}-{}.png", name, GroupName(group))) + "\n";
    }
    return text + Runs(experiment) + "\n";
  }

  // Draws the strip of a group to `file` and shows it.
  std::string Strip(const ExperimentResult& result, size_t group, const std::string& file) const {
    const GroupStrip strip = DrawGroupStrip(result, result.groups[group], kDocumentStripHeight);
    WriteFile(output_ / file, strip.png);
    const StudyRun& run = *result.runs[result.groups[group].typical].run;
    return fmt::format("![Group {}: seed {}, episode {}, at {:.2f} s]({})\n", GroupName(group),
                       run.record.seed, strip.episode, fmt::join(strip.times, ", "), file);
  }

  const StudyResults& results_;
  std::filesystem::path output_;
};

}  // namespace

std::filesystem::path WriteStudyDocument(const std::filesystem::path& folder,
                                         const std::vector<std::filesystem::path>& runs,
                                         const std::filesystem::path& output,
                                         const std::string& title) {
  const StudyResults results = ReadStudyResults(folder, runs);
  std::error_code error;
  std::filesystem::create_directories(output, error);
  if (error) {
    throw UserError(fmt::format("{}: cannot be created: {}", output.string(), error.message()));
  }
  return Document(results, output).Write(title.empty() ? results.name : title);
}

}  // namespace runtime
