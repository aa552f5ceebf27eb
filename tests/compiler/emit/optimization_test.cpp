// A task computes the same bits however well its C++ was optimized.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <span>

#include "tests/compiler/emit/compiled_task.h"
#include "tests/golden.h"

namespace compiler {
namespace {

// Everything with a last bit to lose: library functions of constants (which a C++ compiler likes to
// compute by itself), fused operations, reassociated sums, divisions by constants.
constexpr const char* kDelicate = R"(task delicate
sensor a: real
sensor v: vec3
sensor w: vec3
sensor u: real[40]
memory total: real = 0
memory trail: vec3 = 0
metric tanh_of_constants = tanh(0.291) + tanh(0.487) + tanh(0.553) + exp(0.7) + log(1.3)
metric length = norm(v * a + w / 3)
metric mean bell = exp(-dot(v, w) / 7) + tanh(a / 3) + atan2(v.x, w.y) / 1 rad
on end_of_time_step {
  let third = 0.291
  let known = tanh(third) + tanh(third + 0.087) + exp(third) + atan2(third, 0.7) / 1 rad
  trail = trail * 0.9 + cross(v, w) * a
  reward rate shape = known * sum(u) + dot(v, w) - a * a
  reward edge = clamp(a, -1, 1) * norm(u) / 3 + min(u) * max(v)
  total += reward * 0.1 + norm(trail) / 7
  if total > 1e3 { end_episode success "large" }
}
)";

void SenseRandomly(Instance& instance, const taskc_plugin& plugin, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 2);
  for (unsigned i = 0; i < plugin.sensor_count; ++i) {
    const taskc_sensor& sensor = plugin.sensors[i];
    std::vector<double> values(sensor.rows * sensor.columns);
    for (double& value : values) {
      value = normal(random);
      if (sensor.scalar == TASKC_BOOL) value = value > 2;
    }
    instance.Sense(sensor.name, values);
  }
}

// All that a plugin computes, as bits.
std::vector<uint64_t> Results(const CompiledTask& task) {
  const taskc_plugin& plugin = task.plugin();
  Instance instance(task);
  std::vector<uint64_t> bits;
  auto note = [&bits](double value) {
    EXPECT_TRUE(std::isfinite(value));
    bits.push_back(std::bit_cast<uint64_t>(value));
  };
  for (unsigned seed = 0; seed < 500; ++seed) {
    SenseRandomly(instance, plugin, seed);
    for (int event = 0; event < TASKC_EVENT_COUNT; ++event) {
      instance.Fire(event, 0.005);
      note(instance.reward());
      note(instance.end());
      note(instance.violation());
    }
    if (plugin.measure != nullptr) instance.Measure();
    for (unsigned i = 0; i < plugin.metric_count; ++i) {
      note(instance.Metric(plugin.metrics[i].name));
    }
    for (unsigned i = 0; i < plugin.term_count; ++i) note(instance.Term(plugin.terms[i].name));
    for (unsigned i = 0; i < plugin.log_count; ++i) {
      const taskc_log_state& log = instance.Log(plugin.logs[i].name);
      for (double value : {log.last, log.sum, log.minimum, log.maximum}) note(value);
    }
    for (const taskc_memory& memory : std::span(plugin.memory, plugin.memory_count)) {
      for (unsigned i = 0; i < memory.rows * memory.columns; ++i) {
        note(instance.Memory(memory.name, i));
      }
    }
  }
  return bits;
}

TEST(Optimization, DoesNotChangeABit) {
  CompiledTask plain(kDelicate, "-O0");
  std::vector<uint64_t> expected = Results(plain);
  for (const char* level : {"-O1", "-O2", "-O3"}) {
    EXPECT_EQ(Results(CompiledTask(kDelicate, level)), expected) << level;
  }
}

TEST(Optimization, DoesNotChangeABitOfThePapersTasks) {
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tasks", "", ".task")) {
    std::string text = golden::ReadFile(file);
    EXPECT_EQ(Results(CompiledTask(text, "-O0", file)), Results(CompiledTask(text, "-O2", file)))
        << file;
  }
}

// Every construct of the language is in one of them.
TEST(Optimization, DoesNotChangeABitOfAnyConstruct) {
  for (const auto& file : golden::FilesIn(SOURCE_DIR "/tests/compiler/emit/golden", "", ".task")) {
    std::string text = golden::ReadFile(file);
    EXPECT_EQ(Results(CompiledTask(text, "-O0")), Results(CompiledTask(text, "-O2"))) << file;
  }
}

}  // namespace
}  // namespace compiler
