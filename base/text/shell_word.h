#pragma once

#include <string>

namespace text {

// Between single quotes, as every shell reads it.
std::string ShellWord(const std::string& word);

}  // namespace text
