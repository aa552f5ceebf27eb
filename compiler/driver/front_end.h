// From a file to a checked task, with everything that is wrong with it said on standard error.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/source/diagnostic.h"
#include "compiler/source/source_file.h"

namespace compiler {

class FrontEnd {
 public:
  // `robots`: where to look for robots first; may be empty.
  explicit FrontEnd(std::filesystem::path robots);

  struct Result {
    SourceFile source;
    std::optional<CheckedTask> task;  // nothing: there were errors
  };
  // Throws CallError where the file cannot be read, robot::DescriptionError where the robot's file
  // is wrong.
  Result Check(const std::string& file);

  // "2 errors, 1 warning" in all files so far; empty where there was neither.
  std::string Summary() const;

 private:
  std::optional<CheckedTask> CheckSource(const SourceFile& source, Diagnostics& diagnostics) const;
  void Report(const SourceFile& source, const Diagnostics& diagnostics);

  std::filesystem::path robots_;
  bool color_ = false;
  int errors_ = 0;
  int warnings_ = 0;
};

}  // namespace compiler
