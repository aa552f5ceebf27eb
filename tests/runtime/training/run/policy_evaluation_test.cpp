#include "runtime/training/run/policy_evaluation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "tests/runtime/training/run/error_of.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;

PolicyEvaluation Sample() {
  PolicyEvaluation evaluation;
  evaluation.profile = "paper-tree";
  evaluation.learned_profile = "fast-tree";
  evaluation.version = "1.2.3";
  evaluation.checkpoint_episode = 1500;
  evaluation.checkpoint = "0123456789abcdef";
  evaluation.returns = {0.1, 2.0 / 3};
  evaluation.mean_return = (0.1 + 2.0 / 3) / 2;
  evaluation.learned_return = 0.5;
  evaluation.ends = {{"success", 1}, {"truncated", 1}};
  evaluation.metrics = {{"rolls", 1.0 / 3}};
  evaluation.learned_metrics = {{"rolls", 2}};
  return evaluation;
}

TEST(PolicyEvaluation, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  WriteEvaluation(folder.path(), Sample());
  const std::filesystem::path file = folder.path() / "evaluation-paper-tree.json";
  EXPECT_EQ(EvaluationFile(folder.path(), "paper-tree"), file);
  const PolicyEvaluation read = ReadEvaluation(file);
  EXPECT_EQ(read.profile, "paper-tree");
  EXPECT_EQ(read.learned_profile, "fast-tree");
  EXPECT_EQ(read.version, "1.2.3");
  EXPECT_EQ(read.checkpoint_episode, 1500);
  EXPECT_EQ(read.checkpoint, "0123456789abcdef");
  EXPECT_EQ(read.returns, Sample().returns);
  EXPECT_EQ(read.mean_return, Sample().mean_return);
  EXPECT_EQ(read.learned_return, 0.5);
  EXPECT_EQ(read.ends, Sample().ends);
  EXPECT_EQ(read.metrics, Sample().metrics);
  EXPECT_EQ(read.learned_metrics, Sample().learned_metrics);
}

TEST(PolicyEvaluation, ItsShareIsOfTheLearnedReturn) {
  PolicyEvaluation evaluation = Sample();
  evaluation.mean_return = 0.4;
  EXPECT_DOUBLE_EQ(evaluation.share(), 0.8);
  evaluation.mean_return = -0.1;
  EXPECT_DOUBLE_EQ(evaluation.share(), -0.2);
  for (const double nothing : {0.0, -3.0, std::numeric_limits<double>::quiet_NaN()}) {
    evaluation.learned_return = nothing;
    EXPECT_TRUE(std::isnan(evaluation.share())) << nothing;
    EXPECT_EQ(nlohmann::json::parse(ToJson(evaluation).dump())["share"], nullptr);
  }
}

TEST(PolicyEvaluation, WhatIsNoNumberStaysNone) {
  const TemporaryFolder folder;
  PolicyEvaluation evaluation = Sample();
  evaluation.returns[1] = evaluation.mean_return = std::numeric_limits<double>::quiet_NaN();
  WriteEvaluation(folder.path(), evaluation);
  const PolicyEvaluation read = ReadEvaluation(EvaluationFile(folder.path(), "paper-tree"));
  EXPECT_EQ(read.returns[0], 0.1);
  EXPECT_TRUE(std::isnan(read.returns[1]));
  EXPECT_TRUE(std::isnan(read.mean_return));
}

TEST(PolicyEvaluation, ADamagedFileIsNamedWithTheRemedy) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "evaluation-fast.json";
  for (const char* text : {"", "{\"profile\": ", "[]", "{\"profile\": 3}"}) {
    std::ofstream(file) << text;
    EXPECT_THAT(ErrorOf([&] { ReadEvaluation(file); }),
                AllOf(HasSubstr(file.string()), HasSubstr("`trainer evaluate`")))
        << text;
  }
  EXPECT_THAT(ErrorOf([&] { ReadEvaluation(folder.path() / "none.json"); }),
              HasSubstr("none.json"));
}

}  // namespace
}  // namespace runtime
