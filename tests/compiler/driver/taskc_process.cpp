#include "tests/compiler/driver/taskc_process.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdlib>

#include "compiler/toolchain/file_io.h"

namespace compiler {

Outcome TaskcProcess::Run(const std::string& arguments, const std::string& environment) const {
  std::filesystem::path streams = folder_.path() / "streams";
  std::filesystem::create_directories(streams);
  std::string command = fmt::format(
      "cd '{0}' && env -u CXX -u NO_COLOR -u TASKC_ROBOT_PATH TASKC_CACHE='{0}/cache' {1} "
      "'{2}' >'{3}/out' 2>'{3}/error' {4}",
      folder_.path().string(), environment, TASKC, streams.string(), arguments);
  int status = std::system(command.c_str());
  return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .out = ReadWholeFile(streams / "out").value_or(""),
          .error = ReadWholeFile(streams / "error").value_or("")};
}

void TaskcProcess::Write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories(path(name).parent_path());
  WriteWholeFile(path(name), text);
}

}  // namespace compiler
