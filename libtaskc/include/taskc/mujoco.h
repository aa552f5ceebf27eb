// Fills the sensors of a robot from MuJoCo's mjData, so that a compiled task pays for a robot that
// MuJoCo simulates. Header only, C11 and C++: a program that includes it links libtaskc and MuJoCo
// (from 2.2.2 on).
//
//   taskc_mujoco robot;
//   if (taskc_mujoco_open(&robot, task, instance, model) != 0) die(robot.error);
//   taskc_mujoco_start(&robot, data);
//   taskc_start_episode(instance, seed, NULL);
//   while (running) {
//     taskc_mujoco_start_time_step(&robot, data);
//     for (int i = 0; i < steps; ++i) {
//       mj_step(model, data);
//       taskc_mujoco_step(&robot, data);
//     }
//     taskc_event(instance, TASKC_END_OF_TIME_STEP, steps * model->opt.timestep, &result);
//   }
//   taskc_end_episode(instance, TASKC_TRUNCATED, NULL);
//   taskc_mujoco_close(&robot);
//
// Names: a link is the body, a joint the hinge or slide joint, and a site, where the task reads
// any, the site of the same name. The base is the robot's first link. Sensors that the task
// declares itself are the host's to bind.
//
// What the sensors mean is what they mean in the trainer: a link's frame lies in its center of mass
// and is parallel to the world's where all joints are at 0 and the base is not turned;
// accelerations and contact forces are means since the start of the time step; `contact` is contact
// with what does not move, filtered as taskc/contact_filter.h says. A joint's angle is MuJoCo's
// coordinate of it; `joint.torque` is what its actuators applied in the last step, and
// `joint.target` the control of the first of them.
#ifndef TASKC_MUJOCO_H
#define TASKC_MUJOCO_H

#include <math.h>
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <taskc/contact_filter.h>
#include <taskc/host.h>

struct taskc_mujoco;

// Writes a sensor's numbers, in the order of its elements.
typedef void (*taskc_mujoco_fill)(const struct taskc_mujoco* robot, const mjData* data,
                                  double* out);

typedef struct taskc_mujoco {
  char error[256];  // why taskc_mujoco_open() failed
  // All else is the functions' own.
  const mjModel* model;
  int link_count, joint_count, site_count, sensor_count;
  int* bodies;               // of the links
  int* links;                // of the bodies, -1 where one is no link
  int* joints;               // MuJoCo's of the joints
  int* actuators;            // of the joints, -1 where nothing drives one
  int* sites;                // MuJoCo's of the sites
  mjtNum* zero;              // how the links' bodies are turned in the zero pose
  long steps;                // of the episode so far
  double elapsed;            // since the start of the time step [s]
  double base_velocity[3];   // then
  double* joint_velocities;  // then
  double* site_velocities;   // then
  double* impulses;          // of the contacts on each link since then
  taskc_contact* filters;    // of each link's contacts
  unsigned char* contact;    // for each link
  taskc_mujoco_fill* fills;  // of the sensors that the task reads
  double** values;           // of the same
} taskc_mujoco;

// ---- One function for each sensor ---------------------------------------------------------------

// How a link is turned since the zero pose: a quaternion.
static inline void taskc_mujoco_turn(const taskc_mujoco* r, const mjData* d, int link,
                                     mjtNum out[4]) {
  mjtNum back[4];
  mju_negQuat(back, r->zero + 4 * link);
  mju_mulQuat(out, d->xquat + 4 * r->bodies[link], back);
}

static inline void taskc_mujoco_rotation(const taskc_mujoco* r, const mjData* d, mjtNum out[9]) {
  mjtNum turn[4];
  taskc_mujoco_turn(r, d, 0, turn);
  mju_quat2Mat(out, turn);
}

// Angular velocity, then that of the center of mass, in the world.
static inline void taskc_mujoco_motion(const taskc_mujoco* r, const mjData* d, int link,
                                       mjtNum out[6]) {
  mj_objectVelocity(r->model, d, mjOBJ_BODY, r->bodies[link], out, 0);
}

