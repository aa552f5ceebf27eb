#include "runtime/live/server/view_hub.h"

#include <utility>

namespace runtime {

bool ViewHub::Put(const ViewFrame& frame) {
  const std::lock_guard lock(mutex_);
  const bool was_empty = !instant_ && !episode_;
  (frame.is_episode ? episode_ : instant_) = frame;
  return was_empty;
}

void ViewHub::Add(Viewer& viewer) {
  viewers_.insert(&viewer);
  Renew();
}

void ViewHub::Remove(Viewer& viewer) {
  if (viewers_.erase(&viewer) > 0) Renew();
}

void ViewHub::Renew() {
  ViewWish all;
  for (const Viewer* viewer : viewers_) {
    all.instants |= viewer->wish().instants;
    all.episode |= viewer->wish().episode;
  }
  source_.Watch(all);
}

void ViewHub::Deliver() {
  std::optional<ViewFrame> frames[2];
  {
    const std::lock_guard lock(mutex_);
    std::swap(frames[0], instant_);
    std::swap(frames[1], episode_);
  }
  for (const std::optional<ViewFrame>& frame : frames) {
    if (!frame) continue;
    for (Viewer* viewer : viewers_) viewer->Take(*frame);
  }
  if (frames[1]) Renew();  // who has an episode wants none until it says so
}

}  // namespace runtime
