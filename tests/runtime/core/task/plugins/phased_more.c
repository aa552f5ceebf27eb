// The same phases in another order, and one more.
#include "phased.h"

static const taskc_phase phases[] = {
    {"lie", "", {0, 1}}, {"lift", "", {0, 2}}, {"reach", "", {0, 3}}};

PHASED(.name = "phased_more", .phases = phases, .phase_count = 3)
