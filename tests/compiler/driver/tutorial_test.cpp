// docs/tutorial.md keeps its word: after each step its file stands as a whole, what the step shows
// of it is in it, and all that the page does with taskc can be done.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/compiler/driver/taskc_process.h"
#include "tests/golden.h"

namespace compiler {
namespace {

using testing::HasSubstr;

// What stands in a step, in its order: parts of the file, whole files, and lines that are typed or
// printed.
struct Item {
  enum Kind { kPart, kFile, kLine };
  Kind kind = kLine;
  std::string text;
};
using Step = std::vector<Item>;

bool IsFile(const std::string& code) { return code.starts_with("task "); }

std::vector<Step> StepsOf(const std::string& page) {
  std::vector<Step> steps(1);
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) {
      steps.emplace_back();
    } else if (line == "```task") {
      std::string code;
      while (std::getline(lines, line) && line != "```") code += line + "\n";
      steps.back().push_back({IsFile(code) ? Item::kFile : Item::kPart, code});
    } else if (line.starts_with("    ")) {
      steps.back().push_back({Item::kLine, line.substr(4)});
    } else if (const size_t call = line.find("`taskc "); call != std::string::npos) {
      steps.back().push_back(
          {Item::kLine, line.substr(call + 1, line.find('`', call + 1) - call - 1)});
    }
  }
  return steps;
}

// Without the indentation, by which a part differs from the same lines inside of a block.
std::string Unindented(const std::string& code) {
  std::string text = "\n";
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    const size_t begin = line.find_first_not_of(' ');
    text += (begin == std::string::npos ? "" : line.substr(begin)) + "\n";
  }
  return text;
}

std::string NameOf(const std::string& file) {
  const size_t begin = std::string("task ").size();
  return file.substr(begin, file.find(' ', begin) - begin) + ".task";
}

// Follows the page from its top to its end.
class Reader {
 public:
  Reader() { std::filesystem::create_directory_symlink(SOURCE_DIR "/tasks", taskc_.path("tasks")); }

  void Follow(const Step& step) {
    for (const Item& item : step) {
      if (item.kind == Item::kPart) parts_.push_back(item.text);
      if (item.kind == Item::kFile) Save(item.text);
      if (item.kind == Item::kLine) Do(item.text);
    }
    EXPECT_TRUE(parts_.empty()) << "stands in no file: " << parts_.front();
  }

  int files() const { return files_; }
  int commands() const { return commands_; }

 private:
  void Save(const std::string& file) {
    ++files_;
    for (const std::string& part : parts_) {
      EXPECT_THAT(Unindented(file), HasSubstr(Unindented(part)));
    }
    parts_.clear();
    taskc_.Write(NameOf(file), file);
    checked_ = taskc_.Run("check " + NameOf(file));
    EXPECT_EQ(checked_.status, 0) << checked_.error << file;
    const bool is_unfinished = files_ == 1;  // the first three lines: no episode ends
    EXPECT_EQ(checked_.error.empty(), !is_unfinished) << checked_.error << file;
    const Outcome built = taskc_.Run("build " + NameOf(file));
    EXPECT_EQ(built.status, 0) << built.error << file;
  }

  void Do(const std::string& line) {
    if (line.starts_with("warning[")) {
      EXPECT_THAT(checked_.error, HasSubstr(line));
    }
    if (!line.starts_with("taskc ")) return;
    ++commands_;
    const Outcome outcome = taskc_.Run(line.substr(std::string("taskc ").size()));
    EXPECT_EQ(outcome.status, 0) << line << "\n" << outcome.out << outcome.error;
  }

  TaskcProcess taskc_;
  std::vector<std::string> parts_;  // that no file has shown yet
  Outcome checked_;                 // the file saved last
  int files_ = 0;
  int commands_ = 0;
};

TEST(Tutorial, StandsAfterEachStep) {
  Reader reader;
  for (const Step& step : StepsOf(golden::ReadFile(SOURCE_DIR "/docs/tutorial.md")))
    reader.Follow(step);
  EXPECT_EQ(reader.files(), 8);
  EXPECT_GE(reader.commands(), 6);
}

}  // namespace
}  // namespace compiler
