#pragma once

#include <taskc/plugin.h>

namespace host {

// The one number of an episode that a log gives with its reduction (TASKC_LAST ... TASKC_MEAN). Not
// a number where nothing was logged; the sum of nothing is 0.
double LogValue(int reduction, const taskc_log_state& state);

}  // namespace host
