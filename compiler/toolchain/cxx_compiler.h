// The C++ compiler that turns emitted text into plugins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace compiler {

struct CxxCompiler {
  std::vector<std::string> command;  // its path, then arguments that the user gave in CXX
  std::string identity;              // differs between two compilers, or two versions of one
};

// What the environment variable CXX says; g++ or c++ from PATH where it is not set. Throws
// CallError where there is none.
CxxCompiler FindCxxCompiler();

// The arguments, but for input, output and the folder of the ABI header.
const std::vector<std::string>& PluginFlags();

// What comes after the input and the output.
const std::vector<std::string>& PluginLibraries();

}  // namespace compiler
