#include "runtime/training/learning/decision_batch.h"

#include <gtest/gtest.h>

#include <sstream>

namespace runtime {
namespace {

Eigen::VectorXf Vector(float x) { return Eigen::VectorXf{{x}}; }

TEST(DecisionBatch, KeepsEpisodesWithTheirLastObservations) {
  DecisionBatch batch(1, 1);
  batch.Add(Vector(1), Vector(0.1f), 10);
  batch.Add(Vector(2), Vector(0.2f), 20);
  batch.EndEpisode(Vector(3), false);
  batch.Add(Vector(4), Vector(0.4f), 40);
  batch.EndEpisode(Vector(5), true);
  EXPECT_EQ(batch.decisions(), 3);
  EXPECT_EQ(batch.observations(), (Eigen::RowVectorXf{{1, 2, 3, 4, 5}}));
  ASSERT_EQ(batch.episodes().size(), 2u);
  EXPECT_EQ(batch.episodes()[0].first, 0);
  EXPECT_EQ(batch.episodes()[0].decisions, 2);
  EXPECT_FALSE(batch.episodes()[0].is_terminal);
  EXPECT_EQ(batch.episodes()[1].first, 3);
  EXPECT_TRUE(batch.episodes()[1].is_terminal);
  EXPECT_EQ(batch.actions()(0, 3), 0.4f);
  EXPECT_EQ(batch.rewards()[3], 40);
}

TEST(DecisionBatch, WhatHasNotEndedCanBeDropped) {
  DecisionBatch batch(1, 1);
  batch.Add(Vector(1), Vector(1), 1);
  batch.EndEpisode(Vector(2), true);
  batch.Add(Vector(3), Vector(3), 3);
  EXPECT_EQ(batch.decisions(), 1);
  EXPECT_EQ(batch.observations().cols(), 3);
  batch.DropUnfinished();
  EXPECT_EQ(batch.observations().cols(), 2);
  batch.EndEpisode(Vector(4), true);  // of nothing
  EXPECT_EQ(batch.episodes().size(), 1u);
}

TEST(DecisionBatch, EpisodesThatEndedAreAppendedToThoseOfAnother) {
  DecisionBatch batch(1, 1);
  batch.Add(Vector(1), Vector(0.1f), 10);
  batch.EndEpisode(Vector(2), true);
  DecisionBatch other(1, 1);
  for (int i = 0; i < 1500; ++i) other.Add(Vector(3), Vector(0.3f), i);
  other.EndEpisode(Vector(4), false);
  other.Add(Vector(5), Vector(5), 5);
  batch.Append(other);
  EXPECT_EQ(batch.decisions(), 1501);
  ASSERT_EQ(batch.episodes().size(), 2u);
  EXPECT_EQ(batch.episodes()[1].first, 2);
  EXPECT_EQ(batch.episodes()[1].decisions, 1500);
  EXPECT_FALSE(batch.episodes()[1].is_terminal);
  ASSERT_EQ(batch.observations().cols(), 1503);
  EXPECT_EQ(batch.observations()(0, 2), 3);
  EXPECT_EQ(batch.observations()(0, 1502), 4);
  EXPECT_EQ(batch.actions()(0, 1501), 0.3f);
  EXPECT_EQ(batch.rewards()[1501], 1499);
  batch.Append(DecisionBatch(1, 1));
  EXPECT_EQ(batch.decisions(), 1501);
}

TEST(DecisionBatch, IsSavedAsItIs) {
  DecisionBatch batch(2, 1);
  for (int i = 0; i < 1500; ++i) {
    const auto x = static_cast<float>(i);
    batch.Add(Eigen::Vector2f(x, 1 / x), Vector(x), 0.1 * i);
    if (i % 7 == 0) batch.EndEpisode(Eigen::Vector2f(-x, 0), i % 2 == 0);
  }
  std::stringstream stream;
  batch.Save(stream);
  DecisionBatch loaded(2, 1);
  loaded.Load(stream);
  EXPECT_FALSE(stream.fail());
  EXPECT_EQ(loaded.decisions(), batch.decisions());
  EXPECT_EQ(loaded.episodes().size(), batch.episodes().size());
  batch.DropUnfinished();
  EXPECT_EQ(loaded.observations(), batch.observations());
  EXPECT_EQ(loaded.actions(), batch.actions());
  std::stringstream again;
  loaded.Save(again);
  EXPECT_EQ(again.str(), stream.str());

  stream.seekg(0);
  DecisionBatch other(3, 1);
  other.Load(stream);
  EXPECT_TRUE(stream.fail());
}

}  // namespace
}  // namespace runtime
