// Text that stays up to date on a terminal, fitted to its width.
#pragma once

#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace runtime {

inline constexpr size_t kAnyWidth = std::numeric_limits<size_t>::max();

// A part of a line that is shown whole or not at all: a number that is cut is another number.
struct LineField {
  std::string text;
  int rank = 0;  // the smaller, the sooner it gets a place
};

// The fields in their order with `between` between them: those that fit into `columns`, each chosen
// after all of smaller ranks. Empty where none fits.
std::string FittingLine(const std::vector<LineField>& fields, size_t columns,
                        std::string_view between = "  ");

// Lines at the bottom of a terminal that are replaced again and again. The cursor stands below
// them: whatever ends the program, the next prompt has a line of its own.
class LiveText {
 public:
  // `output` is not owned. Where `is_wanted` is false, or the user wants nothing replaced (by
  // NO_COLOR or TERM=dumb in the environment), a terminal is treated as a file is.
  explicit LiveText(std::FILE* output, bool is_wanted = true);

  bool is_on_terminal() const { return is_on_terminal_; }
  // At present; the window may change. Without a terminal there is any room.
  size_t columns() const;
  size_t rows() const;

  // Takes the place of what was shown. `lines` end in '\n' each.
  void Show(std::string lines);
  void Erase() { Show(""); }
  // What is shown stays; the next text comes below it.
  void Leave() { shown_.clear(); }

 private:
  std::FILE* output_;
  const bool is_on_terminal_;
  std::string shown_;
};

}  // namespace runtime
