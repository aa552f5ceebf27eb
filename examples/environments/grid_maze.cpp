// A maze of cells: in each time step the walker goes to the next cell, unless a wall is there.
#include <array>
#include <cmath>
#include <string_view>

#include "runtime/core/module/module_library.h"
#include "runtime/training/environment/stepped_environment.h"

namespace {

// '#' is a wall, 'S' where an episode starts, 'G' the goal.
constexpr std::array<std::string_view, 8> kMap = {
    "##########",  //
    "#   #   G#",  //
    "# # #    #",  //
    "#S# ##   #",  //
    "# #  # ###",  //
    "#    #   #",  //
    "#        #",  //
    "##########",
};

char At(long long column, long long row) {
  return kMap[static_cast<size_t>(row)][static_cast<size_t>(column)];
}

class GridMaze : public runtime::SteppedEnvironment {
 public:
  // An action is a step along the columns and one along the rows, each from -1 to 1.
  GridMaze(std::string name, const runtime::Context& context)
      : SteppedEnvironment(std::move(name), context, 1.0,
                           {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1)}) {
    AddSensor("column", "int", "", &column_);
    AddSensor("row", "int", "", &row_);
    AddSensor("at_goal", "bool", "", &at_goal_);
  }

 private:
  void Begin(uint64_t) override {
    for (row_ = 0;; ++row_) {
      const size_t place = kMap[static_cast<size_t>(row_)].find('S');
      if (place == std::string_view::npos) continue;
      column_ = static_cast<long long>(place);
      break;
    }
    at_goal_ = false;
  }

  void Step(const Eigen::VectorXd& action) override {
    const long long column = column_ + std::llround(action[0]);
    const long long row = row_ + std::llround(action[1]);
    if (At(column, row) == '#') return;
    column_ = column;
    row_ = row;
    at_goal_ = At(column, row) == 'G';
  }

  long long column_ = 0;
  long long row_ = 0;
  bool at_goal_ = false;
};

}  // namespace

TASKC_MODULES(types) { types.Add<GridMaze>("GridMaze"); }
