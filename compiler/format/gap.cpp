#include "compiler/format/gap.h"

#include <algorithm>

namespace compiler {

Gap ReadGap(std::string_view text) {
  Gap gap;
  while (true) {
    const size_t begin = std::min(text.find('/'), text.size());
    const auto breaks = static_cast<int>(std::ranges::count(text.substr(0, begin), '\n'));
    text.remove_prefix(begin);
    if (text.empty()) {
      gap.line_breaks = breaks;
      return gap;
    }
    const size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view comment = text.substr(0, end);
    comment = comment.substr(0, comment.find_last_not_of(" \t\f") + 1);
    gap.comments.push_back({comment, breaks});
    text.remove_prefix(end);
  }
}

}  // namespace compiler
