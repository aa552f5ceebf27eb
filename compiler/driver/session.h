// One call of `taskc`: what all its verbs share. Analyzes tasks and reports what is wrong with
// them, to a person or to another program.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "compiler/analyze/analyze.h"
#include "compiler/driver/exit_status.h"
#include "compiler/report/report.h"

namespace compiler {

class Session {
 public:
  // ---- Options that verbs share -----------------------------------------------------------------

  std::filesystem::path robots;     // where to look for robots first; may be empty
  std::filesystem::path text_file;  // holds the task's text; empty: its file does
  std::string format = "text";      // of the report: also "json" and "sarif"
  std::string color = "auto";       // of the text: also "always" and "never"

  // ---- What verbs do ----------------------------------------------------------------------------

  // The task of a file; its errors and warnings are reported. Throws CallError where the file
  // cannot be read, robot::DescriptionError where the robot's file is wrong.
  Analysis Analyze(const std::string& file);

  // On the standard output, for a person only: other programs get `Result`.
  void Say(std::string_view text) const;

  // Reports what is wrong with the files of a task, where a verb analyzes it by itself.
  void Report(const Sources& sources, const Diagnostics& diagnostics);

  // What became of the task reported last: a JSON object to which the verb adds.
  Json& Result();

  // A mistake in the call or in taskc, in one line. The verb may go on.
  void Fail(const std::string& message);

  // After the last task: the summary, or the whole report for another program.
  void Finish(ExitStatus status);

  // False: for another program.
  bool is_for_a_person() const { return format == "text"; }

 private:
  void PrintSummary() const;

  RunReport report_;
};

}  // namespace compiler
