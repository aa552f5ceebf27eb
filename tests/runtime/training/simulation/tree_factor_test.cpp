#include "runtime/training/simulation/tree_factor.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace runtime {
namespace {

class TreeFactorTest : public testing::Test {
 protected:
  double Number() { return std::uniform_real_distribution(-1.0, 1.0)(random_); }
  Vector3 Vector() { return {Number(), Number(), Number()}; }

  TreeJoint Joint(int parent, int child) {
    TreeJoint joint;
    joint.parent = parent;
    joint.child = child;
    joint.parent_arm = Vector();
    joint.child_arm = Vector();
    joint.axis = Vector().normalized();
    joint.hold = 20;
    joint.hold_of_free = child % 2 == 0 ? 0 : 0.3;
    joint.load << Vector(), Vector();
    return joint;
  }

  // Any symmetric positive definite matrix is an inertia.
  Matrix6 Inertia() {
    Matrix6 root;
    for (double& element : root.reshaped()) element = Number();
    return root * root.transpose() + 0.1 * Matrix6::Identity();
  }

  // The joint's matrix on the difference of its ends' velocities.
  static Matrix6 Stiffness(const TreeJoint& joint) {
    Matrix6 stiffness = joint.hold * Matrix6::Identity();
    stiffness.bottomRightCorner<3, 3>() +=
        (joint.hold_of_free - joint.hold) * joint.axis * joint.axis.transpose();
    return stiffness;
  }

  // The velocities at the joint's ends, child's minus parent's, from all bodies' velocities.
  static Eigen::MatrixXd Ends(const TreeJoint& joint) {
    Eigen::MatrixXd ends = Eigen::MatrixXd::Zero(6, 6 * kBodies);
    const auto end = [](const Vector3& arm) {
      Matrix6 matrix = Matrix6::Identity();
      matrix.topRightCorner<3, 3>() = -CrossMatrix(arm);
      return matrix;
    };
    ends.middleCols<6>(6 * joint.child) = end(joint.child_arm);
    ends.middleCols<6>(6 * joint.parent) = -end(joint.parent_arm);
    return ends;
  }

  static constexpr int kBodies = 6;

  std::mt19937 random_{1};
  std::vector<TreeJoint> joints_ = {Joint(0, 2), Joint(0, 1), Joint(2, 4), Joint(2, 3),
                                    Joint(4, 5)};
  TreeFactor tree_{joints_};
  std::vector<Matrix6> inertias_ = [this] {
    std::vector<Matrix6> all(kBodies);
    for (Matrix6& inertia : all) inertia = Inertia();
    return all;
  }();
  // The whole system, densely.
  Eigen::MatrixXd matrix_ = [this] {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6 * kBodies, 6 * kBodies);
    for (int i = 0; i < kBodies; ++i) matrix.block<6, 6>(6 * i, 6 * i) = inertias_[i];
    for (const TreeJoint& joint : joints_) {
      matrix += Ends(joint).transpose() * Stiffness(joint) * Ends(joint);
    }
    return matrix;
  }();
};

TEST_F(TreeFactorTest, SolvesTheSystemThatItStandsFor) {
  Eigen::VectorXd right(6 * kBodies);
  std::vector<Vector6> momenta(kBodies), velocities(kBodies);
  for (int i = 0; i < kBodies; ++i) {
    momenta[i] << Vector(), Vector();
    right.segment<6>(6 * i) = momenta[i];
  }
  for (const TreeJoint& joint : joints_) right += Ends(joint).transpose() * joint.load;
  const Eigen::VectorXd expected = matrix_.ldlt().solve(right);
  tree_.Factorize(inertias_);
  tree_.Solve(momenta, velocities);
  for (int i = 0; i < kBodies; ++i) {
    EXPECT_TRUE(velocities[i].isApprox(expected.segment<6>(6 * i), 1e-11)) << i;
  }
}

TEST_F(TreeFactorTest, PartsMultiplyToTheResponseOfOneImpulseToAnother) {
  Eigen::MatrixXd impulses = Eigen::MatrixXd::Zero(6 * kBodies, 3);
  impulses.col(0).segment<6>(6 * 5) << Vector(), Vector();
  impulses.col(1).segment<6>(6 * 1) << Vector(), Vector();
  impulses.col(2).segment<6>(6 * 3) << Vector(), Vector();
  impulses.col(2).segment<6>(0) << Vector(), Vector();
  const Eigen::MatrixXd expected = impulses.transpose() * matrix_.ldlt().solve(impulses);
  tree_.Factorize(inertias_);
  std::vector<TreeFactor::Part> parts[3];
  for (int a = 0; a < 3; ++a) {
    parts[a].resize(kBodies);
    std::vector<Vector6> impulse(kBodies);
    for (int i = 0; i < kBodies; ++i) impulse[i] = impulses.col(a).segment<6>(6 * i);
    tree_.Decompose(impulse, parts[a]);
    for (int b = 0; b <= a; ++b) {
      double sum = 0;
      for (int i = 0; i < kBodies; ++i) sum += parts[a][i].dot(parts[b][i]);
      EXPECT_NEAR(sum, expected(a, b), 1e-11) << a << b;
    }
  }
}

// A foot of a few grams under a body of kilograms: what turns freely about an axis stays exact.
TEST_F(TreeFactorTest, ASmallInertiaAboutTheAxisIsNotLostInTheHoldOfTheOthers) {
  for (TreeJoint& joint : tree_.joints()) {
    joint.hold_of_free = 0;
    joint.load.setZero();
  }
  const TreeJoint& last = tree_.joints()[4];
  Matrix6& small = inertias_[5];
  small = 1e-6 * Matrix6::Identity();
  const Matrix6 at_joint = InertiaAt(last.child_arm, small);
  tree_.Factorize(inertias_);
  std::vector<Vector6> momenta(kBodies, Vector6::Zero()), velocities(kBodies);
  momenta[5].tail<3>() = 1e-6 * last.axis;
  tree_.Solve(momenta, velocities);
  // About the axis nothing but its own inertia resists, and what its parent turns with it.
  const Vector6 end = VelocityAt(last.child_arm, velocities[5]);
  Vector6 axis = Vector6::Zero();
  axis.tail<3>() = last.axis;
  EXPECT_NEAR(axis.dot(at_joint * end), 1e-6, 1e-18);
}

}  // namespace
}  // namespace runtime
