// One `test` block, run.
#pragma once

#include <taskc/plugin.h>

#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/task_tests/expectation.h"

namespace compiler {

// An expectation that did not hold.
struct Failure {
  Span span;            // of the statement
  std::string message;  // where values do not say it: "the episode has not ended"
  std::vector<SeenValue> values;
};

struct TestResult {
  std::string name;
  Span span;  // of the name
  std::vector<Failure> failures;

  bool passed() const { return failures.empty(); }
};

// Goes on after an expectation that does not hold. Throws Disagreement where the plugin, which was
// made from the task, differs from the evaluator.
TestResult RunTest(const CheckedTest& test, const CheckedTask& task, const Sources& sources,
                   const taskc_plugin& plugin);

}  // namespace compiler
