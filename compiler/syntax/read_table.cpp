#include "compiler/syntax/read_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/text/utf8.h"

namespace compiler {
namespace {

// A file that is no table at all could have as many mistakes as lines.
constexpr size_t kMostMessages = 5;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool IsBlank(char c) { return c == ' ' || c == '\t'; }

// A cell or a line, and where it begins in the file.
struct Piece {
  std::string_view text;
  uint32_t begin = 0;

  Span span() const { return {begin, begin + static_cast<uint32_t>(text.size())}; }
  Piece Part(size_t from, size_t count) const {
    return {text.substr(from, count), begin + static_cast<uint32_t>(from)};
  }
};

Piece WithoutBlanks(Piece piece) {
  size_t first = 0;
  size_t last = piece.text.size();
  while (first < last && IsBlank(piece.text[first])) ++first;
  while (last > first && IsBlank(piece.text[last - 1])) --last;
  return piece.Part(first, last - first);
}

// Spreadsheets put texts, and some programs everything, in quotes.
Piece WithoutQuotes(const Piece& cell) {
  const bool is_quoted =
      cell.text.size() > 1 && cell.text.starts_with('"') && cell.text.ends_with('"');
  return is_quoted ? WithoutBlanks(cell.Part(1, cell.text.size() - 2)) : cell;
}

std::vector<Piece> CellsOf(const Piece& line) {
  std::vector<Piece> cells;
  size_t begin = 0;
  while (true) {
    const size_t comma = line.text.find(',', begin);
    const size_t end = comma == std::string_view::npos ? line.text.size() : comma;
    cells.push_back(WithoutQuotes(WithoutBlanks(line.Part(begin, end - begin))));
    if (comma == std::string_view::npos) return cells;
    begin = comma + 1;
  }
}

// Nothing where the text is no number; one that is too large where a `real` cannot hold it.
std::optional<double> NumberIn(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? 2 * kLargestTableNumber : number;
}

class TableReader {
 public:
  TableReader(const SourceFile& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  std::optional<TableFile> Read() {
    if (!IsText()) return std::nullopt;
    bool has_header = false;
    for (uint32_t number = 1; number <= source_.line_count() && messages_ < kMostMessages;
         ++number) {
      const Piece line = WithoutBlanks(Line(number));
      if (line.text.empty()) continue;
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
  Piece Line(uint32_t number) const {
    Piece line{source_.Line(number), source_.LineStart(number)};
    if (number == 1 && line.text.starts_with(kByteOrderMark))
      line = line.Part(kByteOrderMark.size(), std::string_view::npos);
    return line;
  }

  // For what is wrong with all of it.
  Span FirstLine() const { return WithoutBlanks(Line(1)).span(); }

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

  bool ReadHeader(const Piece& line) {
    const std::vector<Piece> cells = CellsOf(line);
    if (cells.size() < 2) {
      ReportOneColumn(line);
      return false;
    }
    if (std::ranges::all_of(cells,
                            [](const Piece& cell) { return NumberIn(cell.text).has_value(); })) {
      Report(code::kNotATable, line.span(), "the first line of a table names its columns",
             "write a line such as `time [s], x [m], y [m], z [m]` above the numbers");
      return false;
    }
    for (const Piece& cell : cells) ReadColumn(cell);
    return messages_ == 0;
  }

  void ReportOneColumn(const Piece& line) {
    const bool has_other = line.text.find_first_of(";\t") != std::string_view::npos;
    Report(code::kNotATable, line.span(), "a table has a column of arguments and others beside it",
           line.text.starts_with('#') ? "leave out the comment: a table has none"
           : has_other                ? "put commas between the cells, and points into the numbers"
                       : "write a line such as `time [s], height [m]`, and the numbers below it");
  }

  void ReadColumn(const Piece& cell) {
    TableColumn column{.name = std::string(cell.text), .span = cell.span()};
    const size_t open = cell.text.find('[');
    if (open != std::string_view::npos) {
      const Piece unit = cell.Part(open, std::string_view::npos);
      column.name = WithoutBlanks(cell.Part(0, open)).text;
      column.unit_span = unit.span();
      if (!unit.text.ends_with(']'))
        return Report(code::kColumnUnit, unit.span(), "the unit has no closing bracket",
                      "write it as in `time [s]`");
      column.unit = WithoutBlanks(unit.Part(1, unit.text.size() - 2)).text;
    }
    const size_t parenthesis = cell.text.rfind('(');
    const bool has_parentheses = parenthesis != std::string_view::npos && cell.text.ends_with(')');
    if (has_parentheses) return ReportParentheses(cell.Part(parenthesis, std::string_view::npos));
    if (column.name.empty())
      return Report(code::kBadColumn, cell.span(), "this column has no name",
                    "the first line names every column");
    table_.columns.push_back(std::move(column));
  }

  // `time (s)`
  void ReportParentheses(const Piece& unit) {
    const std::string right = fmt::format("[{}]", unit.text.substr(1, unit.text.size() - 2));
    Report(code::kColumnUnit, unit.span(), "units stand in square brackets",
           {fmt::format("write `{}`", right), {{unit.span(), right}}});
  }

  // ---- Rows ----

  // False: there is no sense in reading on.
  bool ReadRow(const Piece& line) {
    const std::vector<Piece> cells = CellsOf(line);
    if (cells.size() != table_.columns.size()) {
      ReportCellCount(line, cells.size());
      return true;
    }
    if (table_.numbers.size() + cells.size() > kMostTableNumbers) {
      Report(code::kNotATable, line.span(),
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
    table_.rows.push_back(line.span());
    CheckOrder(cells.front());
    return true;
  }

  void ReportCellCount(const Piece& line, size_t count) {
    const size_t wanted = table_.columns.size();
    Report(code::kBadRow, line.span(),
           fmt::format("this row has {} cell{}, and the table {} columns", count,
                       count == 1 ? "" : "s", wanted),
           count > wanted ? "each number has a point, and commas stand only between the cells"
                          : "give it a number for each column");
  }

  void ReadCell(const Piece& cell, const TableColumn& column) {
    const auto number = NumberIn(cell.text);
    table_.numbers.push_back(number.value_or(0));
    if (number && std::abs(*number) <= kLargestTableNumber) return;
    if (cell.text.empty()) {
      // There is nothing to point at but the comma before or behind it.
      const uint32_t comma = cell.begin - (&column == &table_.columns.front() ? 0 : 1);
      Report(code::kBadCell, {comma, comma + 1}, fmt::format("`{}` has no value here", column.name),
             "every row has a number in every column: fill the gap, or leave out the row");
    } else if (!number) {
      Report(code::kBadCell, cell.span(), "this is no number",
             "write numbers as in `-0.25` and `3e-4`, and units in the first line");
    } else {
      Report(code::kBadCell, cell.span(),
             std::isfinite(*number) ? "this number is too large or too close to 0"
                                    : "this is no finite number",
             fmt::format("the numbers of a table lie between -{0} and {0}", kLargestTableNumber));
    }
  }

  void CheckOrder(const Piece& argument) {
    const size_t count = table_.rows.size();
    if (count < 2 || table_.At(count - 2, 0) < table_.At(count - 1, 0)) return;
    const std::string& name = table_.columns.front().name;
    Diagnostic diagnostic =
        MakeDiagnostic(code::kUnsortedTable, argument.span(),
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
