// The parts of the programs that must cope with anything, each as a function of a text. They check
// what must hold for every text, and abort where it does not. There are two lists, in a library
// each: those of the compiler (targets.cpp) and those of the trainer (runtime_targets.cpp).
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

struct Target {
  const char* name;
  bool (*run)(const std::string& text);  // whether there was nothing wrong with the text
  std::vector<std::string> (*corpus)();
  std::vector<std::string> (*words)();
};

// Aborts, and says why.
void Require(bool condition, const char* what);

// There is a tree, or there are errors; each error can be shown.
bool Parse(const std::string& text);
// A task that is right can be emitted and evaluated.
bool Check(const std::string& text);
// The file of a table, of each kind of type: as Check.
bool Table(const std::string& text);
// A formatted text is in its layout already, and no less right than it was.
bool Format(const std::string& text);

const std::vector<Target>& Targets();
// Ends the program where there is no target of this name.
const Target& FindTarget(std::string_view name);

}  // namespace fuzz
