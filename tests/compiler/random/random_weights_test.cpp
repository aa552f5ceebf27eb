// Random tasks: with another weight, whatever the sensors say, a term that the compiler says it
// scales pays in proportion to it, and every other term pays the same.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "compiler/interpret/evaluator.h"
#include "compiler/weights/weights.h"
#include "tests/compiler/check/checked_source.h"
#include "tests/compiler/random/random_numbers.h"
#include "tests/compiler/random/random_task.h"

namespace compiler {
namespace {

// What is paid instead of {1}, with a weight {0}. In the last three the weight is no weight.
const std::vector<std::string> kWeighed = {
    "{0} * ({1})",
    "-({1}) / 3 * {0}",
    "{0} * ({1}) - 2 * {0} * ({1})",
    "abs({0} * ({1}))",
    "max({0} * ({1}), 0, -{0} * ({1}) / 2)",
    "clamp(({1}) * {0}, 0, {0} * abs({1}))",
    "select(({1}) > 0, {0} * ({1}), 0)",
    "sum({0} * vec2({1}, ({1}) / 2))",
    "norm({0} * vec2({1}, -({1})))",
    "dot(vec2(1, 2), vec2({1}, {1}) * {0})",
    "weigh({0}, 2) * ({1})",
    "({1}) / {0}",
    "{0} * {0} * ({1})",
    "tanh({0}) * ({1})",
};

// The task with a weight in everything that its named terms pay.
std::string WithWeights(const std::string& text, RandomNumbers& random) {
  static const std::regex kReward("( *reward (?:rate |potential )?t([0-5]) = )(.*)");
  std::istringstream lines(text);
  std::string weighed;
  std::getline(lines, weighed);
  for (int i = 0; i < 6; ++i)
    weighed += fmt::format("\nparam weight{}: real = 0.75{}", i, i < 2 ? "" : " in 0 .. 10");
  weighed +=
      "\nfn weigh(weight: real, value: real) -> real { let cost = -weight return cost * value }\n";
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (std::regex_match(line, match, kReward)) {
      line = match[1].str() + fmt::format(fmt::runtime(random.OneOf(kWeighed)),
                                          "weight" + match[2].str(), match[3].str());
    }
    weighed += line + "\n";
  }
  return weighed;
}

// Small enough that next to nothing overflows.
Value SmallValue(const Type& type, RandomNumbers& random) {
  Value value = Filled(type.scalar, type.size(), 0);
  for (uint32_t i = 0; i < type.size(); ++i) {
    if (auto* reals = std::get_if<Reals>(&value)) {
      (*reals)[i] = (random.Below(200) - 100.0) / 16;
    } else {
      std::get<Integers>(value)[i] =
          type.scalar == Scalar::kBool ? random.Below(2) : random.Below(5);
    }
  }
  return value;
}

struct Counts {
  int weights = 0;   // of terms
  int payments = 0;  // that such terms have made
};

// Runs the task for a while with one value of the weight and with another. A power of 2 is
// multiplied by without rounding, so that the payments are in proportion to the last bit.
void ExpectProportion(const CheckedTask& task, uint32_t param, const ParamUse& use, uint32_t seed,
                      Counts& counts) {
  RandomNumbers random(seed);
  const double factor = task.params[param].minimum < 0 ? -2 : 2;
  Evaluator one(task);
  Evaluator other(task);
  other.frame().params[param] *= factor;
  other.Initialize();
  for (int call = 0; call < 40; ++call) {
    for (size_t i = 0; i < task.sensors.size(); ++i)
      one.frame().sensors[i] = other.frame().sensors[i] = SmallValue(task.sensors[i].type, random);
    const auto event = static_cast<EventKind>(random.Below(8));
    const std::vector<double> before = one.frame().terms;
    one.Fire(event, 0.125);
    other.Fire(event, 0.125);
    // What is not finite is not paid; the largest numbers are so only with one of the two.
    if (one.frame().fault != other.frame().fault) return;
    const bool ends_alike =
        one.frame().end == other.frame().end && one.frame().violation == other.frame().violation;
    EXPECT_TRUE(ends_alike || use.changes_course);
    for (uint32_t i = 0; i < task.terms.size(); ++i) {
      const bool is_scaled = std::ranges::binary_search(use.scales, i);
      const double total = one.frame().terms[i];
      EXPECT_EQ(other.frame().terms[i], is_scaled ? factor * total : total) << task.terms[i].name;
      if (is_scaled && total != before[i]) ++counts.payments;
    }
    if (!ends_alike) return;  // from here on, the two may run differently
  }
}

TEST(RandomTasks, PayInProportionToTheirWeights) {
  Counts counts;
  for (uint32_t seed = 1; seed <= 250; ++seed) {
    RandomNumbers random(seed);
    const std::string text = WithWeights(RandomTask(seed), random);
    const CheckedSource source(text);
    ASSERT_TRUE(source.task) << source.Messages() << text;
    const Weights weights = FindWeights(*source.task);
    for (uint32_t i = 0; i < weights.params.size(); ++i) {
      if (weights.params[i].scales.empty()) continue;
      counts.weights += static_cast<int>(weights.params[i].scales.size());
      ExpectProportion(*source.task, i, weights.params[i], seed, counts);
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", " << source.task->params[i].name << "\n"
                                 << text;
    }
  }
  // Else nothing was tried.
  EXPECT_GT(counts.weights, 100);
  EXPECT_GT(counts.payments, 500);
}

}  // namespace
}  // namespace compiler
