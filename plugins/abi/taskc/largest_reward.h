// The largest reward that a task can pay in one event, either way. A larger one is a mistake like
// one that is not finite: it is not paid. So no sum of rewards overflows, however long an episode
// is, and none is too large for single precision, in which a report holds it.
//
// Plain C, as plugin.h.
#ifndef TASKC_LARGEST_REWARD_H_
#define TASKC_LARGEST_REWARD_H_

#define TASKC_LARGEST_REWARD 1e30

#endif  // TASKC_LARGEST_REWARD_H_
