// Events, and what an episode has come to.
#include <fmt/format.h>
#include <taskc/host.h>

#include <cmath>
#include <span>

#include "libtaskc/failure.h"
#include "libtaskc/instance.h"
#include "libtaskc/lookup.h"

namespace libtaskc {
namespace {

constexpr taskc_uint32 kAllReaders = (1u << TASKC_READER_COUNT) - 1;

void Give(const taskc_result& result, taskc_result* place) {
  if (place != nullptr) *place = result;
}

void CheckEvent(const taskc_instance& instance, taskc_int32 event, double time_step) {
  if (event <= TASKC_END_OF_EPISODE || event >= TASKC_EVENT_COUNT) {
    throw Failure(TASKC_ERROR_WRONG_ORDER,
                  fmt::format("there is no event {} within an episode", event));
  }
  if (!instance.episode.is_running()) {
    throw Failure(TASKC_ERROR_WRONG_ORDER,
                  "no episode runs: call `taskc_start_episode` before the events in it");
  }
  if (!(time_step >= 0 && std::isfinite(time_step))) {
    throw Failure(TASKC_ERROR_OUT_OF_RANGE, fmt::format("a time step cannot have {} s", time_step));
  }
}

// Of the numbers that `numbers_of` gives, the one called `name`.
template <class Entry, class NumbersOf>
taskc_status Get(const taskc_instance* instance, const Entry* taskc_plugin::*table,
                 taskc_uint32 taskc_plugin::*size, NumbersOf numbers_of, const char* name,
                 const char* what, double* value) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    RequirePointer(value, "the place for the value");
    const Entry* const entries = instance->task().*table;
    const taskc_uint32 count = instance->task().*size;
    const std::span<const double> numbers = numbers_of(*instance);
    *value = numbers[IndexOf(instance->task(), std::span(entries, count), name, what)];
  });
}

}  // namespace
}  // namespace libtaskc

using namespace libtaskc;

taskc_status taskc_start_episode(taskc_instance* instance, taskc_uint64 seed,
                                 taskc_result* result) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    instance->sensors.RequireFor(kAllReaders);
    instance->sensors.Refresh(TASKC_START_OF_EPISODE);
    Give(instance->episode.Start(seed), result);
  });
}

taskc_status taskc_event(taskc_instance* instance, taskc_int32 event, double time_step,
                         taskc_result* result) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    CheckEvent(*instance, event, time_step);
    Episode& episode = instance->episode;
    instance->sensors.Refresh(event);
    const taskc_result done = episode.Call(event, time_step);
    if (event == TASKC_END_OF_TIME_STEP && episode.needs_measuring()) {
      instance->sensors.Refresh(TASKC_MEASURE);
      episode.Measure();
    }
    Give(done, result);
  });
}

taskc_status taskc_end_episode(taskc_instance* instance, taskc_int32 outcome,
                               taskc_result* result) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    if (outcome < TASKC_SUCCESS || outcome > TASKC_TRUNCATED)
      throw Failure(TASKC_ERROR_OUT_OF_RANGE, fmt::format("there is no outcome {}", outcome));
    if (!instance->episode.is_running())
      throw Failure(TASKC_ERROR_WRONG_ORDER, "no episode runs that could end");
    instance->sensors.Refresh(TASKC_END_OF_EPISODE);
    const taskc_result done = instance->episode.End(outcome);
    instance->sensors.Refresh(TASKC_MEASURE);
    instance->episode.Finish();
    Give(done, result);
  });
}

double taskc_return(const taskc_instance* instance) { return instance->episode.episode_return(); }

taskc_int64 taskc_fault_count(const taskc_instance* instance) {
  return instance->episode.fault_count();
}

taskc_int32 taskc_ended(const taskc_instance* instance, const char** reason) {
  if (reason != nullptr) *reason = instance->episode.reason();
  return instance->episode.kind();
}

const double* taskc_terms(const taskc_instance* instance) {
  return instance->frame().terms().data();
}

const double* taskc_metrics(const taskc_instance* instance) {
  return instance->episode.counts().metrics().data();
}

const double* taskc_logs(const taskc_instance* instance) {
  return instance->episode.counts().logs().data();
}

taskc_status taskc_get_term(const taskc_instance* instance, const char* term, double* value) {
  const auto terms = [](const taskc_instance& of) { return of.frame().terms(); };
  return Get(instance, &taskc_plugin::terms, &taskc_plugin::term_count, terms, term, "reward term",
             value);
}

taskc_status taskc_get_metric(const taskc_instance* instance, const char* metric, double* value) {
  const auto metrics = [](const taskc_instance& of) { return of.episode.counts().metrics(); };
  return Get(instance, &taskc_plugin::metrics, &taskc_plugin::metric_count, metrics, metric,
             "metric", value);
}

taskc_status taskc_get_log(const taskc_instance* instance, const char* log, double* value) {
  const auto logs = [](const taskc_instance& of) { return of.episode.counts().logs(); };
  return Get(instance, &taskc_plugin::logs, &taskc_plugin::log_count, logs, log, "log", value);
}

taskc_int32 taskc_present_phase(const taskc_instance* instance) {
  if (instance->task().phase_count == 0) return -1;
  return static_cast<taskc_int32>(instance->frame().PresentPhase());
}

taskc_status taskc_observe(taskc_instance* instance, const double** observations) {
  return Guarded([&] {
    RequirePointer(instance, "the instance");
    RequirePointer(observations, "the place for the observations");
    if (!instance->episode.is_running())
      throw Failure(TASKC_ERROR_WRONG_ORDER, "no episode runs in which something is observed");
    instance->sensors.Refresh(TASKC_OBSERVE);
    instance->frame().Observe();
    for (double& number : instance->frame().observations())
      if (!std::isfinite(number)) number = 0;
    *observations = instance->frame().observations().data();
  });
}
