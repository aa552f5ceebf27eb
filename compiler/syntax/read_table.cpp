#include "compiler/syntax/read_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/text/cells.h"
#include "base/text/trim.h"
#include "base/text/utf8.h"

namespace compiler {
namespace {

// A file that is no table at all could have as many mistakes as lines.
constexpr size_t kMostMessages = 5;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class TableReader {
 public:
  TableReader(const SourceFile& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  std::optional<TableFile> Read() {
    if (!IsText()) return std::nullopt;
    bool has_header = false;
    for (uint32_t number = 1; number <= source_.line_count() && messages_ < kMostMessages;
         ++number) {
      const std::string_view line = Line(number);
      if (line.empty()) continue;
      if (has_header) {
        if (!ReadRow(line)) break;
      } else if (!std::exchange(has_header, true) && !ReadHeader(line)) {
        break;
      }
    }
    if (messages_ == 0) CheckSize(has_header);
    if (messages_ > 0) return std::nullopt;
    return std::move(table_);
  }

 private:
  std::string_view Line(uint32_t number) const {
    std::string_view line = source_.Line(number);
    if (number == 1 && line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
    return text::Trimmed(line);
  }

  // Of a part of the file's text.
  Span SpanOf(std::string_view part) const {
    const auto begin =
        source_.first_offset() + static_cast<uint32_t>(part.data() - source_.text().data());
    return {begin, begin + static_cast<uint32_t>(part.size())};
  }

  // For what is wrong with all of it.
  Span FirstLine() const { return SpanOf(Line(1)); }

  // The whole file can be read as lines of text.
  bool IsText() {
    if (source_.text().size() > SourceFile::kMaxTableSize) {
      Report(code::kNotATable, FirstLine(),
             fmt::format("the table is larger than {} bytes", SourceFile::kMaxTableSize),
             "give it fewer rows: between two of them it is interpolated");
      return false;
    }
    const auto is_foreign = [](char c) {
      return static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t';
    };
    if (std::ranges::none_of(source_.text(), is_foreign) && text::IsUtf8(source_.text()))
      return true;
    Report(code::kNotATable, FirstLine(), "this is no text in UTF-8",
           "save it as CSV: a line of names and units, then lines of numbers");
    return false;
  }

  // ---- The first line ----

  bool ReadHeader(std::string_view line) {
    const std::vector<std::string_view> cells = text::CellsOf(line);
    if (cells.size() < 2) {
      ReportOneColumn(line);
      return false;
    }
    const auto is_number = [number = 0.](std::string_view cell) mutable {
      return text::ReadNumber(cell, number) != std::errc::invalid_argument;
    };
    if (std::ranges::all_of(cells, is_number)) {
      Report(code::kNotATable, SpanOf(line), "the first line of a table names its columns",
             "write a line such as `time [s], x [m], y [m], z [m]` above the numbers");
      return false;
    }
    for (const std::string_view cell : cells) ReadColumn(cell);
    return messages_ == 0;
  }

  void ReportOneColumn(std::string_view line) {
    const bool has_other = line.find_first_of(";\t") != std::string_view::npos;
    Report(code::kNotATable, SpanOf(line), "a table has a column of arguments and others beside it",
           line.starts_with('#') ? "leave out the comment: a table has none"
           : has_other           ? "put commas between the cells, and points into the numbers"
                       : "write a line such as `time [s], height [m]`, and the numbers below it");
  }

  void ReadColumn(std::string_view cell) {
    TableColumn column{.name = std::string(cell), .span = SpanOf(cell)};
    const size_t open = cell.find('[');
    if (open != std::string_view::npos) {
      const std::string_view unit = cell.substr(open);
      column.name = text::Trimmed(cell.substr(0, open));
      column.unit_span = SpanOf(unit);
      if (!unit.ends_with(']'))
        return Report(code::kColumnUnit, SpanOf(unit), "the unit has no closing bracket",
                      "write it as in `time [s]`");
      column.unit = text::Trimmed(unit.substr(1, unit.size() - 2));
    }
    const size_t parenthesis = cell.rfind('(');
    const bool has_parentheses = parenthesis != std::string_view::npos && cell.ends_with(')');
    if (has_parentheses) return ReportParentheses(cell.substr(parenthesis));
    if (column.name.empty())
      return Report(code::kBadColumn, SpanOf(cell), "this column has no name",
                    "the first line names every column");
    table_.columns.push_back(std::move(column));
  }

  // `time (s)`
  void ReportParentheses(std::string_view unit) {
    const std::string right = fmt::format("[{}]", unit.substr(1, unit.size() - 2));
    Report(code::kColumnUnit, SpanOf(unit), "units stand in square brackets",
           {fmt::format("write `{}`", right), {{SpanOf(unit), right}}});
  }

  // ---- Rows ----

  // False: there is no sense in reading on.
  bool ReadRow(std::string_view line) {
    const std::vector<std::string_view> cells = text::CellsOf(line);
    if (cells.size() != table_.columns.size()) {
      ReportCellCount(line, cells.size());
      return true;
    }
    if (table_.numbers.size() + cells.size() > kMostTableNumbers) {
      Report(code::kNotATable, SpanOf(line),
             fmt::format("the table has more than {} numbers", kMostTableNumbers),
             "give it fewer rows: between two of them it is interpolated");
      return false;
    }
    const size_t before = messages_;
    for (size_t i = 0; i < cells.size() && messages_ < kMostMessages; ++i)
      ReadCell(cells[i], table_.columns[i]);
    if (messages_ > before) {
      table_.numbers.resize(table_.rows.size() * cells.size());
      return true;
    }
    table_.rows.push_back(SpanOf(line));
    CheckOrder(cells.front());
    return true;
  }

  void ReportCellCount(std::string_view line, size_t count) {
    const size_t wanted = table_.columns.size();
    Report(code::kBadRow, SpanOf(line),
           fmt::format("this row has {} cell{}, and the table {} columns", count,
                       count == 1 ? "" : "s", wanted),
           count > wanted ? "each number has a point, and commas stand only between the cells"
                          : "give it a number for each column");
  }

  void ReadCell(std::string_view cell, const TableColumn& column) {
    double number = 0;
    const std::errc error = text::ReadNumber(cell, number);
    table_.numbers.push_back(number);
    if (error == std::errc() && std::abs(number) <= kLargestTableNumber) return;
    if (cell.empty()) {
      // There is nothing to point at but the comma before or behind it.
      const uint32_t comma = SpanOf(cell).begin - (&column == &table_.columns.front() ? 0 : 1);
      Report(code::kBadCell, {comma, comma + 1}, fmt::format("`{}` has no value here", column.name),
             "every row has a number in every column: fill the gap, or leave out the row");
    } else if (error == std::errc::invalid_argument) {
      Report(code::kBadCell, SpanOf(cell), "this is no number",
             "write numbers as in `-0.25` and `3e-4`, and units in the first line");
    } else {
      Report(code::kBadCell, SpanOf(cell),
             error == std::errc::result_out_of_range || std::isfinite(number)
                 ? "this number is too large or too close to 0"
                 : "this is no finite number",
             fmt::format("the numbers of a table lie between -{0} and {0}", kLargestTableNumber));
    }
  }

  void CheckOrder(std::string_view argument) {
    const size_t count = table_.rows.size();
    if (count < 2 || table_.At(count - 2, 0) < table_.At(count - 1, 0)) return;
    const std::string& name = table_.columns.front().name;
    Diagnostic diagnostic =
        MakeDiagnostic(code::kUnsortedTable, SpanOf(argument),
                       fmt::format("`{}` must grow from each row to the next", name));
    diagnostic.labels = {{table_.rows[count - 2], fmt::format("here it is {}", At(count - 2))}};
    diagnostic.help = table_.At(count - 2, 0) == table_.At(count - 1, 0)
                          ? "leave out one of the two rows"
                          : "sort the rows by it";
    Report(std::move(diagnostic));
  }

  std::string At(size_t row) const { return fmt::format("{}", table_.At(row, 0)); }

  void CheckSize(bool has_header) {
    if (table_.rows.size() >= 2) return;
    Report(code::kNotATable, FirstLine(),
           !has_header           ? "the table is empty"
           : table_.rows.empty() ? "the table has no rows"
                                 : "the table has a single row",
           "a table has a line of names and at least two rows of numbers");
  }

  void Report(std::string_view code, Span span, std::string message, Help help) {
    Diagnostic diagnostic = MakeDiagnostic(code, span, std::move(message));
    diagnostic.help = std::move(help);
    Report(std::move(diagnostic));
  }
  void Report(Diagnostic diagnostic) {
    ++messages_;
    diagnostics_.Add(std::move(diagnostic));
  }

  const SourceFile& source_;
  Diagnostics& diagnostics_;
  TableFile table_;
  size_t messages_ = 0;
};

}  // namespace

std::optional<TableFile> ReadTable(const SourceFile& source, Diagnostics& diagnostics) {
  return TableReader(source, diagnostics).Read();
}

}  // namespace compiler
