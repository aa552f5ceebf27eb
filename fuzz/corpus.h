// What the fuzzers begin with.
#pragma once

#include <string>
#include <vector>

namespace fuzz {

// The files with this ending in these folders of the project, "/plugins", and below; without what
// tests expect of them.
std::vector<std::string> TextsIn(const std::vector<const char*>& folders, const char* ending);

// All tasks of the project: those that are learned and those of the tests, right and wrong ones.
std::vector<std::string> TaskTexts();

// The words of the language: those of its grammar and of its tables, and some that are none.
std::vector<std::string> TaskWords();

// Files of tables, right and wrong ones, and what they are made of.
std::vector<std::string> TableTexts();
std::vector<std::string> TableWords();

}  // namespace fuzz
