#include "runtime/training/learning/saved_matrix.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace runtime {
namespace {

TEST(SavedMatrix, IsTheSameToTheBit) {
  const Eigen::MatrixXd large = Eigen::MatrixXd::Random(300, 301);  // more than one piece
  const Eigen::VectorXf small = Eigen::VectorXf{{0.1f, -0.0f, 1e-40f}};
  std::stringstream stream;
  SaveMatrix(stream, large);
  SaveMatrix(stream, Eigen::MatrixXd(0, 4));
  SaveVector(stream, small);
  EXPECT_EQ(LoadMatrix(stream), large);
  EXPECT_EQ(LoadMatrix(stream).cols(), 4);
  Eigen::VectorXf loaded(3);
  LoadVector(stream, loaded);
  EXPECT_EQ(loaded, small);
  EXPECT_TRUE(std::signbit(loaded[1]));
  EXPECT_FALSE(stream.fail());
}

TEST(SavedMatrix, WhatIsNoMatrixIsRefused) {
  std::stringstream saved;
  SaveMatrix(saved, Eigen::Vector2d(1, 2));
  const std::string text = saved.str();
  for (const std::string& damaged :
       {std::string(), text.substr(0, text.size() - 1), "x" + text, "-1 2\n" + text,
        std::string("100000 100000\n") + text, std::string("10000 10000\n") + text}) {
    std::istringstream stream(damaged);
    EXPECT_EQ(LoadMatrix(stream).size(), 0) << damaged;
    EXPECT_TRUE(stream.fail()) << damaged;
  }
}

TEST(SavedMatrix, AVectorOfAnotherSizeIsRefusedAndChangesNothing) {
  std::stringstream stream;
  SaveMatrix(stream, Eigen::Vector2d(1, 2));
  Eigen::VectorXd vector = Eigen::VectorXd::Constant(3, 7);
  LoadVector(stream, vector);
  EXPECT_TRUE(stream.fail());
  EXPECT_EQ(vector, Eigen::VectorXd::Constant(3, 7));
}

}  // namespace
}  // namespace runtime
