#include "runtime/training/run/live_text.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "base/text/print.h"
#include "base/text/utf8.h"

namespace runtime {
namespace {

winsize SizeOf(std::FILE* output) {
  winsize size{};
  ioctl(fileno(output), TIOCGWINSZ, &size);  // leaves zeros where there is no terminal
  return size;
}

// https://no-color.org asks for text without any control codes.
bool MayReplaceText() {
  const char* const no_color = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return (no_color == nullptr || *no_color == '\0') &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

// Rows that the lines take in a window of so many columns: terminals wrap what is there anew when
// their window gets narrower.
size_t RowsOf(std::string_view lines, size_t columns) {
  size_t rows = 0;
  while (!lines.empty()) {
    const size_t end = lines.find('\n');
    const size_t width = text::DisplayWidth(lines.substr(0, end));
    rows += std::max<size_t>(1, width / columns + (width % columns > 0 ? 1 : 0));
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
  }
  return rows;
}

}  // namespace

std::string FittingLine(const std::vector<LineField>& fields, size_t columns,
                        std::string_view between) {
  std::vector<size_t> by_rank(fields.size());
  std::iota(by_rank.begin(), by_rank.end(), 0);
  std::ranges::stable_sort(by_rank, {}, [&](size_t i) { return fields[i].rank; });
  std::vector<bool> is_shown(fields.size());
  size_t width = 0;
  for (const size_t i : by_rank) {
    const size_t with =
        width + (width > 0 ? between.size() : 0) + text::DisplayWidth(fields[i].text);
    if (fields[i].text.empty() || with > columns) continue;
    is_shown[i] = true;
    width = with;
  }
  std::string line;
  for (size_t i = 0; i < fields.size(); ++i) {
    if (is_shown[i]) line.append(line.empty() ? "" : between).append(fields[i].text);
  }
  return line;
}

LiveText::LiveText(std::FILE* output, bool is_wanted)
    : output_(output),
      is_on_terminal_(is_wanted && MayReplaceText() && isatty(fileno(output)) != 0) {}

size_t LiveText::columns() const {
  if (!is_on_terminal_) return kAnyWidth;
  const size_t columns = SizeOf(output_).ws_col;
  return columns > 1 ? columns - 1 : kAnyWidth;  // some terminals wrap a full line
}

size_t LiveText::rows() const {
  if (!is_on_terminal_) return kAnyWidth;
  const size_t rows = SizeOf(output_).ws_row;
  return rows > 0 ? rows : kAnyWidth;
}

// Line by line: some terminals keep a screen that is erased as a whole, and would keep each
// version.
void LiveText::Show(std::string lines) {
  constexpr std::string_view kEraseToTheRight = "\x1b[K";
  lines = text::Visible(lines);
  const size_t columns = SizeOf(output_).ws_col;
  const size_t before = RowsOf(shown_, columns > 0 ? columns : kAnyWidth);
  const size_t now = RowsOf(lines, kAnyWidth);
  std::string text = before > 0 ? fmt::format("\x1b[{}A\r", before) : "";
  for (const char c : lines) {
    if (c == '\n') text += kEraseToTheRight;
    text += c;
  }
  if (before > now) {
    for (size_t row = now; row < before; ++row) text.append(kEraseToTheRight).append("\n");
    text += fmt::format("\x1b[{}A", before - now);
  }
  fmt::print(output_, "{}", text);
  std::fflush(output_);
  shown_ = std::move(lines);
}

}  // namespace runtime
