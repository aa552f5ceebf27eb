// What a run had learned at a checkpoint, acting in some profile without learning on: the file
// evaluation-PROFILE.json in the run's folder (docs/trainer.md), evaluation.json where its
// environment has no profiles.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace runtime {

struct PolicyEvaluation {
  std::string profile;  // "": the environment has none
  std::string learned_profile;
  std::string version;  // of the trainer
  int64_t checkpoint_episode = 0;
  std::string checkpoint;            // StateHash() of its state
  std::vector<double> returns = {};  // of the episodes, at least one
  double mean_return = 0;
  // Over the last episodes up to the checkpoint (learning.h), in which the run still learned.
  double learned_return = 0;
  std::map<std::string, int64_t> ends = {};  // how many episodes ended so, by the kind of their end
  std::map<std::string, double> metrics;
  std::map<std::string, double> learned_metrics;

  // Of the learned return; not a number where that is not above 0.
  double share() const;
};

// Part of what was paid that is paid still; not a number where nothing was.
double ShareThatRemains(double paid, double learned);

nlohmann::ordered_json ToJson(const PolicyEvaluation& evaluation);

// All that are in a run's folder, by the names of their profiles. What cannot be read is left out;
// `notes` gets a sentence about it.
std::vector<PolicyEvaluation> ReadEvaluations(const std::filesystem::path& run,
                                              std::vector<std::string>& notes);

// All functions below throw UserError.

std::filesystem::path EvaluationFile(const std::filesystem::path& run, const std::string& profile);
PolicyEvaluation ReadEvaluation(const std::filesystem::path& file);
void WriteEvaluation(const std::filesystem::path& run, const PolicyEvaluation& evaluation);

}  // namespace runtime
