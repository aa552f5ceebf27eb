#include "runtime/base/sandbox.h"

#include <fmt/format.h>
#include <link.h>
#include <stdlib.h>
#include <sys/prctl.h>

#include <cerrno>
#include <cstring>

#include "base/file/search_path.h"
#include "base/text/print.h"
#include "runtime/base/system_call_filter.h"
#include "runtime/base/user_error.h"

namespace runtime {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoSandbox = "TASKC_NO_SANDBOX";
constexpr const char* kIsTold = "TASKC_SANDBOX_TOLD";

constexpr const char* kSystemFiles[] = {"/usr",
                                        "/lib",
                                        "/lib32",
                                        "/lib64",
                                        "/etc/localtime",
                                        "/etc/timezone",
                                        "/proc",
                                        "/etc/ld.so.cache",
                                        "/dev/random",
                                        "/dev/urandom",
                                        "/sys/devices/system"};
constexpr const char* kDevices[] = {"/dev/null", "/dev/zero", "/dev/full"};

int AddName(dl_phdr_info* object, size_t /*size*/, void* files) {
  if (object->dlpi_name[0] == '/')
    static_cast<std::vector<fs::path>*>(files)->emplace_back(object->dlpi_name);
  return 0;
}

// What the programs themselves need, wherever they are installed.
FileRules WithTheSystem(FileRules rules) {
  std::vector<fs::path>& readable = rules.readable;
  readable.insert(readable.end(), std::begin(kSystemFiles), std::end(kSystemFiles));
  rules.writable.insert(rules.writable.end(), std::begin(kDevices), std::end(kDevices));
  readable.push_back(file::SharedFolder());
  readable.push_back(fs::read_symlink("/proc/self/exe"));
  dl_iterate_phdr(AddName, &readable);
  for (fs::path& folder : file::SearchPath("LD_LIBRARY_PATH", "")) {
    readable.push_back(std::move(folder));
  }
  return rules;
}

}  // namespace

bool IsSandboxWanted() { return getenv(kNoSandbox) == nullptr; }

void DoWithoutSandbox() { setenv(kNoSandbox, "1", 1); }

void WarnWhereSandboxIsWeak() {
  if (!IsSandboxWanted() || getenv(kIsTold) != nullptr) return;
  const bool has_files = LandlockVersion() > 0;
  const bool has_calls = HasSystemCallFilter();
  if (!has_files) {
    text::Print(stderr,
                "warning: this kernel has no Landlock (5.13 has it): a task's plugin can read and "
                "write all files that you can; train only with plugins that you trust\n");
  }
  if (!has_calls) {
    text::Print(stderr,
                "warning: this kernel cannot filter system calls: a task's plugin can reach the "
                "network; train only with plugins that you trust\n");
  }
  if (!has_files || !has_calls) setenv(kIsTold, "1", 1);
}

void EnterSandbox(const SandboxRules& rules) {
  if (!IsSandboxWanted()) return;
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
    throw UserError(fmt::format("the sandbox cannot be entered: {}; `--no-sandbox` does without it",
                                std::strerror(errno)));
  }
  RestrictFiles(WithTheSystem(rules.files));
  RestrictSystemCalls(rules.may_connect);
}

void RestrictFilesMore(const FileRules& rules) { RestrictFiles(WithTheSystem(rules)); }

}  // namespace runtime
