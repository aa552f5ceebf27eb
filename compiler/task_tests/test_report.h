// What the tests of a task gave.
#pragma once

#include <string>
#include <vector>

#include "compiler/source/sources.h"
#include "compiler/task_tests/test_run.h"

namespace compiler {

struct TestReport {
  std::vector<TestResult> results;  // in their order in the task

  size_t failed() const;
};

// A line for each test, with what failed below it.
std::string ToText(const TestReport& report, const Sources& sources);

}  // namespace compiler
