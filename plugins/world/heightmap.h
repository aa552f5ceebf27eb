// Heights of the ground from files of other programs: numbers with commas between them (CSV), or a
// gray picture (PGM), whose brightness is the height.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace world {

struct HeightGrid {
  int columns = 0;
  int rows = 0;
  std::vector<double>
      values;             // row by row from the file's last line, as seen from above; none below 0
  int white = 0;          // of a picture, whose values are from 0 to 1; of numbers 0
  std::string problem{};  // why it is no grid of heights; empty: it is one
};

HeightGrid ParseHeights(std::string_view bytes);

// The same heights as text, since a compiled task holds nothing else: itself where it is one.
std::string TextOfHeights(std::string bytes);

}  // namespace world
