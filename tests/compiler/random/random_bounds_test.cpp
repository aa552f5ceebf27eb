// Random tasks: whatever the sensors say within their ranges, nothing leaves the bounds that the
// compiler finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/bounds/bounds.h"
#include "compiler/interpret/evaluator.h"
#include "tests/compiler/check/checked_source.h"
#include "tests/compiler/random/random_numbers.h"
#include "tests/compiler/random/random_task.h"

namespace compiler {
namespace {

double RandomWithin(double low, double high, RandomNumbers& random) {
  constexpr double kLargest = 1e6;  // where there is no bound
  low = std::max(low, -kLargest);
  high = std::min(high, kLargest);
  if (random.OneIn(5)) return low;
  if (random.OneIn(5)) return high;
  if (low <= 0 && high >= 0 && random.OneIn(5)) return random.OneOf({0.0, -0.0});
  return std::clamp(low + (high - low) * random.Below(1000) / 999, low, high);
}

Value RandomWithin(const CheckedSensor& sensor, RandomNumbers& random) {
  Value value = Filled(sensor.type.scalar, sensor.type.size(), 0);
  for (uint32_t i = 0; i < sensor.type.size(); ++i) {
    const double element = RandomWithin(sensor.minimum[i], sensor.maximum[i], random);
    if (auto* reals = std::get_if<Reals>(&value)) {
      (*reals)[i] = element;
    } else {
      std::get<Integers>(value)[i] = static_cast<int64_t>(element);
    }
  }
  return value;
}

void GiveRanges(CheckedSensor& sensor, RandomNumbers& random) {
  sensor.minimum.assign(sensor.type.size(), 0);
  sensor.maximum.assign(sensor.type.size(), 1);
  if (sensor.type.scalar == Scalar::kBool) return;
  for (uint32_t i = 0; i < sensor.type.size(); ++i) {
    sensor.minimum[i] = int(random.Below(20)) - 10;
    sensor.maximum[i] = sensor.minimum[i] + random.Below(5);
    if (random.OneIn(8)) sensor.minimum[i] = -kInfinity;
    if (random.OneIn(8)) sensor.maximum[i] = kInfinity;
  }
}

void ExpectInside(const Interval& bounds, double value, const std::string& what) {
  if (std::isnan(value)) {
    EXPECT_TRUE(bounds.may_be_nan) << what << " is no number";
  } else {
    EXPECT_TRUE(Contains(bounds, value))
        << what << " is " << value << ", not in " << bounds.low << " .. " << bounds.high;
    EXPECT_TRUE(std::isfinite(value) || bounds.may_be_infinite) << what << " is infinite";
  }
}

// What has no bound is assumed to be far from the largest double. A memory that is multiplied again
// and again gets there.
bool IsHuge(const Value& value) {
  return std::ranges::any_of(ToReals(value), [](double x) { return std::abs(x) > 1e100; });
}

// A robot's are all alike, and its tasks' bounds count on that.
double RandomTimeStep(const CheckedTask& task, RandomNumbers& random) {
  const double any = random.OneOf({0.0, 0.005, 1.0});
  return std::isfinite(task.longest_time_step) ? task.longest_time_step : any;
}

// Runs the task for a while.
void ExpectBounds(const CheckedTask& task, RandomNumbers& random) {
  const TaskBounds bounds = ComputeBounds(task);
  Evaluator evaluator(task);
  Frame& frame = evaluator.frame();
  for (int call = 0; call < 60 && !testing::Test::HasFailure(); ++call) {
    for (size_t i = 0; i < task.sensors.size(); ++i)
      if (call == 0 || random.OneIn(2)) frame.sensors[i] = RandomWithin(task.sensors[i], random);
    // It all begins with an episode.
    const auto event = static_cast<EventKind>(call == 0 ? 0 : random.Below(8));
    frame.discount = random.OneOf({0.0, 0.9, 1.0});
    frame.outcome = static_cast<EndKind>(random.Below(3));
    const std::vector<double> before = frame.terms;
    evaluator.Fire(event, RandomTimeStep(task, random));
    for (const CheckedPotential& potential : task.potentials) {
      const double paid = frame.terms[potential.term] - before[potential.term];
      const auto& value = bounds.terms[potential.term].potential;
      if (!value || !IsBounded(*value) || Magnitude(*value) > 1e6) continue;
      if (value->low > value->high) {  // never a number, so never paid
        EXPECT_EQ(paid, 0) << task.terms[potential.term].name;
        continue;
      }
      const Interval payment = PaymentOfPotential(*value);
      EXPECT_LE(payment.low, paid + 1e-6 * Magnitude(*value)) << task.terms[potential.term].name;
      EXPECT_GE(payment.high, paid - 1e-6 * Magnitude(*value)) << task.terms[potential.term].name;
    }
    // A loop may get there within one event.
    const bool is_far = std::ranges::any_of(frame.memory, IsHuge);
    for (size_t i = 0; i < task.memory.size(); ++i) {
      const Reals elements = ToReals(frame.memory[i]);
      for (size_t j = 0; j < elements.size(); ++j)
        if (!is_far || IsBounded(bounds.memory[i][j]))
          ExpectInside(bounds.memory[i][j], elements[j], task.memory[i].name);
    }
    if (is_far) return;
    if (frame.end >= 0) {
      EXPECT_TRUE(bounds.ends_reached[static_cast<size_t>(frame.end)]);
    }
    frame.time_step = 0.005;
    evaluator.Measure();
    for (size_t i = 0; i < task.metrics.size(); ++i)
      ExpectInside(bounds.metrics[i].value, frame.metrics[i], task.metrics[i].name);
    evaluator.Observe();
    for (size_t i = 0; i < task.observations.size(); ++i) {
      const CheckedObservation& observed = task.observations[i];
      for (uint32_t j = 0; j < observed.value.type.size(); ++j)
        ExpectInside(bounds.observations[i].value, frame.observations[observed.offset + j],
                     observed.name);
    }
  }
  for (size_t i = 0; i < task.terms.size(); ++i) {
    const TermBounds& term = bounds.terms[i];
    const bool may_be_paid = term.rate || term.payment || term.potential;
    EXPECT_TRUE(may_be_paid || frame.terms[i] == 0) << task.terms[i].name;
  }
}

TEST(RandomTasks, StayWithinTheirBounds) {
  for (uint32_t seed = 1; seed <= 300; ++seed) {
    CheckedSource source(RandomTask(seed));
    ASSERT_TRUE(source.task) << source.Messages();
    CheckedTask& task = *source.task;
    RandomNumbers random(seed);
    for (CheckedSensor& sensor : task.sensors) GiveRanges(sensor, random);
    ExpectBounds(task, random);
    ASSERT_FALSE(HasFailure()) << "seed " << seed << "\n" << RandomTask(seed);
  }
}

}  // namespace
}  // namespace compiler
