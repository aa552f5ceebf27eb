// Questions to trainers, on a thread of its own: each answers when it gets round to it.
#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <thread>

#include "runtime/live/control/request.h"

namespace runtime {

class Courier {
 public:
  Courier();
  Courier(const Courier&) = delete;
  Courier& operator=(const Courier&) = delete;
  ~Courier();  // what still waits is refused

  // To the trainer that works in `run`. Returns at once; `reply` is called on another thread, also
  // where no trainer answers.
  void Send(std::filesystem::path run, Request request, ReplyHandler reply);

 private:
  struct Question {
    std::filesystem::path run;
    Request request;
    ReplyHandler reply;
  };

  void Run(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Question> questions_;  // guarded by mutex_
  std::jthread thread_;             // last: it uses the others
};

}  // namespace runtime
