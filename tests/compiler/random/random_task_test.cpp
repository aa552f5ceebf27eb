#include "tests/compiler/random/random_task.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "compiler/check/builtins.h"

namespace compiler {
namespace {

// Else a function is in the list, and nothing compares what becomes of it.
TEST(RandomTasks, CallEveryFunction) {
  static const std::regex kCall("\\b([a-z0-9_]+)\\(");
  std::set<std::string> called;
  for (uint32_t seed = 1; seed <= 300; ++seed) {
    const std::string text = RandomTask(seed);
    for (std::sregex_iterator call(text.begin(), text.end(), kCall), end; call != end; ++call) {
      called.insert((*call)[1]);
    }
  }
  for (const std::string& name : BuiltinNames()) {
    EXPECT_TRUE(called.contains(name)) << name << ": add it to random_expression.cpp";
  }
}

}  // namespace
}  // namespace compiler
