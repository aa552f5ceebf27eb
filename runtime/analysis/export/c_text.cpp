#include "runtime/analysis/export/c_text.h"

#include <fmt/format.h>

#include <cmath>

namespace runtime {

std::string CComment(std::string_view text) {
  std::string safe(text);
  for (char& c : safe) {
    if (static_cast<unsigned char>(c) < 0x20 || c == '\\' || c == '?') c = '_';
  }
  return safe;
}

std::string CLiteral(float value) {
  if (std::isinf(value)) return value > 0 ? "INFINITY" : "-INFINITY";
  std::string text = fmt::to_string(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

std::string CArray(const std::string& name, const Eigen::VectorXf& elements) {
  constexpr size_t kWidth = 100;
  std::string text = fmt::format("\nstatic const float {}[{}] = {{", name, elements.size());
  size_t column = kWidth;
  for (const float element : elements) {
    const std::string word = CLiteral(element) + ",";
    if (column + 1 + word.size() > kWidth) {
      text += "\n   ";
      column = 3;
    }
    text += " " + word;
    column += 1 + word.size();
  }
  return text + "\n};\n";
}

}  // namespace runtime
