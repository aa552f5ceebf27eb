// What `contact` is: whether a link touches what does not move, after a low-pass filter, as
// contacts chatter from one physics step to the next. The trainer's own; a host that simulates or
// senses raw contacts makes the sensor of them by it. Header only, C11 and C++.
//
//   const taskc_contact_filter filter = taskc_contact_filter_for(0.002);  // length of a step [s]
//   taskc_contact links[LINKS];
//   for (int i = 0; i < LINKS; ++i) contact[i] = taskc_contact_start(&filter, &links[i],
//   touches(i)); while (running) {
//     simulate();  // one step
//     for (int i = 0; i < LINKS; ++i) contact[i] = taskc_contact_step(&filter, &links[i],
//     touches(i));
//   }
//
// A second-order filter (f = 10 Hz, Q = 0.8) of each link's raw contact, which is 0 or 1; it is in
// contact while the output v2 exceeds 0.1:
//   t = raw - v2 - v1 / Q;  v1 += a t;  v2 += a v1;  a = 1 - exp(-2 pi f h)
// A touch shows after 8.0 ms, its end after 38.6 ms, a touch of 3.2 ms or less not at all, whatever
// the length of a step: in one that is longer than h = 0.2 ms the filter takes several of its own.
#ifndef TASKC_CONTACT_FILTER_H
#define TASKC_CONTACT_FILTER_H

#include <math.h>

// For steps of one length; constant.
typedef struct taskc_contact_filter {
  int substeps;  // of its own in each step
  double gain;   // a
} taskc_contact_filter;

// Of one link.
typedef struct taskc_contact {
  double v1;
  double v2;
} taskc_contact;

// `step` [s] is more than 0.
static inline taskc_contact_filter taskc_contact_filter_for(double step) {
  const double kPi = 3.14159265358979323846;
  const double kFrequency = 10;        // Hz
  const double kLongestStep = 0.0002;  // s
  taskc_contact_filter filter;
  filter.substeps = (int)ceil(step / kLongestStep * (1 - 1e-9));
  filter.gain = 1 - exp(-2 * kPi * kFrequency * step / filter.substeps);
  return filter;
}

static inline int taskc_is_contact(const taskc_contact* link) { return link->v2 > 0.1; }

static inline void taskc_contact_advance(const taskc_contact_filter* filter, taskc_contact* link,
                                         double raw, int steps) {
  const double kQuality = 0.8;
  for (int n = 0; n < steps; ++n) {
    const double t = raw - link->v2 - link->v1 / kQuality;
    link->v1 += filter->gain * t;
    link->v2 += filter->gain * link->v1;
  }
}

// An episode begins, as if the link had touched, or not touched, for long. `touches`: 0 or 1.
// Returns whether it is in contact: 0 or 1.
static inline int taskc_contact_start(const taskc_contact_filter* filter, taskc_contact* link,
                                      int touches) {
  const int kStepsToSettle = 1000;
  link->v1 = link->v2 = 0;
  taskc_contact_advance(filter, link, touches, kStepsToSettle);
  return taskc_is_contact(link);
}

// One step, in which the link touched or did not. Returns whether it is in contact after it.
static inline int taskc_contact_step(const taskc_contact_filter* filter, taskc_contact* link,
                                     int touches) {
  // It would stay at rest: many links never touch anything.
  if (!touches && link->v1 == 0 && link->v2 == 0) return 0;
  taskc_contact_advance(filter, link, touches, filter->substeps);
  return taskc_is_contact(link);
}

#endif  // TASKC_CONTACT_FILTER_H
