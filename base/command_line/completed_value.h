// What shells complete where a command line wants a value.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace command_line {

struct CompletedValue {
  std::vector<std::string> words{};
  std::string names{};  // the name of a list that the program prints: "ROBOT"
  bool has_files = false;
  std::vector<std::string> suffixes{};  // of these files: ".task"; none: of any
  bool has_folders = false;
};

// What the declarations cannot say, by the names of values: {"CODE", {"E0101"}}.
using ValueWords = std::map<std::string, std::vector<std::string>>;
// The same for what is not known before the tab key is pressed: {"ROBOT", RobotNames}; or of one
// command alone: {"ctl swap NAME", TaskModules}. Each gets the words of the line so far. A name
// that ends in `=` is the beginning of a word.
using ValueNames =
    std::map<std::string,
             std::function<std::vector<std::string>(const std::vector<std::string>& line)>>;

struct ValueLists {
  ValueWords words{};
  ValueNames names{};
};

// By the name that the help shows for the value, or for an argument: "text|json" are these words,
// "FILE.task" and "PLAN.task" files that end so, "DIR" folders, "ROBOT|FILE.toml" either.
CompletedValue ValueCalled(const std::string& name, const ValueLists& lists);

// The value of the option among the words of a line, also as "--run=DIR", which Bash takes apart at
// the sign; "" without.
std::string ValueOf(const std::string& option, const std::vector<std::string>& line);

}  // namespace command_line
