#include "runtime/trainer/train/prepare_runs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "runtime/trainer/runs/many_runs.h"
#include "runtime/trainer/setup/create_run.h"
#include "runtime/trainer/train/run_difference.h"
#include "runtime/training/run/run_database.h"

namespace runtime {
namespace {

void TakeOver(const std::filesystem::path& folder, const RunRecord& wanted,
              const std::string& place, const std::string& remedy) {
  const RunRecord run = RunDatabase::OpenToRead(folder).ReadRun();
  const std::vector<std::string> differences = DifferencesOf(run, wanted);
  if (!differences.empty()) {
    throw UserError(fmt::format("{}: {} holds a run that differs from this one: {}; {}", place,
                                folder.string(), fmt::join(differences, ", "), remedy));
  }
  if (run.episodes_planned < wanted.episodes_planned) {
    RunDatabase::Open(folder).SetEpisodesPlanned(wanted.episodes_planned);
  }
}

}  // namespace

std::vector<std::filesystem::path> PrepareRuns(const TaskSetup& setup, const RunRecord& run,
                                               const std::vector<uint64_t>& seeds,
                                               const std::filesystem::path& folder,
                                               const std::string& place,
                                               const std::string& remedy) {
  std::vector<std::filesystem::path> folders;
  for (const uint64_t seed : seeds) {
    const std::filesystem::path each = folders.emplace_back(SeedFolder(folder, seed));
    if (RunDatabase::Exists(each)) {
      TakeOver(each, run, place, remedy);
    } else {
      PrepareRun(each, setup, run, seed);
    }
  }
  return folders;
}

}  // namespace runtime
