// The lines of CSV files as spreadsheets write them: commas between the cells, blanks around them,
// quotes about some.
#pragma once

#include <string_view>
#include <system_error>
#include <vector>

namespace text {

// Each without blanks and quotes; all point into `line`. There is always at least one.
std::vector<std::string_view> CellsOf(std::string_view line);

// invalid_argument where the whole cell is no number, result_out_of_range where a double cannot
// hold it; `number` then says nothing. `nan` and `inf` are numbers.
std::errc ReadNumber(std::string_view cell, double& number);

}  // namespace text
