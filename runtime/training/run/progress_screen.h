// How a run goes, in a few lines at the bottom of a terminal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/training/run/live_text.h"
#include "runtime/training/run/return_history.h"

namespace runtime {

struct ProgressValues {
  int64_t episode = 0;  // finished so far
  int64_t episodes_planned = 0;
  double last_return = 0;
  double mean = 0;
  double best_return = 0;
  double simulated_seconds_per_second = 0;
  double elapsed = 0;    // [s]
  double remaining = 0;  // [s]
};

struct TermMean {
  std::string name;
  double mean = 0;  // of its sums per episode
};

struct ProgressPicture {
  ProgressValues values;
  ReturnHistory history;
  std::vector<TermMean> terms;
};

// "episode 12/1000  return -3.25  mean of 20 -4.1  best 1.5  4.2x real time  0:05 elapsed  6:40
// left". What does not fit into `columns` is left out, the elapsed time first, then the speed, the
// return, the best, the mean, and the time left.
std::string ProgressLine(const ProgressValues& values, size_t columns = kAnyWidth);

// The picture in lines of at most `columns`, at most `rows` of them, each with its '\n':
//
//   episode 340/1000  ███████████▌░░░░░░░░░░░░░░░░░░░░░  34 %  1:47 left
//   return 12.25  mean of 20 11.4  best 27.61  ▁▁▂▂▃▃▄▅▅▆▇▇█
//     forward  12.9  ██████████████
//     turning  -1.5  ▒▒
//   98.1x real time  0:55 elapsed
//
// Bars of what was taken are lighter. What has no room is left out: never a part of a number.
std::string ProgressScreen(const ProgressPicture& picture, size_t columns, size_t rows);

// "0:05", "6:40", "1:02:03"
std::string DurationText(double seconds);

}  // namespace runtime