static inline void taskc_mujoco_time(const taskc_mujoco* r, const mjData* d, double* out) {
  (void)d;
  *out = (double)r->steps * r->model->opt.timestep;
}

static inline void taskc_mujoco_base_position(const taskc_mujoco* r, const mjData* d, double* out) {
  mju_copy3(out, d->xipos + 3 * r->bodies[0]);
}
static inline void taskc_mujoco_base_orientation(const taskc_mujoco* r, const mjData* d,
                                                 double* out) {
  taskc_mujoco_turn(r, d, 0, out);
}
static inline void taskc_mujoco_base_rotation(const taskc_mujoco* r, const mjData* d, double* out) {
  taskc_mujoco_rotation(r, d, out);
}
static inline void taskc_mujoco_column(const taskc_mujoco* r, const mjData* d, int column,
                                       double* out) {
  mjtNum rotation[9];
  taskc_mujoco_rotation(r, d, rotation);
  for (int row = 0; row < 3; ++row) out[row] = rotation[3 * row + column];
}
static inline void taskc_mujoco_base_forward(const taskc_mujoco* r, const mjData* d, double* out) {
  taskc_mujoco_column(r, d, 0, out);
}
static inline void taskc_mujoco_base_left(const taskc_mujoco* r, const mjData* d, double* out) {
  taskc_mujoco_column(r, d, 1, out);
}
static inline void taskc_mujoco_base_up(const taskc_mujoco* r, const mjData* d, double* out) {
  taskc_mujoco_column(r, d, 2, out);
}
static inline void taskc_mujoco_base_velocity(const taskc_mujoco* r, const mjData* d, double* out) {
  mjtNum motion[6];
  taskc_mujoco_motion(r, d, 0, motion);
  mju_copy3(out, motion + 3);
}
static inline void taskc_mujoco_base_angular_velocity(const taskc_mujoco* r, const mjData* d,
                                                      double* out) {
  mjtNum motion[6];
  taskc_mujoco_motion(r, d, 0, motion);
  mju_copy3(out, motion);
}
// What an accelerometer shows that is turned like this and had the velocity `before` when the time
// step began: gravity is felt as an acceleration upward.
static inline void taskc_mujoco_felt(const taskc_mujoco* r, const double before[3],
                                     const double velocity[3], const mjtNum rotation[9],
                                     double* out) {
  mjtNum felt[3];
  for (int k = 0; k < 3; ++k) {
    const double change = velocity[k] - before[k];
    felt[k] = (r->elapsed > 0 ? change / r->elapsed : 0) - r->model->opt.gravity[k];
  }
  mju_rotVecMatT(out, felt, rotation);
}
static inline void taskc_mujoco_base_acceleration(const taskc_mujoco* r, const mjData* d,
                                                  double* out) {
  mjtNum rotation[9];
  double velocity[3];
  taskc_mujoco_base_velocity(r, d, velocity);
  taskc_mujoco_rotation(r, d, rotation);
  taskc_mujoco_felt(r, r->base_velocity, velocity, rotation, out);
}

static inline void taskc_mujoco_joint_angle(const taskc_mujoco* r, const mjData* d, double* out) {
  for (int j = 0; j < r->joint_count; ++j) out[j] = d->qpos[r->model->jnt_qposadr[r->joints[j]]];
}
static inline void taskc_mujoco_joint_velocity(const taskc_mujoco* r, const mjData* d,
                                               double* out) {
  for (int j = 0; j < r->joint_count; ++j) out[j] = d->qvel[r->model->jnt_dofadr[r->joints[j]]];
}
static inline void taskc_mujoco_joint_acceleration(const taskc_mujoco* r, const mjData* d,
                                                   double* out) {
  taskc_mujoco_joint_velocity(r, d, out);
  for (int j = 0; j < r->joint_count; ++j) {
    out[j] = r->elapsed > 0 ? (out[j] - r->joint_velocities[j]) / r->elapsed : 0;
  }
}
static inline void taskc_mujoco_joint_torque(const taskc_mujoco* r, const mjData* d, double* out) {
  for (int j = 0; j < r->joint_count; ++j) {
    out[j] = d->qfrc_actuator[r->model->jnt_dofadr[r->joints[j]]];
  }
}
static inline void taskc_mujoco_joint_target(const taskc_mujoco* r, const mjData* d, double* out) {
  for (int j = 0; j < r->joint_count; ++j) {
    out[j] = r->actuators[j] < 0 ? 0 : d->ctrl[r->actuators[j]];
  }
}

