// Where a reward that is not finite comes from, and that nothing worse follows of it.
#include "compiler/task_tests/find_fault.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "compiler/task_tests/side_by_side.h"
#include "tests/compiler/task_tests/built_task.h"

namespace compiler {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// "log(x) is not a number, x is -1"
std::string Found(const std::string& statements, double x, double remembered = 0) {
  const CheckedSource source("faulty.task",
                             "task faulty\nsensor x: real\nsensor v: vec3\nsensor n: int\n"
                             "param gain: real = 2\nmemory kept: real = 0\n"
                             "fn root(a: real) -> real = sqrt(a - 1)\n"
                             "on end_of_time_step {\n" +
                                 statements +
                                 "\n  kept = x\n  if n > 5 { truncate_episode \"t\" }\n}\n");
  if (!source.task) return source.Messages();
  FaultySituation situation;
  situation.time_step = 0.005;
  situation.params = {2};
  for (const auto& sensor : source.task->sensors) {
    situation.sensors.emplace_back(sensor.type.size(), sensor.name == "x" ? x : 0.0);
  }
  for (const auto& memory : source.task->memory) {
    situation.memory.emplace_back(memory.type.size(), memory.name == "kept" ? remembered : 0.0);
  }
  const std::optional<FoundFault> found = FindFault(*source.task, situation);
  if (!found) return "paid";
  const auto text = [&](const ValueOfPart& part) {
    return fmt::format("{} is {}", source.sources.FileOf(part.span).TextOf(part.span), part.value);
  };
  std::string all = text(found->part);
  for (const ValueOfPart& operand : found->operands) all += ", " + text(operand);
  return all;
}

TEST(FindFault, NamesThePartThatIsWrongThoughWhatItReadsIsNot) {
  EXPECT_EQ(Found("reward a = 3 + gain * log(x)", -1), "log(x) is not a number, x is -1");
  EXPECT_EQ(Found("reward a = 1 / (n - 0) + x", 1), "1 / (n - 0) is infinity, (n - 0) is 0");
  EXPECT_EQ(Found("reward rate a = exp(x)", 1000), "exp(x) is infinity, x is 1000");
  EXPECT_EQ(Found("reward a = norm(v / x)", 0),
            "v / x is (not a number, not a number, not a number), v is (0, 0, 0), x is 0");
  EXPECT_EQ(Found("reward a = x", 3), "paid");
}

TEST(FindFault, LooksIntoLetsAndFunctions) {
  EXPECT_EQ(Found("let y = sqrt(x)\n  reward a = 2 * y", -4), "sqrt(x) is not a number, x is -4");
  EXPECT_EQ(Found("reward a = 1 + root(x)", 0), "sqrt(a - 1) is not a number, a - 1 is -1");
}

TEST(FindFault, NamesWhatWasWrongBefore) {
  EXPECT_EQ(Found("reward a = 1 + x", kNan), "x is not a number");
  EXPECT_EQ(Found("reward a = kept * 2", 0, kInfinity), "kept is infinity");
  EXPECT_EQ(Found("reward a = kept * 2\n  kept = 1", 0, kNan), "kept is not a number");
}

TEST(FindFault, PassesByWhatDoesNoHarm) {
  EXPECT_EQ(Found("reward a = min(1 / x, 3) + log(x - 1)", 0),
            "log(x - 1) is not a number, x - 1 is -1");
  EXPECT_EQ(Found("reward good = 1\n  reward a = log(x)", -1), "paid");  // another term
}

TEST(FindFault, RefusesASituationOfAnotherTask) {
  const CheckedSource source("other.task",
                             "task other\nsensor x: real\non end_of_time_step { "
                             "reward a = x\n truncate_episode \"t\" }\n");
  ASSERT_TRUE(source.task) << source.Messages();
  EXPECT_THROW(FindFault(*source.task, {}), CallError);
}

// Whatever sensors give: what is paid is finite, plugin and evaluator agree in every bit, and each
// term that is not paid has a part to blame.
TEST(Garbage, InAnySensorDoesNoHarm) {
  const BuiltTask built(R"(task built
after_end continue
sensor x: real
sensor v: vec3
sensor q: quat
sensor u: real[4]
sensor n: int
sensor c: bool[4]
param gain: real = 2
memory kept: real = 0
memory w: vec3 = 0 per action
metric max far = x
metric mean pace = norm(v)
fn root(a: real) -> real = sqrt(a - 1)
on start_of_action { w = v }
on end_of_time_step {
  let turned = rotate(q, v)
  reward rate a = gain * turned.x / norm(turned)
  reward b = root(x) + exp(u[1]) - log(u[2])
  reward c = dot(v, w) * kept * kept + sum(u) / (n + 1)
  if any(c) and x > kept { reward d = tanh(v.y / v.x) * abs(x) }
  kept = smooth(x, 0.1 s) + max(u) / 3
  log max height = v.z
  if n > 5 { truncate_episode "t" }
  if x > 1e6 { end_episode failure "far" }
}
)");
  const CheckedTask& task = built.task();
  std::mt19937 random(20);
  const double kinds[] = {0,         -0.0,       1,     -1,     0.5,    kNan,
                          kInfinity, -kInfinity, 1e308, -1e308, 5e-324, 1e30};
  int faults = 0;
  for (int episode = 0; episode < 60; ++episode) {
    SideBySide both(task, *built.plugin);
    for (int step = 0; step < 40; ++step) {
      FaultySituation situation;
      situation.time_step = 0.005;
      situation.params = both.evaluator().frame().params;
      for (uint32_t i = 0; i < task.sensors.size(); ++i) {
        std::vector<double>& numbers = situation.sensors.emplace_back();
        const bool is_real = task.sensors[i].type.scalar == Scalar::kReal;
        for (uint32_t k = 0; k < task.sensors[i].type.size(); ++k) {
          numbers.push_back(is_real ? kinds[random() % std::size(kinds)]
                                    : static_cast<double>(random() % 2));
        }
        both.SetSensor(i, MakeValue(task.sensors[i].type.scalar, numbers));
      }
      for (const Value& value : both.evaluator().frame().memory) {
        situation.memory.push_back(ToReals(value));
      }
      situation.event = step % 5 == 0 ? EventKind::kStartOfAction : EventKind::kEndOfTimeStep;
      ASSERT_NO_THROW(both.Fire(situation.event, situation.time_step));
      const Frame& frame = both.evaluator().frame();
      ASSERT_LE(std::abs(frame.reward), 1e30);
      for (const double sum : frame.terms) ASSERT_TRUE(std::isfinite(sum));
      if (frame.fault < 0) continue;
      ++faults;
      situation.term = static_cast<uint32_t>(frame.fault);
      ASSERT_TRUE(FindFault(task, situation)) << task.terms[situation.term].name;
    }
  }
  EXPECT_GT(faults, 200);
}

}  // namespace
}  // namespace compiler
