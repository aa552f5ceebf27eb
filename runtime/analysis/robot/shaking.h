// How much joints shake, whatever else they do.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace runtime {

// Follows the joints' speeds in windows of 50 ms. Within one, falling, swinging and braking are
// close to a straight line; what is not is shaking. A blow is over in one window or two, which the
// median does not see.
class Shaking {
 public:
  // `time_step` of the speeds; nothing counts before `from` [s].
  Shaking(size_t joints, double time_step, double from);

  void Add(double time, std::span<const double> rates);
  // The joint that shakes most, and by how much: the median over all windows of the root mean
  // square of what is not a straight line [rad/s]. {-1, 0} where there is no joint or no window.
  std::pair<int, double> Worst() const;

 private:
  // Of one joint in the present window.
  struct Sums {
    double rate = 0, square = 0, moment = 0;
  };
  void EndWindow();

  int window_;  // steps
  double from_;
  int filled_ = 0;
  std::vector<Sums> sums_;
  std::vector<std::vector<double>> shakes_;  // [joint][window]
};

}  // namespace runtime