static inline void taskc_mujoco_link_position(const taskc_mujoco* r, const mjData* d, double* out) {
  for (int i = 0; i < r->link_count; ++i) mju_copy3(out + 3 * i, d->xipos + 3 * r->bodies[i]);
}
static inline void taskc_mujoco_link_orientation(const taskc_mujoco* r, const mjData* d,
                                                 double* out) {
  for (int i = 0; i < r->link_count; ++i) taskc_mujoco_turn(r, d, i, out + 4 * i);
}
static inline void taskc_mujoco_link_velocity(const taskc_mujoco* r, const mjData* d, double* out) {
  mjtNum motion[6];
  for (int i = 0; i < r->link_count; ++i) {
    taskc_mujoco_motion(r, d, i, motion);
    mju_copy3(out + 3 * i, motion + 3);
  }
}
static inline void taskc_mujoco_link_angular_velocity(const taskc_mujoco* r, const mjData* d,
                                                      double* out) {
  mjtNum motion[6];
  for (int i = 0; i < r->link_count; ++i) {
    taskc_mujoco_motion(r, d, i, motion);
    mju_copy3(out + 3 * i, motion);
  }
}
static inline void taskc_mujoco_contact_force(const taskc_mujoco* r, const mjData* d, double* out) {
  (void)d;
  for (int i = 0; i < 3 * r->link_count; ++i) {
    out[i] = r->elapsed > 0 ? r->impulses[i] / r->elapsed : 0;
  }
}

static inline void taskc_mujoco_site_position(const taskc_mujoco* r, const mjData* d, double* out) {
  for (int i = 0; i < r->site_count; ++i) mju_copy3(out + 3 * i, d->site_xpos + 3 * r->sites[i]);
}
static inline void taskc_mujoco_site_orientation(const taskc_mujoco* r, const mjData* d,
                                                 double* out) {
  for (int i = 0; i < r->site_count; ++i) {
    const int site = r->sites[i];
    mju_mulQuat(out + 4 * i, d->xquat + 4 * r->model->site_bodyid[site],
                r->model->site_quat + 4 * site);
  }
}
static inline void taskc_mujoco_site_velocity(const taskc_mujoco* r, const mjData* d, double* out) {
  mjtNum motion[6];
  for (int i = 0; i < r->site_count; ++i) {
    mj_objectVelocity(r->model, d, mjOBJ_SITE, r->sites[i], motion, 0);
    mju_copy3(out + 3 * i, motion + 3);
  }
}
static inline void taskc_mujoco_site_angular_velocity(const taskc_mujoco* r, const mjData* d,
                                                      double* out) {
  mjtNum motion[6];
  for (int i = 0; i < r->site_count; ++i) {
    mj_objectVelocity(r->model, d, mjOBJ_SITE, r->sites[i], motion, 0);
    mju_copy3(out + 3 * i, motion);
  }
}
static inline void taskc_mujoco_site_acceleration(const taskc_mujoco* r, const mjData* d,
                                                  double* out) {
  taskc_mujoco_site_velocity(r, d, out);
  for (int i = 0; i < r->site_count; ++i) {
    double velocity[3];
    mju_copy3(velocity, out + 3 * i);
    taskc_mujoco_felt(r, r->site_velocities + 3 * i, velocity, d->site_xmat + 9 * r->sites[i],
                      out + 3 * i);
  }
}

