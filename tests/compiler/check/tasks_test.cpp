// The tasks that come with the project.
#include "compiler/source/file_reader.h"
#include "tests/compiler/check/checked_source.h"
#include "tests/golden.h"

namespace compiler {
namespace {

TEST(ShippedTasks, ReadOnlyTheSensorsTheyNeed) {
  const std::string file = SOURCE_DIR "/tasks/forward_rolling.task";
  const CheckedSource checked(file, MustReadFromDisk(file));
  ASSERT_TRUE(checked.task) << checked.Messages();
  std::vector<std::string> names;
  for (const CheckedSensor& sensor : checked.task->sensors) names.push_back(sensor.name);
  EXPECT_EQ(names, (std::vector<std::string>{"time", "base.angular_velocity", "joint.torque"}));
}

}  // namespace
}  // namespace compiler
