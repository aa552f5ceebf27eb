// Lets people watch the episodes of a run, at no cost while nobody does.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/live/control/request.h"
#include "runtime/live/control/view_layout.h"
#include "runtime/training/run/episode_watcher.h"

namespace runtime {

// Where episodes are run side by side it looks at those of one collector.
class LiveView : public EpisodeWatcher {
 public:
  // `context` outlives this object.
  explicit LiveView(const Context& context) : context_(context) {}

  // Null, or an object that outlives this one. Before the training begins.
  void ShowTo(EventSink* sink) { sink_ = sink; }

  // Any thread. What is wanted from now on.
  void Wish(const ViewWish& wish);

  void BreakOff(const Environment& environment) override;

 private:
  // An episode that is kept until it is over.
  struct Kept {
    int64_t episode = 0;
    int64_t steps_per_frame = 1;
    int64_t last_step = -1;
    std::vector<float> frames;
  };

  void Look(int64_t episode, int64_t steps, const EpisodeModules& modules) override;
  // Whether it is this environment's episode that is looked at.
  bool Claim(const Environment& environment, int64_t steps, std::chrono::nanoseconds now);
  void RefreshLayout(const EpisodeModules& modules);
  void ShowInstant(int64_t episode, int64_t steps, const EpisodeModules& modules);
  void StartEpisode(int64_t episode, const EpisodeModules& modules);
  void KeepFrame(int64_t steps, const EpisodeModules& modules);
  void ShowEpisode(int64_t steps, const EpisodeModules& modules);
  void Show(bool is_episode, std::string content);

  const Context& context_;
  EventSink* sink_ = nullptr;

  std::mutex mutex_;  // guards all of the following
  ViewWish wish_;
  const Environment* looked_at_ = nullptr;
  std::chrono::nanoseconds last_look_{};  // of the monotonic clock
  std::chrono::nanoseconds last_instant_{};
  std::optional<ViewLayout> layout_;
  std::shared_ptr<const std::string> layout_text_;
  std::optional<Kept> kept_;
};

}  // namespace runtime