// Null where the name is not that of a robot's sensor, or `contact`, which is kept up to date.
static inline taskc_mujoco_fill taskc_mujoco_find(const char* name) {
  static const struct {
    const char* name;
    taskc_mujoco_fill fill;
  } kSensors[] = {
      {"time", taskc_mujoco_time},
      {"base.position", taskc_mujoco_base_position},
      {"base.orientation", taskc_mujoco_base_orientation},
      {"base.rotation", taskc_mujoco_base_rotation},
      {"base.forward", taskc_mujoco_base_forward},
      {"base.left", taskc_mujoco_base_left},
      {"base.up", taskc_mujoco_base_up},
      {"base.velocity", taskc_mujoco_base_velocity},
      {"base.angular_velocity", taskc_mujoco_base_angular_velocity},
      {"base.acceleration", taskc_mujoco_base_acceleration},
      {"joint.angle", taskc_mujoco_joint_angle},
      {"joint.velocity", taskc_mujoco_joint_velocity},
      {"joint.acceleration", taskc_mujoco_joint_acceleration},
      {"joint.torque", taskc_mujoco_joint_torque},
      {"joint.target", taskc_mujoco_joint_target},
      {"link.position", taskc_mujoco_link_position},
      {"link.orientation", taskc_mujoco_link_orientation},
      {"link.velocity", taskc_mujoco_link_velocity},
      {"link.angular_velocity", taskc_mujoco_link_angular_velocity},
      {"contact_force", taskc_mujoco_contact_force},
      {"site.position", taskc_mujoco_site_position},
      {"site.orientation", taskc_mujoco_site_orientation},
      {"site.velocity", taskc_mujoco_site_velocity},
      {"site.angular_velocity", taskc_mujoco_site_angular_velocity},
      {"site.acceleration", taskc_mujoco_site_acceleration},
  };
  for (size_t i = 0; i < sizeof kSensors / sizeof *kSensors; ++i) {
    if (strcmp(kSensors[i].name, name) == 0) return kSensors[i].fill;
  }
  return NULL;
}

// ---- Contacts -----------------------------------------------------------------------------------

// The contacts that `data` has, with which a step was made, or those at the start of an episode.
static inline void taskc_mujoco_read_contacts(taskc_mujoco* r, const mjData* d, int is_start) {
  const mjModel* m = r->model;
  const double time = is_start ? 0 : m->opt.timestep;
  const taskc_contact_filter filter = taskc_contact_filter_for(m->opt.timestep);
  for (int i = 0; i < d->ncon; ++i) {
    mjtNum force[6];
    mjtNum in_world[3];
    mj_contactForce(m, d, i, force);
    mju_rotVecMatT(in_world, force, d->contact[i].frame);
    const int first = r->links[m->geom_bodyid[d->contact[i].geom1]];
    const int second = r->links[m->geom_bodyid[d->contact[i].geom2]];
    if (first >= 0) mju_addToScl3(r->impulses + 3 * first, in_world, -time);
    if (second >= 0) mju_addToScl3(r->impulses + 3 * second, in_world, time);
  }
  for (int link = 0; link < r->link_count; ++link) {
    int touches = 0;
    for (int i = 0; i < d->ncon; ++i) {
      const int first = m->geom_bodyid[d->contact[i].geom1];
      const int second = m->geom_bodyid[d->contact[i].geom2];
      const int other = r->links[first] == link ? second : r->links[second] == link ? first : -1;
      if (other >= 0 && m->body_weldid[other] == 0) touches = 1;
    }
    taskc_contact* const state = &r->filters[link];
    r->contact[link] = (unsigned char)(is_start ? taskc_contact_start(&filter, state, touches)
                                                : taskc_contact_step(&filter, state, touches));
  }
}

// ---- What a host calls --------------------------------------------------------------------------

static inline void taskc_mujoco_close(taskc_mujoco* r) {
  for (int i = 0; r->values != NULL && i < r->sensor_count; ++i) free(r->values[i]);
  free(r->bodies), free(r->links), free(r->joints), free(r->actuators), free(r->zero);
  free(r->joint_velocities), free(r->impulses), free(r->filters), free(r->contact);
  free(r->sites), free(r->site_velocities), free(r->fills), free(r->values);
  memset(r, 0, sizeof *r);
}

// How many of the robot's sites count: none where the task reads none.
static inline int taskc_mujoco_sites_of(const taskc_plugin* about) {
  for (taskc_uint32 i = 0; i < about->sensor_count; ++i) {
    if (strncmp(about->sensors[i].name, "site.", 5) == 0) return (int)about->site_count;
  }
  return 0;
}

