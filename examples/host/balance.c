/* A host in C: it fills the sensors that a task declares itself, and reads what the task pays.
 *
 *   taskc build balance.task -o balance.so
 *   cc -std=c99 -I PREFIX/share/taskc/include balance.c -o balance -ldl
 *   ./balance ./balance.so
 */
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <taskc/plugin.h>

/* What the host knows of its world: one member for each sensor, with as many elements as the table
 * says. A bool has one byte. */
static struct {
  double cart_position;
  double pole_angle;
  double wish;
  unsigned char held[2];
} world;

static const struct {
  const char* name;
  const char* type;
  const char* unit;
  const void* data;
} offers[] = {
    {"cart.position", "real", "m", &world.cart_position},
    {"pole.angle", "real", "rad", &world.pole_angle},
    {"wish", "real", "m", &world.wish},
    {"held", "bool[2]", "", world.held},
};

/* Where the data is that the task reads as this sensor; null where this host has no such thing. */
static const void* find_offer(const taskc_sensor* sensor) {
  for (size_t i = 0; i < sizeof offers / sizeof *offers; ++i) {
    if (strcmp(offers[i].name, sensor->name) == 0 && strcmp(offers[i].type, sensor->type) == 0 &&
        strcmp(offers[i].unit, sensor->unit) == 0)
      return offers[i].data;
  }
  fprintf(stderr, "the task reads the sensor `%s`, which this host does not have\n", sensor->name);
  exit(1);
}

static void* zeros(size_t count, size_t size) {
  void* memory = calloc(count + 1, size); /* aligned to 16 on the machines that taskc builds for */
  if (memory == NULL) exit(1);
  return memory;
}

static const taskc_plugin* load(const char* file) {
  void* library = dlopen(file, RTLD_NOW);
  taskc_plugin_entry entry = NULL;
  if (library != NULL) *(void**)&entry = dlsym(library, TASKC_PLUGIN_ENTRY);
  if (entry == NULL) {
    fprintf(stderr, "%s\n", dlerror());
    exit(1);
  }
  if (entry()->abi_version != TASKC_ABI_VERSION) {
    fprintf(stderr, "%s was built for another version of the ABI\n", file);
    exit(1);
  }
  return entry();
}

static void call(taskc_event_function function, taskc_frame* frame, double time_step) {
  frame->time_step = time_step;
  frame->reward = 0;
  frame->end = frame->fault = frame->violation = -1;
  if (function != NULL) function(frame);
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const taskc_plugin* task = load(argv[1]);

  const void** sensors = zeros(task->sensor_count, sizeof *sensors);
  for (taskc_uint32 i = 0; i < task->sensor_count; ++i) sensors[i] = find_offer(&task->sensors[i]);
  double* params = zeros(task->param_count, sizeof *params);
  for (taskc_uint32 i = 0; i < task->param_count; ++i) params[i] = task->params[i].initial;

  taskc_frame frame = {.sensors = sensors,
                       .params = params,
                       .memory = zeros(task->memory_size, 1),
                       .seed = 1,
                       .discount = 1,
                       .outcome = TASKC_TRUNCATED,
                       .terms = zeros(task->term_count, sizeof(double)),
                       .metrics = zeros(task->metric_count, sizeof(double)),
                       .observations = zeros(task->observation_size, sizeof(double)),
                       .logs = zeros(task->log_count, sizeof(taskc_log_state))};
  call(task->initialize, &frame, 0);
  call(task->events[TASKC_START_OF_EPISODE], &frame, 0);

  /* The pole tilts, and somebody changes the wish and then holds the pole. */
  const double time_step = 0.5;
  for (int step = 1; step <= 4 && frame.end < 0; ++step) {
    world.pole_angle = 0.3 * step;
    if (step == 2) world.wish = 0.5;
    if (step == 3) world.held[1] = 1;
    call(task->events[TASKC_END_OF_TIME_STEP], &frame, time_step);
    printf("%d: %.6f", step, frame.reward);
    if (frame.end >= 0) printf(", %s", task->ends[frame.end].reason);
    printf("\n");
  }
  call(task->events[TASKC_END_OF_EPISODE], &frame, 0);
  for (taskc_uint32 i = 0; i < task->term_count; ++i)
    printf("%s: %.6f\n", task->terms[i].name, frame.terms[i]);
  return 0;
}
