#include "libtaskc/recorded_episode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "libtaskc/failure.h"

namespace libtaskc {
namespace {

constexpr taskc_uint32 Bit(int reader) { return 1u << reader; }
constexpr taskc_uint32 kTold = ~(Bit(TASKC_OBSERVE) | ~0u << TASKC_READER_COUNT);

// The readers that run in each time step.
taskc_uint32 ReadersOfTimeSteps(bool needs_measuring) {
  const taskc_uint32 events = kTold & ~Bit(TASKC_START_OF_EPISODE) & ~Bit(TASKC_END_OF_EPISODE);
  return needs_measuring ? events : events & ~Bit(TASKC_MEASURE);
}

const taskc_recording& Checked(const taskc_recording& recording) {
  const auto require = [](bool condition, const std::string& otherwise) {
    if (!condition) throw Failure(TASKC_ERROR_OUT_OF_RANGE, otherwise);
  };
  require(recording.rows > 0, fmt::format("a recording cannot have {} rows", recording.rows));
  require(recording.time_step >= 0 && std::isfinite(recording.time_step),
          fmt::format("a time step cannot have {} s", recording.time_step));
  require(recording.action_length >= 0,
          fmt::format("an action cannot have {} time steps", recording.action_length));
  if (recording.column_count > 0) RequirePointer(recording.columns, "the columns");
  return recording;
}

void Copy(std::span<const double> numbers, double* place) {
  if (place != nullptr) std::ranges::copy(numbers, place);
}

}  // namespace

RecordedEpisode::RecordedEpisode(const taskc_plugin& task, const Episode& like,
                                 const taskc_recording& recording)
    : task_(task),
      recording_(Checked(recording)),
      episode_(task),
      sensors_(episode_.frame()),
      rows_(Bound(recording_, episode_.frame(), sensors_)),
      first_(recording.begins_with_start != 0 ? 1 : 0),
      next_action_(first_) {
  const taskc_uint32 in_steps = ReadersOfTimeSteps(episode_.needs_measuring());
  of_time_steps_ = sensors_.ReadingsFor(in_steps);
  of_ends_ = sensors_.ReadingsFor(kTold, in_steps);
  CopySettings(like);
}

SensorRows RecordedEpisode::Bound(const taskc_recording& recording, host::TaskFrame& frame,
                                  SensorSources& sensors) {
  for (const taskc_column& column : std::span(recording.columns, recording.column_count))
    sensors.Bind(column.sensor, column.unit, column.view, column.time_stride);
  sensors.RequireFor(kTold);
  return {frame.sensors(), sensors.TimeStrides()};
}

void RecordedEpisode::CopySettings(const Episode& like) {
  std::ranges::copy(like.frame().params(), episode_.frame().params().begin());
  episode_.frame().SetDiscount(like.frame().frame().discount);
  episode_.frame().SetSeed(recording_.seed);
  episode_.Initialize();
  for (const taskc_goal& goal : std::span(task_.goals, task_.goal_count)) {
    if (!like.frame().IsHeld(goal)) continue;
    std::ranges::copy(like.frame().Bytes(goal), episode_.frame().Bytes(goal).begin());
    episode_.frame().Hold(goal, true);
  }
}

bool RecordedEpisode::StartsAction(taskc_int64 row) const {
  if (recording_.new_actions != nullptr) return row == first_ || recording_.new_actions[row] != 0;
  return row == next_action_;
}

bool RecordedEpisode::EndsAction(taskc_int64 row) const {
  return row + 1 == recording_.rows || StartsAction(row + 1);
}

void RecordedEpisode::Start() {
  of_ends_.Load(0);
  of_time_steps_.Load(0);
  episode_.Start(recording_.seed);
  if (first_ == 1) NoteRow(0);
}

// The sensors still show how the time step before has ended.
void RecordedEpisode::StartTimeStep(taskc_int64 row) {
  row_reward_ = 0;
  if (StartsAction(row)) {
    const taskc_int64 length = recording_.action_length;
    next_action_ += length > 0 ? std::min(length, recording_.rows) : recording_.rows;
    Tell(TASKC_START_OF_ACTION, 0);
  }
  Tell(TASKC_START_OF_TIME_STEP, recording_.time_step);
  Tell(TASKC_START_OF_PHYSICS_STEP, recording_.time_step);
}

void RecordedEpisode::EndTimeStep(taskc_int64 row) {
  if (row > 0) Show(row);
  Tell(TASKC_END_OF_PHYSICS_STEP, recording_.time_step);
  row_reward_ += episode_.Call(TASKC_END_OF_TIME_STEP, recording_.time_step).reward;
  if (episode_.needs_measuring()) episode_.Measure();
  ++time_steps_;
}

// An episode that ends at once leaves its last action unfinished.
bool RecordedEpisode::IsCutOff() const {
  return episode_.is_over() && recording_.ends_with_action == 0;
}

bool RecordedEpisode::GoesOnAfter(taskc_int64 row) const {
  if (!episode_.is_over()) return true;
  return recording_.ends_with_action != 0 && row >= first_ && !EndsAction(row);
}

void RecordedEpisode::NoteRow(taskc_int64 row) {
  if (recording_.rewards != nullptr) recording_.rewards[row] = row_reward_;
  if (recording_.term_sums != nullptr)
    Copy(episode_.frame().terms(), recording_.term_sums + row * task_.term_count);
}

void RecordedEpisode::FillAfter(taskc_int64 row) {
  if (recording_.rewards != nullptr)
    std::fill(recording_.rewards + row + 1, recording_.rewards + recording_.rows, 0.0);
  if (recording_.term_sums == nullptr) return;
  for (taskc_int64 next = row + 1; next < recording_.rows; ++next)
    Copy(episode_.frame().terms(), recording_.term_sums + next * task_.term_count);
}

// Whether nothing but the end of a time step is of interest in most of them.
bool RecordedEpisode::IsPlain() const {
  constexpr int kOthers[] = {TASKC_START_OF_TIME_STEP, TASKC_START_OF_PHYSICS_STEP,
                             TASKC_END_OF_PHYSICS_STEP};
  return task_.events[TASKC_END_OF_TIME_STEP] != nullptr && !episode_.needs_measuring() &&
         recording_.new_actions == nullptr && recording_.term_sums == nullptr &&
         std::ranges::none_of(kOthers, [&](int event) { return task_.events[event] != nullptr; });
}

// Those of `row` and up to the end of the action, unless the episode is over before. Gives back the
// last.
taskc_int64 RecordedEpisode::EndPlainTimeSteps(taskc_int64 row) {
  double* const rewards = recording_.rewards;
  double last_reward = 0;
  const auto show = [this, copies = !of_time_steps_.is_empty()](taskc_int64 next) {
    rows_.Advance();
    if (copies) of_time_steps_.Load(next);
  };
  const auto note = [&](taskc_int64 next, double reward) {
    last_reward = reward;
    if (rewards != nullptr) rewards[next] = reward;
  };
  const taskc_int64 end = std::min(next_action_, recording_.rows);
  const taskc_int64 next = episode_.EndTimeSteps(row, end, recording_.time_step, show, note);
  time_steps_ += next - row;
  // What the start of the action has paid belongs to its first row.
  if (rewards != nullptr) rewards[row] += row_reward_;
  row_reward_ = next - row == 1 ? row_reward_ + last_reward : last_reward;
  return next - 1;
}

void RecordedEpisode::Evaluate(taskc_evaluation& evaluation) {
  const bool is_plain = IsPlain();
  Start();
  taskc_int64 row = first_;
  while (row < recording_.rows && GoesOnAfter(row - 1)) {
    StartTimeStep(row);
    // The first row of all is shown already.
    if (is_plain && row > 0 && !episode_.is_over()) {
      row = EndPlainTimeSteps(row);
    } else {
      EndTimeStep(row);
    }
    if (EndsAction(row) && !IsCutOff()) Tell(TASKC_END_OF_ACTION, 0);
    NoteRow(row);
    ++row;
  }
  End(std::max<taskc_int64>(row - 1, 0));
  Report(evaluation);
}

void RecordedEpisode::End(taskc_int64 row) {
  of_ends_.Load(row);
  row_reward_ += episode_.End(TASKC_TRUNCATED).reward;
  episode_.Finish();
  NoteRow(row);
  FillAfter(row);
}

void RecordedEpisode::Report(taskc_evaluation& evaluation) const {
  evaluation.episode_return = episode_.episode_return();
  evaluation.time_steps = time_steps_;
  evaluation.fault_count = episode_.fault_count();
  evaluation.kind = episode_.kind();
  evaluation.end = episode_.end();
  evaluation.violation = episode_.violation();
  Copy(episode_.frame().terms(), evaluation.terms);
  Copy(episode_.counts().metrics(), evaluation.metrics);
  Copy(episode_.counts().logs(), evaluation.logs);
}

}  // namespace libtaskc
