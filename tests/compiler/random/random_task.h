// Random tasks, all of them right: each seed gives the text of another one.
#pragma once

#include <cstdint>
#include <string>

namespace compiler {

std::string RandomTask(uint32_t seed);

// The same of a task for the humanoid that does nothing but draw its start.
std::string RandomStart(uint32_t seed);

}  // namespace compiler