static inline int taskc_mujoco_find_parts(taskc_mujoco* r, const taskc_plugin* about) {
  const mjModel* m = r->model;
  for (int i = 0; i < m->nbody; ++i) r->links[i] = -1;
  for (int i = 0; i < r->link_count; ++i) {
    r->bodies[i] = mj_name2id(m, mjOBJ_BODY, about->links[i].name);
    if (r->bodies[i] < 0) {
      snprintf(r->error, sizeof r->error,
               "the model has no body `%.100s`, which is a link of `%.60s`", about->links[i].name,
               about->robot);
      return -1;
    }
    r->links[r->bodies[i]] = i;
  }
  for (int j = 0; j < r->joint_count; ++j) {
    const int id = r->joints[j] = mj_name2id(m, mjOBJ_JOINT, about->joints[j].name);
    const int type = id < 0 ? mjJNT_FREE : m->jnt_type[id];
    if (type != mjJNT_HINGE && type != mjJNT_SLIDE) {
      snprintf(r->error, sizeof r->error,
               "the model has no hinge and no slide joint `%.100s`, which is a joint of `%.60s`",
               about->joints[j].name, about->robot);
      return -1;
    }
    r->actuators[j] = -1;
    for (int a = m->nu - 1; a >= 0; --a) {
      if (m->actuator_trntype[a] == mjTRN_JOINT && m->actuator_trnid[2 * a] == id)
        r->actuators[j] = a;
    }
  }
  for (int i = 0; i < r->site_count; ++i) {
    r->sites[i] = mj_name2id(m, mjOBJ_SITE, about->sites[i].name);
    if (r->sites[i] < 0) {
      snprintf(r->error, sizeof r->error,
               "the model has no site `%.100s`, which is a site of `%.60s`", about->sites[i].name,
               about->robot);
      return -1;
    }
  }
  return 0;
}

// Where all joints are at 0 and the base is not turned.
static inline int taskc_mujoco_find_zero(taskc_mujoco* r) {
  const mjModel* m = r->model;
  mjData* d = mj_makeData(m);
  if (d == NULL) {
    snprintf(r->error, sizeof r->error, "there is no memory for another mjData");
    return -1;
  }
  for (int j = 0; j < m->njnt; ++j) {
    mjtNum* q = d->qpos + m->jnt_qposadr[j];
    const int free_joint = m->jnt_type[j] == mjJNT_FREE;
    if (free_joint || m->jnt_type[j] == mjJNT_BALL) {
      mju_zero(q + (free_joint ? 3 : 0), 4);
      q[free_joint ? 3 : 0] = 1;
    } else {
      *q = 0;
    }
  }
  mj_kinematics(m, d);
  for (int i = 0; i < r->link_count; ++i) mju_copy4(r->zero + 4 * i, d->xquat + 4 * r->bodies[i]);
  mj_deleteData(d);
  return 0;
}

static inline int taskc_mujoco_bind(taskc_mujoco* r, const taskc_plugin* about,
                                    taskc_instance* instance) {
  for (int i = 0; i < r->sensor_count; ++i) {
    const taskc_sensor* sensor = &about->sensors[i];
    taskc_view view;
    memset(&view, 0, sizeof view);
    view.rows = sensor->rows;
    view.columns = sensor->columns;
    r->fills[i] = taskc_mujoco_find(sensor->name);
    if (strcmp(sensor->name, "contact") == 0) {
      view.data = r->contact;
      view.format = TASKC_BOOL8;
    } else if (r->fills[i] != NULL) {
      view.data = r->values[i] =
          (double*)calloc((size_t)sensor->rows * sensor->columns, sizeof(double));
    } else {
      continue;  // the task's own
    }
    if (taskc_bind(instance, sensor->name, sensor->unit, view) != TASKC_OK) {
      snprintf(r->error, sizeof r->error, "%s", taskc_error());
      return -1;
    }
  }
  return 0;
}

