// What a recorded episode paid, measured and touched, frame by frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/training/run/run_records.h"

namespace runtime {

// Samples: one at each frame of the recording, and one at the end of the episode.
struct Timeline {
  double end = 0;  // of the episode [s]
  // What was paid since the sample before; for the first one, up to then. So the sums over all
  // samples are the episode's return and those of its terms.
  std::vector<float> returns;
  std::vector<std::vector<float>> terms;  // [term][sample]
  // [metric][sample]: what it was then; of one that is summed, the sum up to then. Not a number
  // before the first time step.
  std::vector<std::vector<float>> metrics;
  std::vector<float> phases;  // [sample]: the number of the present one; empty where there are none
  // [sample][link]: whether the link touched something, bit i % 8 of byte i / 8 for link i.
  std::vector<uint8_t> contacts;

  size_t sample_count() const { return returns.size(); }
};

// Bytes of the contacts of one sample.
constexpr size_t ContactBytes(size_t link_count) { return (link_count + 7) / 8; }

// As bytes, compressed (schema.sql).
std::string PackTimeline(const Timeline& timeline);

// That of a recording of `task`, which paid the learner, with a robot of `link_count` links. Throws
// UserError where it is damaged. Precondition: the recording has one.
Timeline ReadTimeline(const Recording& recording, const TaskRecord& task, size_t link_count);

}  // namespace runtime
