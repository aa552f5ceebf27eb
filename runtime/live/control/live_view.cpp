#include "runtime/live/control/live_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <span>

namespace runtime {
namespace {

constexpr std::chrono::microseconds kBetweenInstants{33'000};
constexpr double kBetweenFrames = 1.0 / 30;  // [s] of an episode that is kept whole
constexpr double kLongest = 120;             // [s] of it; what comes after that is left out

// Whoever has not been seen for so long has ended, or waits for its turn.
constexpr std::chrono::milliseconds kPatience{500};

// Before the numbers of the frames. Doubles, so that these stay aligned and nothing has to be
// spelled out byte by byte.
struct Header {
  double is_episode = 0;
  double episode = 0;
  double steps = 0;  // at the last frame
  double frames = 1;
  double interval = 0;  // [s] between two frames
  double is_over = 0;
  double time_step = 0;  // [s]
};

std::string Message(const Header& header, std::span<const float> frames) {
  std::string text(sizeof header + frames.size_bytes(), '\0');
  std::memcpy(text.data(), &header, sizeof header);
  std::memcpy(text.data() + sizeof header, frames.data(), frames.size_bytes());
  return text;
}

int64_t StepsPerFrame(double time_step) {
  return std::max<int64_t>(1, std::lround(kBetweenFrames / time_step));
}

// In each time step: to a few milliseconds, in a tenth of the time that the exact one takes.
std::chrono::nanoseconds CoarseNow() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
  return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

}  // namespace

void LiveView::Wish(const ViewWish& wish) {
  const std::lock_guard lock(mutex_);
  wish_ = wish;
  if (!wish.episode) kept_.reset();
  SetWatching(wish.instants || wish.episode);
}

void LiveView::BreakOff(const Environment& environment) {
  const std::lock_guard lock(mutex_);
  if (looked_at_ != &environment) return;
  looked_at_ = nullptr;
  kept_.reset();
}

void LiveView::Look(int64_t episode, int64_t steps, const EpisodeModules& modules) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return;  // another one is being looked at, or somebody says what is wanted
  const std::chrono::nanoseconds now = CoarseNow();
  if (!Claim(modules.environment, steps, now)) return;
  const bool is_over = modules.learner.episode_over();
  if (wish_.instants && now - last_instant_ >= kBetweenInstants) {
    last_instant_ = now;
    ShowInstant(episode, steps, modules);
  }
  if (wish_.episode && steps == 0) StartEpisode(episode, modules);
  if (kept_ && kept_->episode != episode) kept_.reset();
  if (!kept_) return;
  if (is_over || steps % kept_->steps_per_frame == 0) KeepFrame(steps, modules);
  if (kept_ && is_over) ShowEpisode(steps, modules);
}

bool LiveView::Claim(const Environment& environment, int64_t steps, std::chrono::nanoseconds now) {
  if (looked_at_ != &environment) {
    const bool is_free = looked_at_ == nullptr || now - last_look_ > kPatience;
    if (!is_free || (!wish_.instants && steps > 0)) return false;
    looked_at_ = &environment;
    kept_.reset();
  }
  last_look_ = now;
  return true;
}

void LiveView::RefreshLayout(const EpisodeModules& modules) {
  if (layout_ && layout_->Fits(modules)) return;
  kept_.reset();  // its numbers are of another task
  layout_.emplace(modules, context_);
  layout_text_ = std::make_shared<const std::string>(layout_->json());
}

void LiveView::ShowInstant(int64_t episode, int64_t steps, const EpisodeModules& modules) {
  RefreshLayout(modules);
  std::vector<float> frame(layout_->size());
  layout_->Write(modules, steps, frame);
  Show(false, Message({.episode = static_cast<double>(episode),
                       .steps = static_cast<double>(steps),
                       .is_over = modules.learner.episode_over() ? 1.0 : 0.0,
                       .time_step = modules.environment.time_step()},
                      frame));
}

// Takes all the memory that the episode will need.
void LiveView::StartEpisode(int64_t episode, const EpisodeModules& modules) {
  RefreshLayout(modules);
  const int64_t steps = StepsPerFrame(modules.environment.time_step());
  kept_.emplace();
  kept_->episode = episode;
  kept_->steps_per_frame = steps;
  const double interval = static_cast<double>(steps) * modules.environment.time_step();
  const auto frames = static_cast<size_t>(kLongest / interval) + 2;
  kept_->frames.reserve(frames * layout_->size());
}

void LiveView::KeepFrame(int64_t steps, const EpisodeModules& modules) {
  RefreshLayout(modules);
  if (!kept_ || steps == kept_->last_step) return;
  std::vector<float>& frames = kept_->frames;
  if (frames.size() + layout_->size() > frames.capacity()) return;
  kept_->last_step = steps;
  frames.resize(frames.size() + layout_->size());
  layout_->Write(modules, steps, std::span(frames).last(layout_->size()));
}

void LiveView::ShowEpisode(int64_t steps, const EpisodeModules& modules) {
  const double time_step = modules.environment.time_step();
  Show(true, Message({.is_episode = 1,
                      .episode = static_cast<double>(kept_->episode),
                      .steps = static_cast<double>(steps),
                      .frames = static_cast<double>(kept_->frames.size() / layout_->size()),
                      .interval = static_cast<double>(kept_->steps_per_frame) * time_step,
                      .is_over = 1,
                      .time_step = time_step},
                     kept_->frames));
  kept_.reset();
}

void LiveView::Show(bool is_episode, std::string content) {
  if (sink_ == nullptr) return;
  sink_->Show({.is_episode = is_episode,
               .layout = layout_text_,
               .content = std::make_shared<const std::string>(std::move(content))});
}

}  // namespace runtime
