#include "runtime/analysis/preference/preferred_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "runtime/base/build_task.h"
#include "runtime/base/user_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

bool IsName(const std::string& text) {
  const auto is_letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) == 0 &&
         std::ranges::all_of(text, is_letter);
}

fs::path AgentFileOf(fs::path task) { return task.replace_extension(".agent.toml"); }

// `base` as seen from the folder of `file`.
std::string RelativeTo(const fs::path& file, const fs::path& base) {
  const fs::path folder = fs::weakly_canonical(fs::absolute(file)).parent_path();
  return fs::weakly_canonical(fs::absolute(base)).lexically_relative(folder).generic_string();
}

std::string TextOf(const PreferredTask& task) {
  std::string text = fmt::format("/// {}\ntask {} extends \"{}\"\n\n", task.description,
                                 task.file.stem().string(), RelativeTo(task.file, task.base));
  for (const ParamOverride& param : task.overrides) {
    text += fmt::format("override param {} = {}  // {}\n", param.name, param.value, param.note);
  }
  return text;
}

void CheckTarget(const PreferredTask& task, bool is_forced) {
  if (task.file.extension() != ".task" || !IsName(task.file.stem().string())) {
    throw UserError(fmt::format(
        "-o {}: expected a file such as crawling_preferred.task, whose name the task can have",
        task.file.string()));
  }
  if (fs::weakly_canonical(task.file) == fs::weakly_canonical(task.base)) {
    throw UserError(
        fmt::format("{} cannot extend itself; choose another name after -o", task.file.string()));
  }
  for (const fs::path& file : {task.file, AgentFileOf(task.file)}) {
    if (is_forced || !fs::exists(file)) continue;
    throw UserError(fmt::format(
        "{} already exists; choose another name, or overwrite it with --force", file.string()));
  }
}

}  // namespace

std::vector<fs::path> WritePreferredTask(const PreferredTask& task, bool is_forced) {
  CheckTarget(task, is_forced);
  const fs::path folder = fs::absolute(task.file).parent_path();
  std::error_code error;
  fs::create_directories(folder, error);  // a failure shows when the file is written
  const fs::path draft = folder / ("." + task.file.filename().string());
  WriteFile(draft, TextOf(task));
  std::string silence;
  if (!RunCompiler({"fmt", draft.string()}, silence) ||
      !RunCompiler({"check", draft.string()}, silence)) {
    fs::remove(draft);
    throw UserError(fmt::format("{} is not written, since taskc rejects it", task.file.string()));
  }
  fs::rename(draft, task.file);
  std::vector<fs::path> written = {task.file};
  const fs::path base_agent = AgentFileOf(task.base);
  if (fs::exists(base_agent)) {
    written.push_back(AgentFileOf(task.file));
    WriteFile(written.back(),
              fmt::format("# The same agent as that of the task it extends.\ninclude = [\"{}\"]\n",
                          RelativeTo(task.file, base_agent)));
  }
  return written;
}

}  // namespace runtime
