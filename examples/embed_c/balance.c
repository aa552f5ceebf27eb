/* A host in C: it fills the sensors that a task declares itself, and reads what the task pays.
 *
 *   cmake -B build -DCMAKE_PREFIX_PATH=PREFIX && cmake --build build && build/balance build/balance.so
 *
 * or, without CMake, PREFIX being where taskc was installed to:
 *
 *   taskc build balance.task -o balance.so
 *   cc balance.c -o balance $(pkg-config --cflags --libs taskc)
 *   ./balance balance.so
 */
#include <stdio.h>
#include <stdlib.h>
#include <taskc/host.h>

/* What the host knows of its world. */
static struct {
  double cart_position;
  float pole_angle; /* as its simulation has it; the task gets a double */
  double wish;
  unsigned char held[2];
} world;

static void check(taskc_status status) {
  if (status == TASKC_OK) return;
  fprintf(stderr, "balance: %s\n", taskc_error());
  exit(1);
}

static void bind_sensors(taskc_instance* instance) {
  check(taskc_bind(instance, "cart.position", "m", (taskc_view){.data = &world.cart_position}));
  check(taskc_bind(instance, "pole.angle", "rad",
                   (taskc_view){.data = &world.pole_angle, .format = TASKC_FLOAT32}));
  check(taskc_bind(instance, "wish", "m", (taskc_view){.data = &world.wish}));
  check(taskc_bind(instance, "held", "",
                   (taskc_view){.data = world.held, .format = TASKC_BOOL8, .rows = 2}));
}

/* The pole tilts, and somebody changes the wish and then holds the pole. */
static void simulate(int step) {
  world.pole_angle = 0.3f * (float)step;
  if (step == 2) world.wish = 0.5;
  if (step == 3) world.held[1] = 1;
}

int main(int argc, char** argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: balance PLUGIN.so\n");
    return 2;
  }
  taskc_task* task = NULL;
  taskc_instance* instance = NULL;
  check(taskc_open(argv[1], &task));
  check(taskc_new_instance(task, &instance));
  bind_sensors(instance);

  check(taskc_start_episode(instance, 1, NULL));
  for (int step = 1; step <= 4 && taskc_ended(instance, NULL) < 0; ++step) {
    simulate(step);
    taskc_result result;
    check(taskc_event(instance, TASKC_END_OF_TIME_STEP, 0.5, &result));
    printf("%d: %.6f", step, result.reward);
    if (result.end >= 0) printf(", %s", taskc_describe(task)->ends[result.end].reason);
    printf("\n");
  }
  check(taskc_end_episode(instance, TASKC_TRUNCATED, NULL));

  const taskc_plugin* about = taskc_describe(task);
  for (taskc_uint32 i = 0; i < about->term_count; ++i)
    printf("%s: %.6f\n", about->terms[i].name, taskc_terms(instance)[i]);
  taskc_delete_instance(instance);
  taskc_close(task);
  return 0;
}
