#pragma once

#include <taskc/host.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "libtaskc/sensor_run.h"
#include "plugins/host/task_frame.h"

namespace libtaskc {

// A host's function, and where it writes.
struct SensorCall {
  taskc_sensor_function function = nullptr;
  void* user = nullptr;
  void* to = nullptr;
};

// How some sensors are brought up to date, but those that are read where they are.
struct SensorReadings {
  std::vector<Run> runs;
  std::vector<SensorCall> calls;

  bool is_empty() const { return runs.empty() && calls.empty(); }
  // As they are at a row of a recording; 0 where there is none.
  void Load(ptrdiff_t row) const {
    for (const Run& run : runs) run.CopyAt(row);
    for (const SensorCall& call : calls) call.function(call.user, call.to);
  }
};

// Where the sensors of one instance get their numbers. Binding allocates, reading does not.
class SensorSources {
 public:
  // Fills the sensors of `frame`, which must outlive this.
  explicit SensorSources(host::TaskFrame& frame);
  SensorSources(const SensorSources&) = delete;
  SensorSources& operator=(const SensorSources&) = delete;

  // See taskc_bind(), taskc_bind_function(), taskc_column. Throw Failure, and change nothing then.
  void Bind(const char* sensor, const char* unit, const taskc_view& view,
            ptrdiff_t time_stride = 0);
  void BindFunction(const char* sensor, const char* unit, taskc_sensor_function function,
                    void* user);

  // `readers`: a bit for each event, TASKC_MEASURE and TASKC_OBSERVE.
  // Throws Failure if there is no source for what one of them reads.
  void RequireFor(taskc_uint32 readers) const;
  // What `readers` read and `others` do not.
  SensorReadings ReadingsFor(taskc_uint32 readers, taskc_uint32 others = 0) const;

  // Of each sensor that is read where it is: from one time step to the next [bytes]; of others 0.
  std::vector<ptrdiff_t> TimeStrides() const;

  // Brings up to date what one reader reads.
  void Refresh(taskc_int32 reader) const { readings_[static_cast<size_t>(reader)].Load(0); }

 private:
  // What fills a sensor, or an entry of it.
  struct Filling {
    bool is_bound = false;
    const void* in_place = nullptr;  // or:
    std::vector<Run> runs{};         // or:
    SensorCall call{};
    ptrdiff_t time_stride = 0;
  };
  struct Source {
    explicit Source(const taskc_sensor& sensor) : elements(host::SizeInBytes(sensor)) {}

    Filling whole;              // or:
    std::vector<Filling> rows;  // one for each entry
    host::AlignedBytes elements;
  };

  const taskc_sensor& SensorAt(size_t index) const { return frame_.plugin().sensors[index]; }
  std::byte* ElementsOf(const Target& target);
  void Set(const Target& target, Filling filling);
  void AddReadings(size_t sensor, SensorReadings& readings) const;
  std::vector<std::string> MissingOf(size_t sensor) const;

  host::TaskFrame& frame_;
  std::vector<Source> sources_;  // one for each sensor
  std::array<SensorReadings, TASKC_READER_COUNT> readings_;
};

}  // namespace libtaskc
