#include "runtime/training/learning/dof_mapping.h"

#include <gtest/gtest.h>

#include "tests/runtime/training/learning/test_robot.h"
#include "tests/runtime/training/learning/vector_of.h"

namespace runtime {
namespace {

using Eigen::VectorXd;

VectorXd Targets(const std::string& dof, const VectorXd& coordinates) {
  const auto joints = static_cast<int>(Humanoid().joints.size());
  const DofMapping mapping(*Humanoid().FindDof(dof), joints);
  VectorXd targets = VectorXd::Constant(joints, 99);
  mapping.Apply(coordinates, targets);
  return targets;
}

// J1=J4=a0; J3=J6=a1; J8=J13=a2; J9=J14=a3; J10=J15=a4; the others 0.
TEST(DofMapping, FiveCoordinatesMoveBothSidesAlike) {
  EXPECT_EQ(Targets("5", VectorOf({1, 2, 3, 4, 5})),
            VectorOf({0, 1, 0, 2, 1, 0, 2, 0, 3, 4, 5, 0, 0, 3, 4, 5, 0}));
}

// J1=J3=a0; J4=J6=a1; J8=a2, J9=-a2, J10=a2; J13=a3, J14=-a3, J15=a3.
TEST(DofMapping, FourAsymmetricCoordinatesMoveOneLimbEach) {
  EXPECT_EQ(Targets("4asym", VectorOf({1, 2, 3, 4})),
            VectorOf({0, 1, 0, 1, 2, 0, 2, 0, 3, -3, 3, 0, 0, 4, -4, 4, 0}));
}

// J1=J4=a0; J2=a1,J5=-a1; J3=J6=a2; J7=a3,J12=-a3; J8=J13=a4; J9=J14=a5; J10=J15=a6.
TEST(DofMapping, SevenCoordinatesSpreadArmsAndLegs) {
  EXPECT_EQ(Targets("7", VectorOf({1, 2, 3, 4, 5, 6, 7})),
            VectorOf({0, 1, 2, 3, 1, -2, 3, 4, 5, 6, 7, 0, -4, 5, 6, 7, 0}));
}

// As 3 but J10=J15=-0.5 a2.
TEST(DofMapping, CouplingsHaveFactors) {
  EXPECT_EQ(Targets("3d", VectorOf({1, 2, 3})),
            VectorOf({0, 1, 0, 1, 1, 0, 1, 0, 2, 3, -1.5, 0, 0, 2, 3, -1.5, 0}));
}

TEST(DofMapping, CouplingsOfOneJointAddUp) {
  robot::DofConfiguration dof;
  dof.representatives = {0, 1};
  dof.couplings = {{0, 0, 1}, {1, 1, 1}, {2, 0, 0.5}, {2, 1, -2}};
  const DofMapping mapping(dof, 3);
  VectorXd targets(3);
  mapping.Apply(VectorOf({4, 1}), targets);
  EXPECT_EQ(targets, VectorOf({4, 1, 0}));
}

}  // namespace
}  // namespace runtime
