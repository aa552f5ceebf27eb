// Runs the tests that a task brings with it.
#pragma once

#include <filesystem>
#include <string>

#include "compiler/check/checked_task.h"
#include "compiler/source/sources.h"
#include "compiler/task_tests/test_report.h"

namespace compiler {

// Builds the task (see BuildPlugin) and runs its tests whose names contain `filter`. Throws
// InternalError where the plugin does not compute what the task says; the evidence holds the task,
// the C++ and what differs after which step. Throws CallError as BuildPlugin does.
TestReport TestTask(const CheckedTask& task, const Sources& sources, const std::string& filter,
                    const std::filesystem::path& cache);

}  // namespace compiler
