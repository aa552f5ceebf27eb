#include "runtime/trainer/engines/slurm_jobs.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "runtime/base/user_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

std::filesystem::path JobsFile(const std::filesystem::path& folder) {
  return SlurmFolder(folder) / "jobs.json";
}

}  // namespace

std::filesystem::path SlurmFolder(const std::filesystem::path& folder) { return folder / "slurm"; }

std::vector<SlurmArray> ReadSlurmArrays(const std::filesystem::path& folder) {
  const std::filesystem::path file = JobsFile(folder);
  std::vector<SlurmArray> arrays;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return arrays;
  try {
    for (const nlohmann::json& array : nlohmann::json::parse(ReadText(file))) {
      arrays.push_back({array.at("job"), array.at("runs")});
    }
  } catch (const nlohmann::json::exception& error) {
    throw UserError(
        fmt::format("{}: damaged: {}; remove it: jobs that are in the queue are then "
                    "not known to be of this study",
                    file.string(), error.what()));
  }
  return arrays;
}

void AddSlurmArray(const std::filesystem::path& folder, const SlurmArray& array) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::vector<SlurmArray> arrays = ReadSlurmArrays(folder);
  arrays.push_back(array);
  for (const SlurmArray& each : arrays) json.push_back({{"job", each.job}, {"runs", each.runs}});
  WriteFile(JobsFile(folder), json.dump(1) + "\n");
}

}  // namespace runtime
