#include "tests/library/functions.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "tests/compiler/emit/compiled_task.h"

namespace library {
namespace {

constexpr int kTimes = 1000;

size_t SizeOf(const std::string& type) {
  if (type.starts_with("vec")) return static_cast<size_t>(type[3] - '0');
  return type.starts_with("quat") ? 4 : 1;
}

// A task without a robot, which pays what each call gives.
std::string TaskOf(const std::string& library, const std::vector<Input>& inputs,
                   const std::vector<Call>& calls) {
  std::string text = fmt::format("task calls\nimport \"{}\"\n", library);
  for (const Input& input : inputs) text += fmt::format("sensor {}: {}\n", input.name, input.type);
  text += "on end_of_action {\n";
  for (size_t i = 0; i < calls.size(); ++i)
    text += fmt::format("  reward call{} = {}\n", i, calls[i].text);
  return text + "}\n";
}

// A task reads those inputs alone that its calls name.
bool Reads(const compiler::CompiledTask& task, const std::string& input) {
  const taskc_plugin& plugin = task.plugin();
  const std::span<const taskc_sensor> sensors(plugin.sensors, plugin.sensor_count);
  return std::ranges::find(sensors, input, &taskc_sensor::name) != sensors.end();
}

std::vector<double> Draw(const Input& input, std::mt19937_64& random) {
  std::vector<double> values(SizeOf(input.type));
  double squares = 0;
  for (double& value : values) {
    value = std::uniform_real_distribution(input.low, input.high)(random);
    if (input.type == "bool") value = value > 0 ? 1 : 0;
    squares += value * value;
  }
  if (input.is_unit)
    for (double& value : values) value /= std::sqrt(squares);
  return values;
}

}  // namespace

void ExpectEqual(const std::string& library, const std::vector<Input>& inputs,
                 const std::vector<Call>& calls) {
  const compiler::CompiledTask task(TaskOf(library, inputs, calls));
  compiler::Instance instance(task);
  std::mt19937_64 random(1);
  for (int n = 0; n < kTimes && !testing::Test::HasFailure(); ++n) {
    Values values;
    for (const Input& input : inputs) {
      values[input.name] = Draw(input, random);
      if (Reads(task, input.name)) instance.Sense(input.name, values[input.name]);
    }
    instance.ClearTerms();
    instance.Fire(TASKC_END_OF_ACTION);
    for (size_t i = 0; i < calls.size(); ++i) {
      const double expected = calls[i].expected(values);
      EXPECT_NEAR(instance.Term(fmt::format("call{}", i)), expected,
                  1e-12 * std::max(1.0, std::abs(expected)))
          << calls[i].text;
    }
  }
}

}  // namespace library
