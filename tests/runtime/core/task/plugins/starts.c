// A task that starts in one of two poses: the seed's lowest bit says in which. It adds the seed to
// the second joint's angle, and turns the robot by a quarter about z. It moves to the left as many
// meters per second as states were drawn before.
#include "plugin_table.h"

typedef struct memory {
  double angles[2];
  double yaw;
  double velocity[3];
} memory;

static void initialize(taskc_frame* frame) {
  *(memory*)frame->memory = (memory){{0, 0}, 0, {0, 0, 0}};
}
static void draw_pose(taskc_frame* frame) { frame->pose = (taskc_int32)(frame->seed & 1); }
static void draw_start(taskc_frame* frame) {
  memory* m = (memory*)frame->memory;
  m->angles[1] += frame->params[0];
  m->yaw = 1.5707963267948966;
  m->velocity[0] = (double)(frame->seed & 1);
  m->velocity[1] = frame->attempt;
}

static const taskc_param params[] = {{"bend", "", "rad", TASKC_REAL, 0.25, -100, 100}};
static const taskc_pose poses[] = {{"first"}, {"second"}};
static const taskc_memory variables[] = {
    {"start#joint.angle", "real[joint]", "rad", TASKC_REAL, 2, 1, TASKC_PER_RUN,
     offsetof(memory, angles)},
    {"start#base.yaw", "real", "rad", TASKC_REAL, 1, 1, TASKC_PER_RUN, offsetof(memory, yaw)},
    {"start#base.velocity", "vec3", "m/s", TASKC_REAL, 3, 1, TASKC_PER_RUN,
     offsetof(memory, velocity)},
};
static const taskc_start_value values[] = {
    {"joint.angle", 2, offsetof(memory, angles)},
    {"base.yaw", 1, offsetof(memory, yaw)},
    {"base.velocity", 3, offsetof(memory, velocity)},
};

PLUGIN(.name = "starts", .params = params, .param_count = 1, .poses = poses, .pose_count = 2,
       .start_values = values, .start_value_count = 3, .memory = variables, .memory_count = 3,
       .memory_size = sizeof(memory), .initialize = initialize, .draw_pose = draw_pose,
       .draw_start = draw_start)
