#include "libtaskc_sim/environments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <thread>

#include "libtaskc_sim/ended_episode.h"
#include "libtaskc_sim/failure.h"
#include "runtime/trainer/environment/decision_process.h"
#include "runtime/training/run/value_json.h"

namespace {

using libtaskc_sim::EndColumns;
using libtaskc_sim::EpisodeOf;
using libtaskc_sim::Failure;
using libtaskc_sim::RobotInTask;

constexpr taskc_uint32 kMostEnvironments = 100'000;
constexpr taskc_uint32 kMostThreads = 1024;
constexpr taskc_uint32 kSmallestPicture = 16;
constexpr taskc_uint32 kLargestPicture = 4096;

std::string Text(const char* text) { return text == nullptr ? "" : text; }

runtime::TaskOptions TaskOptionsOf(const taskc_sim_options& options) {
  runtime::TaskOptions task;
  task.task = options.task == nullptr ? options.plugin : options.task;
  task.profile = Text(options.profile);
  task.agent = Text(options.agent);
  task.robot = Text(options.robot);
  task.robots = Text(options.robots);
  for (size_t i = 0; i < options.setting_count; ++i) {
    libtaskc_sim::RequirePointer(options.settings, "`settings`");
    task.settings.push_back(Text(options.settings[i]));
  }
  return task;
}

void CheckRange(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw Failure(TASKC_ERROR_OUT_OF_RANGE,
                fmt::format("`{}` is {}: it is from {} to {}", name, value, low, high));
}

libtaskc_sim::Common CommonOf(const taskc_sim_options& options) {
  CheckRange("count", options.count, 1, kMostEnvironments);
  CheckRange("threads", options.threads, 0, kMostThreads);
  CheckRange("discount", options.discount, 0, 1);
  CheckRange("autoreset", options.autoreset, TASKC_SIM_NEXT_STEP, TASKC_SIM_DISABLED);
  return {options.autoreset, options.count};
}

std::deque<RobotInTask> RobotsOf(const runtime::TaskSetup& setup, double discount,
                                 const libtaskc_sim::Common& common) {
  runtime::CheckCanBeOutside(setup);
  std::deque<RobotInTask> robots;
  for (size_t i = 0; i < common.count; ++i) robots.emplace_back(setup, discount, i, common);
  return robots;
}

size_t ThreadsOf(const taskc_sim_options& options) {
  const size_t wanted =
      options.threads == 0 ? std::thread::hardware_concurrency() : options.threads;
  return std::clamp<size_t>(wanted, 1, options.count);
}

template <class Value>
Value* RowOf(Value* array, size_t row, size_t size) {
  return array == nullptr ? nullptr : array + row * size;
}

}  // namespace

taskc_sim::taskc_sim(const taskc_sim_options& options)
    : common_(CommonOf(options)),
      setup_(TaskOptionsOf(options), options.plugin, options.seed),
      robots_(RobotsOf(setup_, options.discount, common_)),
      threads_(ThreadsOf(options)),
      description_(setup_, robots_.front().process(), threads_.count(), robots_.size()),
      pictures_(setup_) {}

void taskc_sim::Reset(const unsigned char* which, const taskc_uint64* seeds, float* observations) {
  const size_t size = description().observation_size;
  threads_.ForEach(robots_.size(), [&](size_t i) {
    if (which != nullptr && which[i] == 0) return;
    RobotInTask& robot = robots_[i];
    const int64_t number =
        seeds == nullptr ? robot.NextNumber() : runtime::DecisionProcess::NumberOf(seeds[i]);
    robot.Reset(number, RowOf(observations, i, size));
  });
  ThrowFailure();
}

void taskc_sim::Step(const float* actions, const taskc_sim_arrays& arrays) {
  CheckIsReset();
  CheckActions(actions);
  const size_t size = description().action_size;
  threads_.ForEach(robots_.size(),
                   [&](size_t i) { robots_[i].Step(actions + i * size, ResultsOf(i, arrays)); });
  ThrowFailure();
  if (arrays.ended == nullptr) return;
  *arrays.ended =
      static_cast<taskc_uint32>(std::ranges::count_if(robots_, &RobotInTask::has_ended));
}

