// The host's side of the contract in plugins/abi/taskc/plugin.h: what one instance of a compiled
// task works on.
//
// A host loads the shared object (plugin.h), makes a TaskFrame of the table that it returns, says
// where the sensors' data is, and calls `Initialize()`. From then on it calls an event whenever it
// happens and reads what that did from `frame()`:
//
//   host::TaskFrame task(table);
//   task.sensor(0) = &time;
//   task.Initialize();
//   task.Clear();                                    // an episode starts
//   if (task.Call(TASKC_END_OF_TIME_STEP, 0.005)) reward += task.frame().reward;
//
// Lists are indexed like those of the table, and so are the indices in the frame. Units are SI.
// Nothing here throws but the constructor (std::bad_alloc), and nothing but it allocates. One
// instance belongs to one thread at a time; any number of them may run side by side.
#pragma once

#include <taskc/plugin.h>

#include <cstddef>
#include <span>
#include <vector>

namespace host {

// Bytes of one scalar (TASKC_BOOL, TASKC_INT or TASKC_REAL) in memory; 0 for any other code.
constexpr size_t ScalarSize(taskc_int32 scalar) {
  switch (scalar) {
    case TASKC_BOOL:
      return 1;
    case TASKC_INT:
      return sizeof(taskc_int64);
    case TASKC_REAL:
      return sizeof(double);
    default:
      return 0;
  }
}

// Bytes of all elements of a sensor or a variable.
template <class Entry>
constexpr size_t SizeInBytes(const Entry& entry) {
  return ScalarSize(entry.scalar) * entry.rows * entry.columns;
}

// A block of at least `size` bytes, all 0, aligned to 16 as the ABI wants it.
class AlignedBytes {
 public:
  explicit AlignedBytes(size_t size) : blocks_((size + sizeof(Block) - 1) / sizeof(Block)) {}

  std::byte* data() { return reinterpret_cast<std::byte*>(blocks_.data()); }
  const std::byte* data() const { return reinterpret_cast<const std::byte*>(blocks_.data()); }

 private:
  struct alignas(16) Block {
    std::byte bytes[16];
  };
  std::vector<Block> blocks_;
};

// Owns a `taskc_frame` and all that it points to but the sensors' data.
class TaskFrame {
 public:
  // `plugin` is of this ABI's version, its tables make sense, and it stays loaded as long as this
  // object lives. Params have their initial values; sums, metrics, logs and memory are 0; sensors
  // are nowhere.
  explicit TaskFrame(const taskc_plugin& plugin);
  // The frame points into this object.
  TaskFrame(const TaskFrame&) = delete;
  TaskFrame& operator=(const TaskFrame&) = delete;

  const taskc_plugin& plugin() const { return plugin_; }

  // Where the data of a sensor is: `rows * columns` elements of its scalar type, in its unit. It is
  // the caller's, may change and move between calls, and must be there whenever a function is
  // called that reads the sensor (taskc_sensor.read_by).
  const void*& sensor(size_t index) { return sensors_[index]; }
  const void* sensor(size_t index) const { return sensors_[index]; }

  // All of them.
  std::span<const void*> sensors() { return sensors_; }

  // A double each, whatever their type. That they stay in their range is the caller's business.
  std::span<double> params() { return params_; }
  std::span<const double> params() const { return params_; }

  // The whole memory block, and the elements of one of the table's variables in it, row by row.
  std::span<std::byte> memory() { return {memory_.data(), plugin_.memory_size}; }
  std::span<std::byte> Bytes(const taskc_memory& variable) {
    return {memory_.data() + variable.offset, SizeInBytes(variable)};
  }
  std::span<const std::byte> Bytes(const taskc_memory& variable) const {
    return {memory_.data() + variable.offset, SizeInBytes(variable)};
  }

