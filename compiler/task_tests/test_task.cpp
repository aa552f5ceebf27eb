#include "compiler/task_tests/test_task.h"

#include <fmt/format.h>

#include "base/cache/entry_name.h"
#include "compiler/emit/emit.h"
#include "compiler/task_tests/loaded_plugin.h"
#include "compiler/task_tests/side_by_side.h"
#include "compiler/toolchain/build_plugin.h"
#include "compiler/toolchain/file_io.h"
#include "compiler/toolchain/internal_error.h"
#include "compiler/toolchain/plugin_cache.h"

namespace compiler {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Accuse(const CheckedTask& task, const Sources& sources, const std::string& cpp,
                         const std::string& what, const fs::path& cache_folder) {
  const std::string key = sources.Hash().substr(0, 32);
  BuildFolder folder(fs::absolute(cache_folder), cache::UnfinishedName(task.name, key));
  for (size_t i = 0; i < sources.files().size(); ++i) {
    const std::string number = i == 0 ? "" : fmt::format("-{}", i);
    WriteWholeFile(folder.path() / fmt::format("{}{}.task", task.name, number),
                   sources.files()[i].text());
  }
  WriteWholeFile(folder.path() / "plugin.cpp", cpp);
  WriteWholeFile(folder.path() / "difference.txt", what + "\n");
  const fs::path evidence = fs::absolute(cache_folder / cache::DifferenceName(task.name, key));
  folder.KeepAs(evidence);
  throw InternalError(
      fmt::format("the plugin of `{}` does not compute what the task says: {}", task.name, what),
      evidence);
}

}  // namespace

TestReport TestTask(const CheckedTask& task, const Sources& sources, const std::string& filter,
                    const fs::path& cache) {
  const std::string cpp = Emit(task, sources);
  const LoadedPlugin plugin(BuildPlugin(task.name, cpp, cache).plugin);
  TestReport report;
  for (const CheckedTest& test : task.tests) {
    if (test.name.find(filter) == std::string::npos) continue;
    try {
      report.results.push_back(RunTest(test, task, sources, *plugin));
    } catch (const Disagreement& found) {
      Accuse(task, sources, cpp, fmt::format("in test \"{}\", {}", test.name, found.what()), cache);
    }
  }
  return report;
}

}  // namespace compiler
