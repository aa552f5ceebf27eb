// Recorded episodes, in several threads.
#include <taskc/host.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "libtaskc/failure.h"
#include "libtaskc/instance.h"
#include "libtaskc/recorded_episode.h"

namespace libtaskc {
namespace {

using Episodes = std::vector<std::unique_ptr<RecordedEpisode>>;

// All of them before one is evaluated: what is wrong with a recording is said first.
Episodes Prepare(const taskc_instance& like, std::span<const taskc_recording> recordings) {
  Episodes episodes;
  for (const taskc_recording& recording : recordings) {
    try {
      episodes.push_back(std::make_unique<RecordedEpisode>(like.task(), like.episode, recording));
    } catch (const Failure& failure) {
      if (recordings.size() == 1) throw;
      throw Failure(failure.status(),
                    "recording " + std::to_string(episodes.size()) + ": " + failure.what());
    }
  }
  return episodes;
}

class Evaluation {
 public:
  Evaluation(Episodes episodes, taskc_evaluation* evaluations)
      : episodes_(std::move(episodes)), evaluations_(evaluations) {}

  void Run(size_t threads) {
    const size_t others = std::min(threads, episodes_.size()) - 1;  // beside this one
    std::vector<std::jthread> team;
    team.reserve(others);
    try {
      for (size_t i = 0; i < others; ++i) team.emplace_back([this] { Work(); });
    } catch (const std::system_error&) {
      // The machine gives no more threads: those that there are do the work.
    }
    Work();
  }

 private:
  void Work() {
    for (size_t i = next_++; i < episodes_.size(); i = next_++) {
      episodes_[i]->Evaluate(evaluations_[i]);
    }
  }

  Episodes episodes_;
  taskc_evaluation* evaluations_;
  std::atomic<size_t> next_ = 0;
};

}  // namespace
}  // namespace libtaskc

taskc_status taskc_evaluate(const taskc_instance* instance, const taskc_recording* recordings,
                            size_t count, taskc_uint32 threads, taskc_evaluation* evaluations) {
  using namespace libtaskc;
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    if (count == 0) return;
    RequirePointer(recordings, "the recordings");
    RequirePointer(evaluations, "the place for the evaluations");
    const size_t wanted =
        threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
    Evaluation(Prepare(*instance, {recordings, count}), evaluations).Run(wanted);
  });
}
