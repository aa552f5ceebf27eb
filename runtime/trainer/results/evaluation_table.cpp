#include "runtime/trainer/results/evaluation_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace runtime {
namespace {

std::string NumberText(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.2f}", value);
}

std::string ShareText(double share) {
  return std::isnan(share) ? "-" : fmt::format("{:.0f} %", 100 * share);
}

// "2 success, 1 truncated"
std::string EndsText(const PolicyEvaluation& evaluation) {
  std::string text;
  for (const auto& [kind, count] : evaluation.ends) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, kind);
  }
  return text;
}

class Table {
 public:
  Table(size_t width, const std::string& profile) : width_(width) {
    Add("run", "learned", profile, "remains", "ended");
  }

  void Add(const std::string& name, double learned, double value, const std::string& ended) {
    Add(name, NumberText(learned), NumberText(value), ShareText(ShareThatRemains(value, learned)),
        ended);
  }

  const std::string& text() const { return text_; }

 private:
  void Add(const std::string& name, const std::string& learned, const std::string& value,
           const std::string& share, const std::string& ended) {
    std::string line =
        fmt::format("{:<{}}  {:>9}  {:>10}  {:>7}  {}", name, width_, learned, value, share, ended);
    line.erase(line.find_last_not_of(' ') + 1);
    text_ += line + "\n";
  }

  const size_t width_;
  std::string text_;
};

void AddMetrics(const PolicyEvaluation& evaluation, Table& table) {
  for (const auto& [name, value] : evaluation.metrics) {
    const auto learned = evaluation.learned_metrics.find(name);
    if (learned != evaluation.learned_metrics.end()) {
      table.Add("  " + name, learned->second, value, "");
    }
  }
}

}  // namespace

std::string EvaluationTable(const std::vector<NamedEvaluation>& evaluations) {
  size_t width = 8;
  for (const NamedEvaluation& each : evaluations) width = std::max(width, each.run.size());
  Table table(width, evaluations.front().evaluation.profile);
  for (const auto& [run, evaluation] : evaluations) {
    table.Add(run, evaluation.learned_return, evaluation.mean_return, EndsText(evaluation));
  }
  if (evaluations.size() == 1) AddMetrics(evaluations.front().evaluation, table);
  return table.text();
}

}  // namespace runtime
