// For a robot whose joints have other names than those of these tests.
#include "plugin_table.h"

static const taskc_part joints[] = {{"knee"}, {"hip"}};

PLUGIN(.joints = joints, .joint_count = 2)
