// The actions of DCOB as numbers: with n intervals, action a is unit a / n of a net at the pace
// a mod n.
#pragma once

#include <string>
#include <vector>

namespace runtime {

class DcobActions {
 public:
  DcobActions() = default;
  // `module`: who has them, for messages. Throws UserError where an interval is not above 0, or
  // there is none.
  DcobActions(const std::string& module, std::vector<double> intervals, int units);

  int count() const { return count_; }
  int UnitOf(int action) const { return action / static_cast<int>(intervals_.size()); }
  // [s/rad], or [s] for each unit of whatever moves
  double IntervalOf(int action) const {
    return intervals_[static_cast<size_t>(action) % intervals_.size()];
  }
  // Throw UserError.
  void CheckAction(const std::string& module, int action) const;
  static void CheckFeatures(const std::string& module, long features, int units);

 private:
  std::vector<double> intervals_;
  int count_ = 0;
};

}  // namespace runtime
