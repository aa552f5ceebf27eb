// The functions of a library, compiled and called with random values.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace library {

// What a function is called with.
struct Input {
  std::string name;
  std::string type;  // with its unit
  double low = 0;    // of the random values of each element
  double high = 1;
  bool is_unit = false;  // a vector or quaternion of length 1
};
using Values = std::map<std::string, std::vector<double>>;

// A call as a task writes it, and what it should give: computed in another way.
struct Call {
  std::string text;  // a number, which may have a unit
  std::function<double(const Values&)> expected;
};

// Each call gives what it should, to 1e-12, for 1,000 random inputs.
void ExpectEqual(const std::string& library, const std::vector<Input>& inputs,
                 const std::vector<Call>& calls);

}  // namespace library
