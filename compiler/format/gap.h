// What stands between two tokens: blanks and comments.
#pragma once

#include <string_view>
#include <vector>

namespace compiler {

struct Comment {
  std::string_view text;  // with its slashes, without blanks at its end
  int line_breaks = 0;    // since the token or comment before it
};

struct Gap {
  std::vector<Comment> comments;
  int line_breaks = 0;  // after the last comment
};

// `text` holds nothing else.
Gap ReadGap(std::string_view text);

}  // namespace compiler
