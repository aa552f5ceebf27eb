// Golden files: an output is compared with the reviewed one, which is a file of its own or stands
// behind its input (golden_file.h). With the environment variable UPDATE_GOLDEN=1 the tests write
// the files instead; the changes are then reviewed as a diff.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/golden_file.h"

namespace golden {

// Whole file as text; an absent file is empty and fails the test.
inline std::string ReadFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) ADD_FAILURE() << "cannot read " << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// The files of a folder whose names begin and end as given, sorted; at least one must exist.
inline std::vector<std::filesystem::path> FilesIn(const std::filesystem::path& folder,
                                                  std::string_view prefix,
                                                  std::string_view suffix) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename();
      if (name.starts_with(prefix) && name.ends_with(suffix)) files.push_back(entry.path());
    }
  }
  EXPECT_FALSE(files.empty()) << "no " << prefix << "*" << suffix << " in " << folder;
  std::sort(files.begin(), files.end());
  return files;
}

// The test fails where `actual` is not what the golden file holds.
inline void Expect(const std::filesystem::path& file, const std::string& actual) {
  const char* update = std::getenv("UPDATE_GOLDEN");
  if (update != nullptr && std::string_view(update) == "1") {
    std::ofstream(file, std::ios::binary) << actual;
    return;
  }
  EXPECT_EQ(actual, ReadFile(file)) << file << "\nUPDATE_GOLDEN=1 writes what is there now";
}

// The input in a file that may also hold what is expected of it.
inline std::string ReadInput(const std::filesystem::path& file) {
  return Split(file, ReadFile(file)).input;
}

// The test fails where `actual` is not what stands behind the input. The input stays as it is.
inline void ExpectBehindInput(const std::filesystem::path& file, const std::string& actual) {
  const std::string input = ReadInput(file);
  ASSERT_TRUE(input.ends_with('\n')) << file << ": an input ends with the end of a line";
  Expect(file, input + Section(file, actual));
}

}  // namespace golden
