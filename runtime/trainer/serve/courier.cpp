#include "runtime/trainer/serve/courier.h"

#include <utility>

#include "runtime/live/client/client.h"

namespace runtime {
namespace {

Reply AskTrainer(const std::filesystem::path& run, const Request& request) {
  try {
    return Ask(run, request);
  } catch (const std::exception& error) {
    return {false, {}, error.what()};
  }
}

}  // namespace

Courier::Courier() : thread_([this](const std::stop_token& stop) { Run(stop); }) {}

Courier::~Courier() {
  thread_.request_stop();
  thread_.join();
  for (const Question& question : questions_) question.reply({false, {}, "the trainer has ended"});
}

void Courier::Send(std::filesystem::path run, Request request, ReplyHandler reply) {
  const std::lock_guard lock(mutex_);
  questions_.push_back({std::move(run), std::move(request), std::move(reply)});
  changed_.notify_one();
}

void Courier::Run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !questions_.empty(); })) {
    const Question question = std::move(questions_.front());
    questions_.pop_front();
    lock.unlock();
    question.reply(AskTrainer(question.run, question.request));
    lock.lock();
    if (stop.stop_requested()) return;
  }
}

}  // namespace runtime
