// One call of `taskc`: what all its verbs share. Analyses tasks and says on standard error what is
// wrong with them.
#pragma once

#include <filesystem>
#include <string>

#include "compiler/analyze/analyze.h"
#include "compiler/source/diagnostic.h"

namespace compiler {

class Session {
 public:
  Session();

  // The task of a file; its errors and warnings are reported. Throws CallError where the file
  // cannot be read, robot::DescriptionError where the robot's file is wrong.
  Analysis Analyze(const std::string& file);

  // Says what is wrong with a file.
  void Report(const SourceFile& source, const Diagnostics& diagnostics);

  // After the last task: "2 errors, 1 warning" in all files, if there were any.
  void Finish() const;

  std::filesystem::path robots;  // where to look for robots first; may be empty

 private:
  bool color_ = false;
  int errors_ = 0;
  int warnings_ = 0;
};

}  // namespace compiler
