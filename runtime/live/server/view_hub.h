// What is seen of the robot, on its way to those who watch. Nothing piles up: who does not keep up
// sees fewer frames.
#pragma once

#include <mutex>
#include <optional>
#include <set>

#include "runtime/live/control/request.h"

namespace runtime {

// One of those who watch.
class Viewer {
 public:
  virtual ~Viewer() = default;
  virtual ViewWish wish() const = 0;
  virtual void Take(const ViewFrame& frame) = 0;
};

class ViewHub {
 public:
  // `source` is told what is wanted, and outlives this object.
  explicit ViewHub(RequestHandler& source) : source_(source) {}

  // Any thread. Returns whether Deliver() must be called, because nothing was waiting before.
  bool Put(const ViewFrame& frame);

  // These on one thread.
  void Add(Viewer& viewer);
  void Remove(Viewer& viewer);
  // What one of the viewers wants has changed.
  void Renew();
  void Deliver();

 private:
  RequestHandler& source_;
  std::mutex mutex_;
  // The last ones that were put and not delivered yet; guarded by mutex_.
  std::optional<ViewFrame> instant_;
  std::optional<ViewFrame> episode_;
  std::set<Viewer*> viewers_;
};

}  // namespace runtime
