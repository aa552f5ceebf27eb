#include "runtime/training/simulation/profile.h"

#include <gtest/gtest.h>

#include <limits>

namespace runtime {
namespace {

TEST(Profile, PaperTakesTwentyFiveStepsInFiveMilliseconds) {
  const int steps = FindProfile("paper").PhysicsStepsPerTimeStep(0.005);
  EXPECT_EQ(steps, 25);
  EXPECT_DOUBLE_EQ(0.005 / steps, 0.0002);
}

TEST(Profile, TheStepDividesEveryTimeStepAndIsNeverLonger) {
  for (const Profile& profile : kProfiles) {
    for (const double control : {0.0001, 0.001, 0.002, 0.0033, 0.005, 0.01, 0.02, 0.1}) {
      const int steps = profile.PhysicsStepsPerTimeStep(control);
      EXPECT_LE(control / steps, profile.longest_time_step * (1 + 1e-8)) << control;
      if (steps == 1) continue;
      EXPECT_GT(control / (steps - 1), profile.longest_time_step) << control;
    }
  }
}

TEST(Profile, ContactsOfThePaperAreThoseOfItsTable) {
  const Softness softness = FindProfile("paper").ContactSoftness(0.0002);
  EXPECT_DOUBLE_EQ(softness.erp, 0.2);
  EXPECT_DOUBLE_EQ(softness.cfm, 0.001);
}

// ERP = h k / (h k + d) and CFM = 1 / (h k + d) describe a spring k and a damper d.
TEST(Profile, ContactsAreTheSameSpringAndDamperAtEveryStep) {
  for (const Profile& profile : kProfiles) {
    for (const double h : {0.0002, 0.001, 0.005}) {
      const Softness softness = profile.ContactSoftness(h);
      const double stiffness = softness.erp / (h * softness.cfm);
      EXPECT_NEAR(stiffness, 1e6, 1e-3);
      EXPECT_NEAR(1 / softness.cfm - h * stiffness, profile.contact_damping, 1e-6);
    }
  }
}

}  // namespace
}  // namespace runtime
