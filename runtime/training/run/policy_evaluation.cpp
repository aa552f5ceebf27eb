#include "runtime/training/run/policy_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "runtime/base/user_error.h"
#include "runtime/training/run/estimate.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view kPrefix = "evaluation";
constexpr std::string_view kSuffix = ".json";
// What is not a number is null in JSON.
double Number(const OrderedJson& json) { return json.is_null() ? kNoNumber : json.get<double>(); }

std::map<std::string, double> Numbers(const OrderedJson& json) {
  std::map<std::string, double> numbers;
  for (const auto& [name, value] : json.items()) numbers[name] = Number(value);
  return numbers;
}

PolicyEvaluation FromJson(const OrderedJson& json) {
  PolicyEvaluation evaluation;
  json.at("profile").get_to(evaluation.profile);
  json.at("learned_profile").get_to(evaluation.learned_profile);
  json.at("version").get_to(evaluation.version);
  json.at("checkpoint_episode").get_to(evaluation.checkpoint_episode);
  json.at("checkpoint").get_to(evaluation.checkpoint);
  for (const OrderedJson& value : json.at("returns")) evaluation.returns.push_back(Number(value));
  evaluation.mean_return = Number(json.at("return"));
  evaluation.learned_return = Number(json.at("learned_return"));
  json.at("ends").get_to(evaluation.ends);
  evaluation.metrics = Numbers(json.at("metrics"));
  evaluation.learned_metrics = Numbers(json.at("learned_metrics"));
  return evaluation;
}

}  // namespace

double PolicyEvaluation::share() const { return ShareThatRemains(mean_return, learned_return); }

double ShareThatRemains(double paid, double learned) {
  return learned > 0 ? paid / learned : kNoNumber;
}

OrderedJson ToJson(const PolicyEvaluation& evaluation) {
  return {{"profile", evaluation.profile},
          {"learned_profile", evaluation.learned_profile},
          {"version", evaluation.version},
          {"episodes", evaluation.returns.size()},
          {"checkpoint_episode", evaluation.checkpoint_episode},
          {"checkpoint", evaluation.checkpoint},
          {"returns", evaluation.returns},
          {"return", evaluation.mean_return},
          {"learned_return", evaluation.learned_return},
          {"share", evaluation.share()},
          {"ends", evaluation.ends},
          {"metrics", evaluation.metrics},
          {"learned_metrics", evaluation.learned_metrics}};
}

std::vector<PolicyEvaluation> ReadEvaluations(const std::filesystem::path& run,
                                              std::vector<std::string>& notes) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(run, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kPrefix) && name.ends_with(kSuffix)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<PolicyEvaluation> evaluations;
  for (const std::filesystem::path& file : files) {
    try {
      evaluations.push_back(ReadEvaluation(file));
    } catch (const UserError& problem) {
      notes.push_back(fmt::format("An evaluation is left out: {}.", problem.what()));
    }
  }
  return evaluations;
}

std::filesystem::path EvaluationFile(const std::filesystem::path& run, const std::string& profile) {
  return run / fmt::format("{}{}{}{}", kPrefix, profile.empty() ? "" : "-", profile, kSuffix);
}

PolicyEvaluation ReadEvaluation(const std::filesystem::path& file) {
  try {
    return FromJson(OrderedJson::parse(ReadText(file)));
  } catch (const OrderedJson::exception& error) {
    throw UserError(
        fmt::format("{}: this is not an evaluation of a run ({}); delete it, and evaluate "
                    "the run again with `trainer evaluate`",
                    file.string(), error.what()));
  }
}

void WriteEvaluation(const std::filesystem::path& run, const PolicyEvaluation& evaluation) {
  WriteFile(EvaluationFile(run, evaluation.profile), ToJson(evaluation).dump(2) + "\n");
}

}  // namespace runtime
