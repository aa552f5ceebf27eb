// A debugger that is attached to the trainer steps through the task's own file.
#include <fmt/format.h>

#include "tests/runtime/trainer/trainer_test.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class DebuggerTest : public TrainerTest {
 protected:
  // What gdb prints when it runs the trainer with these commands. `./setup.sh --tests` installs
  // gdb.
  std::string Debug(const std::vector<std::string>& commands) const {
    std::vector<std::string> words = {"/usr/bin/env", "gdb", "-nx", "-batch"};
    for (const std::string& command : commands) {
      words.insert(words.end(), {"-ex", command});
    }
    words.insert(words.end(), {"--args", TRAINER});
    for (const std::string& word : Training("run", 1, {"--quiet"})) words.push_back(word);
    return RunProgram(words).output;
  }
};

TEST_F(DebuggerTest, StopsInALineOfTheTask) {
  // The line with `if not moved and steps > 3`.
  const std::string output = Debug(
      {"set breakpoint pending on", "break leaning.task:25", "run", "next", "info source", "kill"});
  EXPECT_THAT(output,
              AllOf(HasSubstr("end_of_time_step"), HasSubstr("leaning.task:25\n"),
                    HasSubstr("25\t    if not moved and steps > 3 {"),
                    HasSubstr("29\t    if any(contact[body, head, hands]) {"),
                    HasSubstr(fmt::format("Current source file is {}", TaskFile("leaning")))));
}

}  // namespace
}  // namespace runtime
