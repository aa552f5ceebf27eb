// Names as tasks can write them.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

// Names of links, of joints or of sites: each is used once.
class Names {
 public:
  // `wanted` with underscores for what no name has, an underscore behind what would be a word of
  // the task language, and a number behind what is taken. `fallback`: for what has no name.
  std::string Take(std::string_view wanted, std::string_view fallback);

  // "`left foot` as `left_foot`", for each that tasks cannot write as it was.
  const std::vector<std::string>& renamed() const { return renamed_; }

 private:
  std::vector<std::string> renamed_;
  std::set<std::string> taken_;
};

// The name of the same part of the robot's other side, for a name of its left: "l_knee" gives
// "r_knee". Empty for all others.
std::string OnTheRight(const std::string& name);

}  // namespace runtime
