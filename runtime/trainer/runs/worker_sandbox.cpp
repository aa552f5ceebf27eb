#include "runtime/trainer/runs/worker_sandbox.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "runtime/base/build_task.h"
#include "runtime/base/program_starter.h"
#include "runtime/base/user_error.h"
#include "runtime/live/server/loopback.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

bool IsInTemporaryFolder(const fs::path& file) {
  std::error_code error;
  const fs::path folder = fs::canonical(fs::temp_directory_path(error), error);
  const fs::path parent = fs::canonical(file.parent_path(), error);
  return !error && (parent / "").string().starts_with((folder / "").string());
}

// `taskc build TASK -o PLUGIN [--robots DIR] [--text FILE]`: the plugin goes where this process may
// write itself.
bool MayBuild(const std::vector<std::string>& words) {
  if (words.size() < 5 || words.size() % 2 == 0 || words[2].starts_with('-')) return false;
  if (words[3] != "-o" || !IsInTemporaryFolder(words[4])) return false;
  for (size_t i = 5; i < words.size(); i += 2) {
    if (words[i] != "--robots" && words[i] != "--text") return false;
  }
  return true;
}

// `trainer rescore RUN --task PLUGIN --episode N --json`: it enters a sandbox of its own.
bool MayRescore(const std::vector<std::string>& words) {
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  return words.size() == 8 && !words[2].starts_with('-') && words[3] == "--task" &&
         IsInTemporaryFolder(words[4]) && words[5] == "--episode" &&
         std::ranges::all_of(words[6], is_digit) && words[7] == "--json";
}

// What the sandbox's other side starts: the compiler, where it writes nothing but a plugin, and
// what judges a recorded episode by another task.
bool MayStartOutside(const std::vector<std::string>& words) {
  if (words.size() < 2) return false;
  if (words[0] == fs::read_symlink("/proc/self/exe"))
    return words[1] == "rescore" && MayRescore(words);
  if (words[0] != CompilerProgram()) return false;
  if (words[1] == "build") return MayBuild(words);
  if (words[1] == "lsp") return words.size() == 4 && words[2] == "--robots";
  return words[1] == "fault" && words.size() == 7 && words[4] == "--robots" && words[6] == "--json";
}

}  // namespace

WorkerSandbox::WorkerSandbox(const SessionOptions& session)
    : is_wanted_(session.in_sandbox && IsSandboxWanted()) {
  try {
    loopback_ = ListenOnLoopback(session.port);
  } catch (const UserError&) {
    if (session.port != 0) throw;  // else the server says that there is none, and the run goes on
  }
}

void WorkerSandbox::Enter(const SandboxRules& rules) {
  rules_ = rules;
  if (!is_wanted_) return;
  rules_.files.writable.push_back(fs::temp_directory_path());  // which the guard has made for us
  StartProgramsOutside(MayStartOutside);
  EnterSandbox(rules_);
}

void WorkerSandbox::NarrowTo(const fs::path& folder) const {
  if (!is_wanted_) return;
  FileRules files = rules_.files;
  files.writable.front() = folder;
  RestrictFilesMore(files);
}

}  // namespace runtime
