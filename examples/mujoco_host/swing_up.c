/* A task, as it was written for the trainer, pays for a robot that MuJoCo simulates.
 *
 *   taskc build ../tasks/swing_up.task -o swing_up.so
 *   cc swing_up.c -o swing_up $(pkg-config --cflags --libs taskc) -lmujoco -lm
 *   ./swing_up swing_up.so cart_pole.xml
 */
#include <stdio.h>
#include <stdlib.h>
#include <taskc/mujoco.h>

enum { kSteps = 5 }; /* of MuJoCo's in a time step of 10 ms */

static void fail(const char* why) {
  fprintf(stderr, "swing_up: %s\n", why);
  exit(1);
}

static void check(taskc_status status) {
  if (status != TASKC_OK) fail(taskc_error());
}

/* Not much of a controller: it rocks the cart as fast as the pole swings. */
static void act(const mjModel* model, mjData* data) {
  (void)model;
  data->ctrl[0] = 0.25 * sin(3.6 * data->time);
}

int main(int argc, char** argv) {
  if (argc != 3) fail("usage: swing_up PLUGIN.so MODEL.xml");
  char error[256] = "";
  mjModel* model = mj_loadXML(argv[2], NULL, error, sizeof error);
  if (model == NULL) fail(error);
  mjData* data = mj_makeData(model);
  data->qpos[1] = mjPI; /* the pole hangs */

  taskc_task* task = NULL;
  taskc_instance* instance = NULL;
  taskc_mujoco robot;
  check(taskc_open(argv[1], &task));
  check(taskc_new_instance(task, &instance));
  if (taskc_mujoco_open(&robot, task, instance, model) != 0) fail(robot.error);

  taskc_mujoco_start(&robot, data);
  check(taskc_start_episode(instance, 1, NULL));
  while (taskc_ended(instance, NULL) < 0) {
    act(model, data);
    taskc_mujoco_start_time_step(&robot, data);
    for (int i = 0; i < kSteps; ++i) {
      mj_step(model, data);
      taskc_mujoco_step(&robot, data);
    }
    check(taskc_event(instance, TASKC_END_OF_TIME_STEP, kSteps * model->opt.timestep, NULL));
  }
  check(taskc_end_episode(instance, TASKC_TRUNCATED, NULL));
  printf("paid %.3f in %.2f s\n", taskc_return(instance), data->time);

  taskc_mujoco_close(&robot);
  taskc_delete_instance(instance);
  taskc_close(task);
  mj_deleteData(data);
  mj_deleteModel(model);
  return 0;
}
