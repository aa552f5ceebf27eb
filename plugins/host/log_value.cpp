#include "plugins/host/log_value.h"

#include <limits>

namespace host {

double LogValue(int reduction, const taskc_log_state& state) {
  if (reduction == TASKC_SUM) return state.sum;
  if (state.count == 0) return std::numeric_limits<double>::quiet_NaN();
  switch (reduction) {
    case TASKC_MAX:
      return state.maximum;
    case TASKC_MIN:
      return state.minimum;
    case TASKC_MEAN:
      return state.sum / static_cast<double>(state.count);
    default:
      return state.last;
  }
}

}  // namespace host
