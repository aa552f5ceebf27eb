#include "runtime/training/learning/ng_net.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/training/learning/bubble_net.h"
#include "runtime/training/learning/grid_net.h"
#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// Reads what a net module offers.
class Reader : public Module {
 public:
  Reader() : Module("reader") {}
  In<Eigen::VectorXd> features{this, "features"};
  In<GaussianNet> net{this, "net"};
};

class NgNetTest : public testing::Test {
 protected:
  void Use(const std::string& dof, const std::string& net) {
    state_ = std::make_unique<FakeState>(dof);
    Connect(*state_, "state", module_, "state");
    module_.Set("net", net);
    Connect(module_, "features", reader_, "features");
    Connect(module_, "net", reader_, "net");
  }
  std::string Complaint() {
    return UserErrorOf([this] { module_.Start(); });
  }

  std::unique_ptr<FakeState> state_;
  NgNet module_{"features", HumanoidContext()};
  Reader reader_;
};

TEST_F(NgNetTest, FeaturesAreThoseOfTheAngles) {
  Use("4asym", "4asym_g4");
  module_.Start();
  state_->values.setConstant(1e3);  // base and velocities must not matter
  state_->angles() << 0.1, -0.2, 0.3, 1.4;
  const GaussianNet net = GridNet(HumanoidNet("4asym_g4"), Norm::kEuclidean);
  Eigen::VectorXd expected(net.units());
  net.Evaluate(state_->angles(), expected);
  EXPECT_EQ(reader_.features(), expected);

  state_->angles() << 0.1, -0.2, 0.3, -1.4;
  EXPECT_NE(reader_.features(), expected);
}

TEST_F(NgNetTest, NetIsThereBeforeTheStart) {
  Use("4asym", "4asym_g5");
  EXPECT_EQ(reader_.net().units(), 625);
}

TEST_F(NgNetTest, BubbleNetsDependOnTheirOwnSeedOnly) {
  Use("3", "bq3dof60");
  module_.Set("net_seed", int64_t{5});
  EXPECT_EQ(reader_.net().centers(),
            BubbleNet(PackSpheres(HumanoidNet("bq3dof60"), 5), Norm::kEuclidean).centers());
}

TEST_F(NgNetTest, MaxNormMeasuresTheNeighbors) {
  Use("3", "bq3dof60");
  module_.Set("max_norm", true);
  EXPECT_EQ(reader_.net().neighbor_distances(),
            BubbleNet(PackSpheres(HumanoidNet("bq3dof60"), 1), Norm::kMax).neighbor_distances());
}

TEST_F(NgNetTest, NetsOfAnotherConfigurationWithTheSameCoordinatesFit) {
  Use("3d", "3_g5");
  EXPECT_EQ(Complaint(), "");
}

TEST_F(NgNetTest, UnknownNetNamesTheNearest) {
  Use("5", "bq10");
  EXPECT_THAT(Complaint(), AllOf(HasSubstr("features.net"), HasSubstr("`bq01`")));
}

TEST_F(NgNetTest, NetOfOtherCoordinatesNamesThoseThatFit) {
  Use("5", "4asym_g4");
  EXPECT_THAT(Complaint(), AllOf(HasSubstr("`4asym`"), HasSubstr("`5`"), HasSubstr("`bq01` `q3`"),
                                 Not(HasSubstr("3_g5"))));
}

TEST_F(NgNetTest, NeedsAState) {
  EXPECT_THAT(Complaint(), AllOf(HasSubstr("features.state"), HasSubstr("robot state")));
}

}  // namespace
}  // namespace runtime