// What one environment refuses the first one does: they are alike.
void taskc_sim::Set(const unsigned char* which, const std::string& parameter,
                    const std::string& value) {
  const runtime::ParameterValue set = runtime::ParameterOfWord(value, parameter);
  for (size_t i = 0; i < robots_.size(); ++i) {
    if (which == nullptr || which[i] != 0) robots_[i].Set(parameter, set);
  }
}

void taskc_sim::CheckIsReset() const {
  const bool must_run = common_.autoreset == TASKC_SIM_DISABLED;
  for (size_t i = 0; i < robots_.size(); ++i) {
    const RobotInTask& robot = robots_[i];
    if (must_run ? robot.process().is_running() : robot.was_reset()) continue;
    throw Failure(TASKC_ERROR_WRONG_ORDER,
                  fmt::format("no episode runs in environment {}: reset it first", i));
  }
}

void taskc_sim::CheckActions(const float* actions) const {
  const size_t size = description().action_size;
  for (size_t i = 0; i < robots_.size() * size; ++i) {
    if (std::isfinite(actions[i])) continue;
    throw Failure(TASKC_ERROR_OUT_OF_RANGE,
                  fmt::format("element {} of the action of environment {} is {}: it must be finite",
                              i % size, i / size, actions[i]));
  }
}

libtaskc_sim::Results taskc_sim::ResultsOf(size_t environment,
                                           const taskc_sim_arrays& arrays) const {
  const taskc_sim_description& about = description();
  return {RowOf(arrays.observations, environment, about.observation_size),
          RowOf(arrays.final_observations, environment, about.observation_size),
          RowOf(arrays.rewards, environment, 1),
          RowOf(arrays.terminated, environment, 1),
          RowOf(arrays.truncated, environment, 1),
          RowOf(arrays.term_sums, environment, about.task->term_count)};
}

void taskc_sim::ThrowFailure() {
  std::exception_ptr first;
  for (RobotInTask& robot : robots_) {
    const std::exception_ptr failure = robot.TakeFailure();
    if (first == nullptr) first = failure;
  }
  if (first != nullptr) std::rethrow_exception(first);
}

const RobotInTask& taskc_sim::Robot(taskc_uint32 environment) const {
  if (environment < robots_.size()) return robots_[environment];
  throw Failure(
      TASKC_ERROR_OUT_OF_RANGE,
      fmt::format("there is no environment {}: they are 0 to {}", environment, robots_.size() - 1));
}

taskc_sim_episode taskc_sim::LastEpisode(taskc_uint32 environment) const {
  const RobotInTask& robot = Robot(environment);
  if (!robot.has_record()) {
    throw Failure(TASKC_ERROR_WRONG_ORDER,
                  fmt::format("no episode has ended in environment {}", environment));
  }
  return EpisodeOf(robot);
}

void taskc_sim::LastEnds(const taskc_sim_ends& ends) const {
  const EndColumns columns(ends, *description().task, robots_.size());
  for (size_t i = 0; i < robots_.size(); ++i) {
    if (robots_[i].has_ended()) {
      columns.Write(i, EpisodeOf(robots_[i]));
    } else {
      columns.Clear(i);
    }
  }
}

void taskc_sim::Render(taskc_uint32 environment, taskc_uint32 size, unsigned char* rgb) {
  const runtime::DecisionProcess& process = Robot(environment).process();
  CheckRange("size", size, kSmallestPicture, kLargestPicture);
  if (process.number() == 0) {
    throw Failure(
        TASKC_ERROR_WRONG_ORDER,
        fmt::format("nothing is to be seen in environment {}: reset it first", environment));
  }
  pictures_.Draw(environment, process, static_cast<int>(size), rgb);
}
