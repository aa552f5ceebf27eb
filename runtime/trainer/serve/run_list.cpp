#include "runtime/trainer/serve/run_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/suggestion.h"
#include "runtime/base/user_error.h"
#include "runtime/live/workers/run_table.h"
#include "runtime/trainer/runs/many_runs.h"

namespace runtime {
namespace {

using Json = nlohmann::json;

constexpr std::chrono::milliseconds kBetweenReadings{900};

// Of a run that is only about to be one, or that could not be made.
Json JsonOf(const RunProgress& run) {
  const bool is_made = run.state == RunProgressState::kRunning;
  return {{"name", run.name},
          {"state", is_made ? "starting" : std::string(NameOf(run.state))},
          {"failure", run.failure},
          {"episodes", 0},
          {"episodes_planned", run.episodes_planned},
          {"sparkline", Json::array()},
          {"address", ""}};
}

}  // namespace

Json RunList::ToJson(const std::vector<RunProgress>& started) {
  Refresh();
  std::map<std::string, Json> entries;
  for (const auto& [name, run] : runs_) entries[name] = JsonOf(name, run);
  std::vector<std::string> order = order_;
  for (const RunProgress& run : started) {
    const auto known = entries.find(run.name);
    if (known == entries.end()) {
      order.push_back(run.name);
      entries[run.name] = runtime::JsonOf(run);
    } else if (run.state == RunProgressState::kWaiting || run.state == RunProgressState::kFailed) {
      known->second["state"] = NameOf(run.state);
      known->second["failure"] = run.failure;
    }
  }
  Json list = Json::array();
  for (const std::string& name : order) list.push_back(std::move(entries[name]));
  return {{"folder", folder_.string()}, {"runs", std::move(list)}};
}

ListedRun& RunList::Find(const std::string& name) {
  Refresh();
  const auto found = runs_.find(name);
  if (found != runs_.end()) return found->second;
  throw UserError(fmt::format("there is no run `{}` in {}{}", name, folder_.string(),
                              Suggestion(name, order_)));
}

void RunList::Refresh() {
  if (Clock::now() - refreshed_at_ < kBetweenReadings) return;
  LookForRuns();
  for (auto& [name, run] : runs_) {
    run.Refresh();
    if (run.is_trained()) AskForStatus(name, run);
  }
  refreshed_at_ = Clock::now();
}

void RunList::LookForRuns() {
  order_.clear();
  for (const std::filesystem::path& folder : FindRuns(folder_)) {
    const std::string name = folder.lexically_relative(folder_).string();
    order_.push_back(name);
    runs_.try_emplace(name, folder);
  }
  std::erase_if(runs_, [&](const auto& each) {
    return std::ranges::find(order_, each.first) == order_.end();
  });
}

// Whether it is paused only its trainer knows.
void RunList::AskForStatus(const std::string& name, const ListedRun& run) {
  {
    const std::lock_guard lock(heard_->mutex);
    if (!heard_->asked.insert(name).second) return;
  }
  courier_.Send(run.folder(), {"status", Json::object()}, [heard = heard_, name](Reply reply) {
    const std::lock_guard lock(heard->mutex);
    heard->asked.erase(name);
    heard->statuses[name] = reply.ok ? std::move(reply.value) : Json();
  });
}

Json RunList::JsonOf(const std::string& name, const ListedRun& run) const {
  Json json = run.ToJson();
  json["name"] = name;
  if (!run.is_trained()) return json;
  const std::lock_guard lock(heard_->mutex);
  const auto status = heard_->statuses.find(name);
  if (status == heard_->statuses.end() || !status->second.is_object()) return json;
  json["state"] = status->second.at("state");
  if (json["state"] != "running") json["seconds_left"] = nullptr;
  return json;
}

}  // namespace runtime
