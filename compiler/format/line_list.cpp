#include "compiler/format/line_list.h"

#include <algorithm>

#include "base/text/utf8.h"

namespace compiler {
namespace {

constexpr uint32_t kCommentDistance = 2;

}  // namespace

void LineList::Begin(uint32_t indentation, bool after_blank) {
  if (after_blank && !lines_.empty()) lines_.emplace_back();
  lines_.push_back({std::string(indentation, ' '), ""});
}

void LineList::Append(std::string_view text) { lines_.back().code += text; }

void LineList::AddTrailingComment(std::string_view comment) { lines_.back().comment = comment; }

uint32_t LineList::width() const {
  return lines_.empty() ? 0 : text::DisplayWidth(lines_.back().code);
}

std::string LineList::Join(std::string_view line_end) {
  AlignComments();
  std::string text;
  for (const Line& line : lines_) text.append(line.code).append(line.comment).append(line_end);
  return text;
}

void LineList::AlignComments() {
  for (auto first = lines_.begin(); first != lines_.end();) {
    const auto last =
        std::find_if(first, lines_.end(), [](const Line& line) { return line.comment.empty(); });
    uint32_t column = 0;
    for (auto line = first; line != last; ++line)
      column = std::max(column, text::DisplayWidth(line->code));
    for (auto line = first; line != last; ++line) {
      line->code.append(column + kCommentDistance - text::DisplayWidth(line->code), ' ');
    }
    first = last == lines_.end() ? last : last + 1;
  }
}

}  // namespace compiler
