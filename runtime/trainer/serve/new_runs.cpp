#include "runtime/trainer/serve/new_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"
#include "runtime/trainer/runs/many_runs.h"
#include "runtime/training/run/run_database.h"
#include "runtime/training/simulation/profile.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

int64_t WholeIn(const Json& arguments, const char* name, int64_t usual, int64_t least,
                int64_t most) {
  const int64_t value = arguments.value(name, usual);
  if (value >= least && value <= most) return value;
  throw UserError(
      fmt::format("`{}` must lie in {} .. {}, and {} does not", name, least, most, value));
}

void CheckProfile(const std::string& profile) {
  std::vector<std::string> names;
  for (const Profile& each : kProfiles) names.emplace_back(each.name);
  if (profile.empty() || std::ranges::find(names, profile) != names.end()) return;
  throw UserError(fmt::format("there is no profile `{}`{}", profile, Suggestion(profile, names)));
}

// A folder in the one that is served, and nowhere else.
void CheckName(const std::filesystem::path& name) {
  const bool is_inside =
      name.is_relative() && !name.empty() && std::ranges::none_of(name, [](const auto& part) {
        return part.empty() || part == ".." || part == ".";
      });
  if (is_inside) return;
  throw UserError(fmt::format("`{}` is no name of a folder in this one", name.string()));
}

std::filesystem::path TaskIn(const Json& arguments) {
  std::filesystem::path task = arguments.at("task").get<std::string>();
  const auto end = task.extension();
  if (end != ".task" && end != ".so") {
    throw UserError(fmt::format("`{}` is no .task file", task.string()));
  }
  task = std::filesystem::absolute(task);
  if (std::filesystem::is_regular_file(task)) return task;
  throw UserError(fmt::format("{}: there is no such file", task.string()));
}

}  // namespace

std::vector<NewRun> NewRuns(const Json& arguments, const std::filesystem::path& folder,
                            const std::filesystem::path& robots) {
  const std::filesystem::path task = TaskIn(arguments);
  const std::string profile = arguments.value("profile", "");
  CheckProfile(profile);
  const int64_t episodes = WholeIn(arguments, "episodes", 1000, 1, 1'000'000'000);
  const int64_t first = WholeIn(arguments, "seed", 0, 0, int64_t{1} << 53);
  const int64_t runs = WholeIn(arguments, "runs", 1, 1, 1000);
  std::string name = arguments.value("name", "");
  if (name.empty()) name = task.stem().string() + (profile.empty() ? "" : "-" + profile);
  CheckName(name);

  std::vector<std::string> words = {"train",      task.string(),           "--json", "--jobs", "1",
                                    "--episodes", std::to_string(episodes)};
  for (const char* option : {"robot", "agent", "profile"}) {
    const std::string value = arguments.value(option, "");
    if (!value.empty()) words.push_back(fmt::format("--{}={}", option, value));
  }
  if (!robots.empty()) words.push_back("--robots=" + robots.string());

  std::vector<NewRun> made;
  for (int64_t seed = first; seed < first + runs; ++seed) {
    const std::filesystem::path run = SeedFolder(folder / name, static_cast<uint64_t>(seed));
    RunDatabase::CheckIsFree(run);
    NewRun& each = made.emplace_back();
    each.progress = {run, run.lexically_relative(folder).string()};
    each.progress.episodes_planned = episodes;
    each.words = words;
    each.words.insert(each.words.end(), {"--seed", std::to_string(seed), "--out", run.string()});
  }
  return made;
}

}  // namespace runtime
