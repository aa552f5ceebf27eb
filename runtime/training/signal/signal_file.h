// What a signal is in the course of time, as a CSV file tells it.
//
//   time [s], wish [m/s]
//   0, 0.2
//   2.5, 0.5
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

struct SignalFile {
  std::vector<double> samples;  // row by row: the time [s], which ascends, then the elements
  size_t elements = 0;          // in each row
  std::string unit;             // in the brackets of all their headings; "": there are none
};

// Throws UserError, with the line and the remedy, for whatever is wrong with the file.
SignalFile ReadSignalFile(const std::filesystem::path& file);

// Throws UserError, which calls them `name`, where `samples` are no such rows.
void CheckSamples(const std::vector<double>& samples, size_t elements, std::string_view name);

}  // namespace runtime
