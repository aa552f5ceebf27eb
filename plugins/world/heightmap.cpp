#include "plugins/world/heightmap.h"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <vector>

#include "base/text/cells.h"
#include "base/text/trim.h"

namespace world {
namespace {

constexpr int kMost = 256;                // heights in a row, and rows
constexpr double kHighest = 1000;         // [m]
constexpr size_t kMostBytes = 1'000'000;  // of a file: the compiler reads no more of it

HeightGrid Problem(std::string what) {
  HeightGrid grid;
  grid.problem = std::move(what);
  return grid;
}

bool IsSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// Rows from the file's first to its last line become rows from the last to the first.
void TurnOver(HeightGrid& grid) {
  std::vector<double> turned;
  for (int row = grid.rows; row-- > 0;) {
    const auto begin = grid.values.begin() + static_cast<ptrdiff_t>(row) * grid.columns;
    turned.insert(turned.end(), begin, begin + grid.columns);
  }
  grid.values = std::move(turned);
}

HeightGrid Checked(HeightGrid grid) {
  if (grid.columns < 2 || grid.rows < 2) return Problem("it needs at least 2 rows of 2 heights");
  if (grid.columns > kMost || grid.rows > kMost)
    return Problem(fmt::format("it has {} x {} heights, and {} x {} are the most", grid.columns,
                               grid.rows, kMost, kMost));
  TurnOver(grid);
  return grid;
}

// Adds the numbers of a line. Returns what is wrong with it.
std::string AddLine(std::string_view line, size_t number, HeightGrid& grid) {
  const std::vector<std::string_view> cells = text::CellsOf(line);
  const int columns = static_cast<int>(cells.size());
  for (const std::string_view cell : cells) {
    double height = 0;
    if (text::ReadNumber(cell, height) != std::errc())
      return fmt::format("line {}: `{}` is not a number", number, cell);
    if (!(height >= 0 && height <= kHighest))
      return fmt::format("line {}: the height {} is not between 0 and {} m", number, cell,
                         kHighest);
    grid.values.push_back(height);
  }
  if (grid.rows > 0 && columns != grid.columns)
    return fmt::format("line {} has {} heights, and the lines above have {}", number, columns,
                       grid.columns);
  grid.columns = columns;
  ++grid.rows;
  return "";
}

HeightGrid ParseNumbers(std::string_view text) {
  HeightGrid grid;
  for (size_t number = 1; !text.empty(); ++number) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text::Trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    if (std::string problem = AddLine(line, number, grid); !problem.empty())
      return Problem(std::move(problem));
    if (grid.rows > kMost) break;
  }
  return Checked(std::move(grid));
}

// The numbers of a picture's head, or of its body as text.
class Words {
 public:
  explicit Words(std::string_view bytes) : bytes_(bytes) {}

  // -1 where there is none.
  int Next() {
    while (!bytes_.empty() && (IsSpace(bytes_.front()) || bytes_.front() == '#')) {
      if (bytes_.front() == '#') bytes_.remove_prefix(std::min(bytes_.find('\n'), bytes_.size()));
      if (!bytes_.empty()) bytes_.remove_prefix(1);
    }
    int number = -1;
    const auto [end, error] = std::from_chars(bytes_.data(), bytes_.data() + bytes_.size(), number);
    if (error != std::errc() || number < 0) return -1;
    bytes_.remove_prefix(static_cast<size_t>(end - bytes_.data()));
    return number;
  }
  // What comes after the one space that ends the head.
  std::string_view Rest() const { return bytes_.substr(std::min<size_t>(1, bytes_.size())); }

 private:
  std::string_view bytes_;
};

HeightGrid ParsePicture(std::string_view bytes) {
  const bool is_text = bytes[1] == '2';
  Words words(bytes.substr(2));
  HeightGrid grid;
  grid.columns = words.Next();
  grid.rows = words.Next();
  const int white = grid.white = words.Next();
  if (grid.columns < 0 || grid.rows < 0 || white < 1 || white > 65535)
    return Problem("the head of the picture is damaged");
  if (grid.columns > kMost || grid.rows > kMost) return Checked(std::move(grid));
  const size_t count = static_cast<size_t>(grid.columns) * static_cast<size_t>(grid.rows);
  const size_t width = white > 255 ? 2 : 1;
  const std::string_view body = words.Rest();
  if (!is_text && body.size() < count * width) return Problem("the picture is cut off");
  for (size_t i = 0; i < count; ++i) {
    int level = 0;
    if (is_text) {
      level = words.Next();
    } else {
      for (size_t k = 0; k < width; ++k)
        level = 256 * level + static_cast<unsigned char>(body[i * width + k]);
    }
    if (level < 0) return Problem("the picture is cut off");
    if (level > white) return Problem("the picture has a pixel that is brighter than white");
    grid.values.push_back(static_cast<double>(level) / white);
  }
  return Checked(std::move(grid));
}

}  // namespace

HeightGrid ParseHeights(std::string_view bytes) {
  if (bytes.size() > kMostBytes)
    return Problem(fmt::format("it has more than {} bytes", kMostBytes));
  if (bytes.starts_with("P2") || bytes.starts_with("P5")) return ParsePicture(bytes);
  return ParseNumbers(bytes);
}

std::string TextOfHeights(std::string bytes) {
  if (!bytes.starts_with("P5")) return bytes;
  const HeightGrid grid = ParseHeights(bytes);
  if (!grid.problem.empty()) return "P2\n";  // no picture either
  std::string text = fmt::format("P2\n{} {}\n{}\n", grid.columns, grid.rows, grid.white);
  for (int row = grid.rows; row-- > 0;) {
    for (int column = 0; column < grid.columns; ++column) {
      const double value = grid.values[static_cast<size_t>(row * grid.columns + column)];
      text += fmt::format("{}{}", column == 0 ? "" : " ", std::lround(grid.white * value));
    }
    text += '\n';
  }
  return text;
}

}  // namespace world