  // The value of a goal, row by row.
  std::span<std::byte> Bytes(const taskc_goal& goal) {
    return {memory_.data() + goal.offset, SizeInBytes(goal)};
  }
  std::span<const std::byte> Bytes(const taskc_goal& goal) const {
    return {memory_.data() + goal.offset, SizeInBytes(goal)};
  }
  // Whether the caller sets its value, so that it is not drawn; and how often it was drawn in this
  // episode.
  void Hold(const taskc_goal& goal, bool is_held) {
    memory_.data()[goal.held_offset] = std::byte{is_held};
  }
  bool IsHeld(const taskc_goal& goal) const {
    return memory_.data()[goal.held_offset] != std::byte{0};
  }
  taskc_int64 DrawCount(const taskc_goal& goal) const;
  // Draws in which of the table's poses the episode starts; the first where there is nothing to
  // draw.
  taskc_int32 DrawPose() {
    if (plugin_.draw_pose == nullptr) return 0;
    plugin_.draw_pose(Next(0));
    return frame_.pose;
  }
  // What the caller fills before DrawStart() with what the pose has, and finds changed then.
  std::span<double> Elements(const taskc_start_value& value) {
    return {reinterpret_cast<double*>(memory_.data() + value.offset), value.rows};
  }
  // `attempt`: how often it was drawn for this episode before.
  void DrawStart(taskc_uint32 attempt = 0) {
    frame_.attempt = attempt;
    if (plugin_.draw_start != nullptr) plugin_.draw_start(Next(0));
  }
  // Decides what is drawn; another one for each episode. At first 0.
  void SetSeed(taskc_uint64 seed) { frame_.seed = seed; }

  // Of a plugin with phases: the number of the present one, and how long it has been that [s].
  taskc_int64 PresentPhase() const;
  void SetPhase(taskc_int64 phase);
  void SetPhaseTime(double time);
  // The learner's, for one action; at first 1. May change at any time.
  void SetDiscount(double discount) { frame_.discount = discount; }
  // How the episode has ended (TASKC_SUCCESS ...), before `end_of_episode`; at first a limit.
  void SetOutcome(taskc_int32 outcome) { frame_.outcome = outcome; }

  // What was paid for each reward term and what was logged, since Clear(); what Measure() gave.
  std::span<double> terms() { return terms_; }
  std::span<const double> terms() const { return terms_; }
  std::span<const double> metrics() const { return metrics_; }
  std::span<taskc_log_state> logs() { return logs_; }
  std::span<const taskc_log_state> logs() const { return logs_; }
  // Forgets what was paid and logged, as at the start of an episode.
  void Clear();

  // Gives all memory its initial value. Precondition of the first Call() and Measure().
  void Initialize() {
    if (plugin_.initialize != nullptr) plugin_.initialize(Next(0));
  }
  // Tells the task of an event (TASKC_START_OF_EPISODE ...). `time_step`: length of the step that
  // starts or ends [s], 0 for other events. Returns whether the task does something then.
  bool Call(int event, double time_step) {
    taskc_frame* const frame = Next(time_step);
    if (plugin_.events[event] == nullptr) return false;
    plugin_.events[event](frame);
    return true;
  }
  // Brings the metrics up to date. Leaves alone what the last call did.
  void Measure() {
    if (plugin_.measure != nullptr) plugin_.measure(&frame_);
  }

  // Brings what the learner sees up to date; nothing where the task observes nothing.
  void Observe() {
    if (plugin_.observe != nullptr) plugin_.observe(&frame_);
  }
  std::span<double> observations() { return observations_; }
  std::span<const double> observations() const { return observations_; }

  // What the last call did: `reward`, `end`, `fault`, `violation`.
  const taskc_frame& frame() const { return frame_; }
  taskc_frame& frame() { return frame_; }
  // The frame as the ABI wants it before each call, for a host that calls the functions itself.
  taskc_frame* Next(double time_step) {
    frame_.time_step = time_step;
    frame_.reward = 0;
    frame_.end = -1;
    frame_.fault = -1;
    frame_.violation = -1;
    return &frame_;
  }

 private:
  const taskc_plugin& plugin_;
  std::vector<const void*> sensors_;
  std::vector<double> params_;
  AlignedBytes memory_;
  std::vector<double> terms_;
  std::vector<double> metrics_;
  std::vector<double> observations_;
  std::vector<taskc_log_state> logs_;
  taskc_frame frame_{};
};

}  // namespace host
