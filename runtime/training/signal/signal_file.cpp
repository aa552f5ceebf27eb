#include "runtime/training/signal/signal_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/file/read.h"
#include "base/text/cells.h"
#include "base/text/trim.h"
#include "runtime/base/program_starter.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

// A run records what the file holds.
constexpr size_t kMostBytes = 1'000'000;

// "m/s" of "wish [m/s]"; "" where there are no brackets.
std::string_view UnitOf(std::string_view heading) {
  const size_t open = heading.find('[');
  if (open == std::string_view::npos || !heading.ends_with(']')) return "";
  return text::Trimmed(heading.substr(open + 1, heading.size() - open - 2));
}

class SignalFileReader {
 public:
  explicit SignalFileReader(const std::filesystem::path& file) : file_(file) {}

  SignalFile Read() {
    file::Reading reading = ReadTable(file_, kMostBytes + 1);
    if (!reading.problem.empty())
      throw UserError(fmt::format("`{}` cannot be read: {}", file_.string(), reading.problem));
    if (reading.bytes.size() > kMostBytes)
      throw UserError(fmt::format(
          "`{}` has more than {} bytes: sample the signal less often, a run records all of it",
          file_.string(), kMostBytes));
    for (std::string_view rest = reading.bytes; !rest.empty();) {
      const size_t end = std::min(rest.find('\n'), rest.size());
      ReadLine(text::Trimmed(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (read_.samples.empty()) Fail("there are no rows of numbers below the headings");
    return std::move(read_);
  }

 private:
  [[noreturn]] void Fail(const std::string& message) const {
    throw UserError(fmt::format("{}:{}: {}", file_.string(), line_, message));
  }

  void ReadLine(std::string_view line) {
    ++line_;
    if (line.empty()) return;
    const std::vector<std::string_view> cells = text::CellsOf(line);
    if (read_.elements == 0) return ReadHeadings(cells);
    if (cells.size() != 1 + read_.elements)
      Fail(fmt::format("there are {} columns here, and {} headings", cells.size(),
                       1 + read_.elements));
    for (const std::string_view cell : cells) read_.samples.push_back(NumberIn(cell));
    const size_t row = read_.samples.size() - cells.size();
    if (row > 0 && read_.samples[row] <= read_.samples[row - cells.size()])
      Fail("the times must ascend, and this is no later than the one above");
  }

  void ReadHeadings(const std::vector<std::string_view>& headings) {
    if (UnitOf(headings[0]) != "s")
      Fail(fmt::format("the first heading is `{}`: write `time [s]`", headings[0]));
    if (headings.size() == 1) Fail("there is only a time: add a column for each element");
    read_.elements = headings.size() - 1;
    read_.unit = UnitOf(headings[1]);
    for (size_t i = 2; i < headings.size(); ++i)
      if (UnitOf(headings[i]) != read_.unit)
        Fail(fmt::format("`{}` and `{}` have two units: a sensor has one", headings[1],
                         headings[i]));
  }

  double NumberIn(std::string_view cell) const {
    double number = 0;
    if (cell.empty()) Fail("there is an empty cell: write a number");
    if (text::ReadNumber(cell, number) != std::errc() || !std::isfinite(number))
      Fail(fmt::format("`{}` is not a finite number", cell));
    return number;
  }

  const std::filesystem::path& file_;
  int line_ = 0;
  SignalFile read_;
};

}  // namespace

SignalFile ReadSignalFile(const std::filesystem::path& file) {
  return SignalFileReader(file).Read();
}

void CheckSamples(const std::vector<double>& samples, size_t elements, std::string_view name) {
  const size_t columns = 1 + elements;
  if (samples.empty() || samples.size() % columns != 0) {
    throw UserError(
        fmt::format("`{}` holds {} numbers, and not {} for each row: the time, and {} element{}",
                    name, samples.size(), columns, elements, elements == 1 ? "" : "s"));
  }
  for (size_t i = columns; i < samples.size(); i += columns) {
    if (samples[i] > samples[i - columns]) continue;
    throw UserError(fmt::format("the times in `{}` must ascend, and {} s is no later than {} s",
                                name, samples[i], samples[i - columns]));
  }
}

}  // namespace runtime
