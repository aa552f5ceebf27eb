// The real `taskc`, run on real files.
#pragma once

#include <filesystem>
#include <string>

#include "tests/compiler/temporary_folder.h"

namespace compiler {

struct Outcome {
  int status = 0;  // exit status; 128 + n where signal n ended it
  std::string out;
  std::string error;
};

// A folder to work in, with its own cache, and `taskc` run inside it.
class TaskcProcess {
 public:
  // `arguments` are words of a shell, which may redirect the standard output. `environment` is
  // written before the command: "CXX=x".
  Outcome Run(const std::string& arguments, const std::string& environment = "") const;

  // Writes a file into the folder.
  void Write(const std::string& name, const std::string& text) const;
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

// A task without any mistake.
inline constexpr const char* kGoodTask = R"(task good for humanoid
on end_of_time_step {
  reward rate up = base.position.z / 1 m
  if time > 2 s { truncate_episode "time is up" }
}
)";

}  // namespace compiler
