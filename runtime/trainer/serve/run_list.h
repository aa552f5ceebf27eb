// All runs in a folder, whoever trains them, as a page shows them.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "runtime/live/workers/supervisor.h"
#include "runtime/trainer/serve/courier.h"
#include "runtime/trainer/serve/listed_run.h"

namespace runtime {

// All is called on one thread.
class RunList {
 public:
  // `courier` outlives this object.
  RunList(std::filesystem::path folder, Courier& courier)
      : folder_(std::move(folder)), courier_(courier) {}

  // What is read of a run is at most a second old. `started`: those that a supervisor looks after,
  // which need not be runs yet.
  nlohmann::json ToJson(const std::vector<RunProgress>& started);
  // Throws UserError where there is no such run.
  ListedRun& Find(const std::string& name);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  using Clock = std::chrono::steady_clock;

  // What trainers have said of themselves, on the thread of the courier.
  struct Heard {
    std::mutex mutex;
    std::map<std::string, nlohmann::json> statuses;  // by the run's name
    std::set<std::string> asked;                     // who has not answered yet
  };

  void Refresh();
  void LookForRuns();
  void AskForStatus(const std::string& name, const ListedRun& run);
  nlohmann::json JsonOf(const std::string& name, const ListedRun& run) const;

  const std::filesystem::path folder_;
  Courier& courier_;
  std::map<std::string, ListedRun> runs_;  // by name: that of the folder, as seen from this one
  std::vector<std::string> order_;
  Clock::time_point refreshed_at_;
  const std::shared_ptr<Heard> heard_ = std::make_shared<Heard>();
};

}  // namespace runtime