// Finds the robot of a task in a model and binds all sensors of the robot that the task reads.
// Returns 0; or not, with `robot->error`, and nothing needs to be closed. The task, the instance
// and the model outlive the robot, which stays where it is: the instance reads its memory.
static inline int taskc_mujoco_open(taskc_mujoco* robot, const taskc_task* task,
                                    taskc_instance* instance, const mjModel* model) {
  const taskc_plugin* about = taskc_describe(task);
  memset(robot, 0, sizeof *robot);
  robot->model = model;
  robot->link_count = (int)about->link_count;
  robot->joint_count = (int)about->joint_count;
  robot->site_count = taskc_mujoco_sites_of(about);
  robot->sensor_count = (int)about->sensor_count;
  const size_t links = about->link_count;
  const size_t joints = about->joint_count;
  robot->bodies = (int*)calloc(links + 1, sizeof(int));
  robot->links = (int*)calloc((size_t)model->nbody, sizeof(int));
  robot->joints = (int*)calloc(joints + 1, sizeof(int));
  robot->actuators = (int*)calloc(joints + 1, sizeof(int));
  robot->sites = (int*)calloc(about->site_count + 1, sizeof(int));
  robot->zero = (mjtNum*)calloc(4 * links + 1, sizeof(mjtNum));
  robot->joint_velocities = (double*)calloc(joints + 1, sizeof(double));
  robot->site_velocities = (double*)calloc(3 * about->site_count + 1, sizeof(double));
  robot->impulses = (double*)calloc(3 * links + 1, sizeof(double));
  robot->filters = (taskc_contact*)calloc(links + 1, sizeof(taskc_contact));
  robot->contact = (unsigned char*)calloc(links + 1, 1);
  robot->fills = (taskc_mujoco_fill*)calloc(about->sensor_count + 1, sizeof(taskc_mujoco_fill));
  robot->values = (double**)calloc(about->sensor_count + 1, sizeof(double*));
  if (links == 0) {
    snprintf(robot->error, sizeof robot->error, "the task is for no robot");
  } else if (taskc_mujoco_find_parts(robot, about) == 0 && taskc_mujoco_find_zero(robot) == 0 &&
             taskc_mujoco_bind(robot, about, instance) == 0) {
    return 0;
  }
  char error[sizeof robot->error];
  memcpy(error, robot->error, sizeof error);
  taskc_mujoco_close(robot);
  memcpy(robot->error, error, sizeof error);
  return -1;
}

// Brings the sensors up to date with where the robot is now.
static inline void taskc_mujoco_refresh(taskc_mujoco* robot, mjData* data) {
  mj_kinematics(robot->model, data);
  mj_comPos(robot->model, data);
  mj_comVel(robot->model, data);
  for (int i = 0; i < robot->sensor_count; ++i) {
    if (robot->fills[i] != NULL) robot->fills[i](robot, data, robot->values[i]);
  }
}

// A time step begins: means are from now on.
static inline void taskc_mujoco_start_time_step(taskc_mujoco* robot, const mjData* data) {
  robot->elapsed = 0;
  taskc_mujoco_base_velocity(robot, data, robot->base_velocity);
  taskc_mujoco_joint_velocity(robot, data, robot->joint_velocities);
  taskc_mujoco_site_velocity(robot, data, robot->site_velocities);
  mju_zero(robot->impulses, 3 * robot->link_count);
}

// An episode begins in the state that `data` has. Before taskc_start_episode().
static inline void taskc_mujoco_start(taskc_mujoco* robot, mjData* data) {
  mj_forward(robot->model, data);
  robot->steps = 0;
  taskc_mujoco_read_contacts(robot, data, 1);
  taskc_mujoco_start_time_step(robot, data);
  taskc_mujoco_refresh(robot, data);
}

// MuJoCo has made a step. Its contacts are those that it found at the start of the step, as in the
// trainer.
static inline void taskc_mujoco_step(taskc_mujoco* robot, mjData* data) {
  robot->elapsed += robot->model->opt.timestep;
  robot->steps += 1;
  taskc_mujoco_read_contacts(robot, data, 0);
  taskc_mujoco_refresh(robot, data);
}

#endif  // TASKC_MUJOCO_H
