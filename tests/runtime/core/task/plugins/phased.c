// A task with phases: its time steps go from `reach` to `lift` and stay there. Each pays 1.
#include "phased.h"

static const taskc_phase phases[] = {{"reach", "get there", {0, 1}}, {"lift", "", {0, 2}}};

PHASED(.name = "phased", .phases = phases, .phase_count = 2)
