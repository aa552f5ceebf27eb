#include "runtime/core/module/context.h"

#include <fmt/format.h>

#include "runtime/base/user_error.h"

namespace runtime {

const robot::RobotDescription& RobotOf(const Context& context, const std::string& module) {
  if (!context.robot->name.empty()) return *context.robot;
  throw UserError(
      fmt::format("the module `{}` is made for a robot, and the task names none: name one, for "
                  "example `--robot humanoid`, or use an agent without a robot "
                  "(docs/environments.md)",
                  module));
}

}  // namespace runtime
