// What is wrong with a URDF file that MuJoCo takes without a word, or refuses without saying where.
#pragma once

#include <string>
#include <vector>

#include "runtime/import/xml_text.h"

namespace runtime {

struct UrdfProblem {
  size_t place = 0;       // in the text
  std::string text;       // with what to do about it
  bool is_error = false;  // else it is taken over otherwise than it is written
};

// In the order of their places.
std::vector<UrdfProblem> ProblemsOfUrdf(const XmlText& text);

}  // namespace runtime
