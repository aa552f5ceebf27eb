#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

namespace runtime {

// Stands where there is no number.
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// The mean of independent values, and what is known of it.
struct Estimate {
  int count = 0;    // of the values that are numbers
  double mean = 0;  // not a number without any
  double low = 0;   // confidence interval of 95 % (Student's t); not a number for less than three
  double high = 0;
  double least = 0;  // of the values
  double greatest = 0;
};

// Under the names of the members; what is not a number becomes null.
nlohmann::ordered_json ToJson(const Estimate& estimate);

// Values that are not numbers are left out.
Estimate EstimateMean(std::span<const double> values);

// The value in the middle, or the mean of both in the middle; values that are not numbers are left
// out, and without any it is none either.
double Median(std::vector<double> values);

}  // namespace runtime
