#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "runtime/live/client/client.h"
#include "runtime/live/server/server.h"

namespace runtime {

// Follows the events of a server for as long as there are any.
class Follower {
 public:
  explicit Follower(std::filesystem::path folder)
      : done_(std::async(std::launch::async, [this, folder = std::move(folder)] {
          FollowEvents(folder, [this](const nlohmann::json& event) { Take(event); });
        })) {}

  // Publishes greetings until the first event comes: from then on nothing is missed.
  void WaitUntilItHears(Server& server) {
    while (!hears_) {
      server.Publish({{"event", "greeting"}});
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  // All but the greetings; the server has ended.
  std::vector<nlohmann::json> Wait() {
    done_.get();
    return events_;
  }

 private:
  void Take(const nlohmann::json& event) {
    hears_ = true;
    if (event["event"] != "greeting") events_.push_back(event);
  }

  std::atomic<bool> hears_ = false;
  std::vector<nlohmann::json> events_;
  std::future<void> done_;
};

}  // namespace runtime
