// A task as text, checked, built and loaded.
#pragma once

#include <stdexcept>
#include <string>

#include "compiler/emit/emit.h"
#include "compiler/task_tests/loaded_plugin.h"
#include "compiler/toolchain/build_plugin.h"
#include "tests/compiler/check/checked_source.h"
#include "tests/compiler/temporary_folder.h"

namespace compiler {

struct BuiltTask {
  explicit BuiltTask(const std::string& text)
      : checked("built.task", text),
        plugin(BuildPlugin("built", Emit(task(), checked.sources), cache.path()).plugin) {}

  const CheckedTask& task() const {
    if (!checked.task) throw std::runtime_error(checked.Messages());
    return *checked.task;
  }

  TemporaryFolder cache;
  CheckedSource checked;
  LoadedPlugin plugin;
};

}  // namespace compiler
