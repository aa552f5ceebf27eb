#include "compiler/source/in_one_line.h"

#include <algorithm>

namespace compiler {

std::string InOneLine(std::string_view source) {
  std::string line;
  for (size_t i = 0; i < source.size(); ++i) {
    if (source.substr(i).starts_with("//")) i = std::min(source.find('\n', i), source.size() - 1);
    const bool is_space =
        source[i] == ' ' || source[i] == '\t' || source[i] == '\r' || source[i] == '\n';
    if (!is_space) line += source[i];
    if (is_space && !line.ends_with(' ')) line += ' ';
  }
  return line;
}

}  // namespace compiler
