// Measures the length of the time step, and has nothing to do at its end.
#include "plugin_table.h"

static void end_of_physics_step(taskc_frame* frame) { (void)frame; }
static void measure(taskc_frame* frame) {
  frame->metrics[0] = frame->time_step;
  frame->metrics[1] = frame->time_step;
}

static const taskc_metric metrics[] = {{"duration", "", "s", TASKC_SUM},
                                       {"step", "", "s", TASKC_LAST}};

PLUGIN(.metrics = metrics, .metric_count = 2, .measure = measure,
       .events = {[TASKC_END_OF_PHYSICS_STEP] = end_of_physics_step})
