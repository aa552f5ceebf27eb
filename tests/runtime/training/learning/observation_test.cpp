#include "runtime/training/learning/observation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "runtime/core/module/layout_text.h"
#include "runtime/core/module/sensor_data.h"
#include "tests/runtime/training/learning/fake_state.h"
#include "tests/runtime/training/learning/user_error_of.h"

namespace runtime {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

constexpr int kJoints = 17;
constexpr int kLinks = 18;

// A task that observes what it is told to.
class FakeTask : public Module, public TaskObservations {
 public:
  FakeTask() : Module("task") {}

  ObservationLayout observation_layout() const override { return layout; }
  std::span<const double> Observe() const override { return numbers; }

  ObservationLayout layout;
  std::vector<double> numbers;
  Out<TaskObservations> observations{this, "observations", this};
};

// All sensors of the humanoid.
class AllSensors : public Module {
 public:
  AllSensors() : Module("environment") {
    for (const robot::SensorDescription& description : robot::Sensors()) {
      auto sensor = std::make_unique<Sensor>(this, description);
      sensors_.push_back(std::move(sensor));
    }
    reals(robot::SensorId::kBaseOrientation)[0] = 1;
  }
  void ConnectTo(Module& module) {
    for (Port* port : module.ports()) {
      if (port->type().cpp != std::type_index(typeid(SensorData))) continue;
      Port::Connect(FindPort(port->name()), *port);
    }
  }
  std::vector<double>& reals(robot::SensorId id) {
    return sensors_[static_cast<size_t>(id)]->reals;
  }
  bool* flags(robot::SensorId id) { return sensors_[static_cast<size_t>(id)]->flags; }

 private:
  struct Sensor {
    Sensor(Module* owner, const robot::SensorDescription& description)
        : reals(static_cast<size_t>(robot::ElementCount(description, Humanoid()))),
          data{description.type.starts_with("bool") ? static_cast<const void*>(flags)
                                                    : reals.data()},
          port(owner, std::string(description.name), &data,
               SensorTypeText(description.type, description.unit)) {}
    std::vector<double> reals;
    bool flags[kLinks] = {};
    SensorData data;
    SensorOut port;
  };
  std::vector<std::unique_ptr<Sensor>> sensors_;
};

class ObservationTest : public testing::Test {
 protected:
  ObservationTest() { Port::Connect(task_.observations, observation_.FindPort("task")); }
  std::vector<double> Read() {
    const Eigen::VectorXd& values = observation_.Read();
    return {values.begin(), values.end()};
  }

  FakeTask task_;
  AllSensors sensors_;
  Observation observation_{"observation", HumanoidContext()};
};

TEST_F(ObservationTest, ShowsWhatTheTaskObserves) {
  task_.layout = {{{.name = "a", .type = "real", .unit = "m"},
                   {.name = "b", .type = "vec2", .unit = "", .size = 2}}};
  task_.numbers = {1, 2, 3};
  observation_.Start();  // without a sensor
  EXPECT_THAT(Read(), ElementsAre(1, 2, 3));
  task_.numbers = {4, 5, 6};
  EXPECT_THAT(Read(), ElementsAre(4, 5, 6));
  EXPECT_EQ(ToText(observation_.Layout(), "- "), "- 0       a  real [m]\n- 1 .. 2  b  vec2\n");
}

TEST_F(ObservationTest, ShowsTheRobotWhereTheTaskObservesNothing) {
  sensors_.ConnectTo(observation_);
  observation_.Start();
  EXPECT_EQ(ToText(observation_.Layout(), ""),
            "0         height                     real [m]\n"
            "1 .. 3    up                         vec3\n"
            "4 .. 6    velocity                   vec3 [m/s]\n"
            "7 .. 9    angular_velocity           vec3 [rad/s]\n"
            "10 .. 26  joint.angle - joint.rest   real[joint] [rad]\n"
            "27 .. 43  joint.velocity             real[joint] [rad/s]\n"
            "44 .. 60  joint.target - joint.rest  real[joint] [rad]\n"
            "61 .. 78  contact                    bool[link]\n");
  EXPECT_EQ(Read().size(), 10u + 3 * kJoints + kLinks);
}

// Turned by 90 degrees about x, so that its y axis points up: what moves up in the world moves
// along its y.
TEST_F(ObservationTest, TheRobotsVectorsAreInItsOwnFrame) {
  sensors_.ConnectTo(observation_);
  observation_.Start();
  const double half = std::sqrt(0.5);
  sensors_.reals(robot::SensorId::kBasePosition) = {5, 6, 0.25};
  sensors_.reals(robot::SensorId::kBaseOrientation) = {half, half, 0, 0};
  sensors_.reals(robot::SensorId::kBaseVelocity) = {1, 0, 2};
  sensors_.reals(robot::SensorId::kBaseAngularVelocity) = {0, 3, 0};
  const std::vector<double> values = Read();
  const std::vector<double> of_base(values.begin(), values.begin() + 10);
  EXPECT_THAT(of_base,
              Pointwise(DoubleNear(1e-15), {0.25, 0.0, 1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, -3.0}));
}

TEST_F(ObservationTest, TheRobotsJointsAreSeenFromItsFirstPose) {
  sensors_.ConnectTo(observation_);
  observation_.Start();
  const double rest = Humanoid().poses.front().joint_angles[3];
  sensors_.reals(robot::SensorId::kJointAngle)[3] = 0.5;
  sensors_.reals(robot::SensorId::kJointVelocity)[3] = 7;
  sensors_.reals(robot::SensorId::kJointTarget)[3] = -0.25;
  sensors_.flags(robot::SensorId::kContact)[2] = true;
  const std::vector<double> values = Read();
  EXPECT_EQ(values[10 + 3], 0.5 - rest);
  EXPECT_EQ(values[27 + 3], 7);
  EXPECT_EQ(values[44 + 3], -0.25 - rest);
  EXPECT_EQ(values[61 + 2], 1);
  EXPECT_EQ(values[61 + 3], 0);
}

// What tells where in a motion the robot is.
class Phase : public Module {
 public:
  Phase() : Module("motion") {}

  Eigen::VectorXd values{{0.6, 0.8}};
  Out<Eigen::VectorXd> phase{this, "phase", &values};
};

TEST_F(ObservationTest, ThePhaseOfAMotionIsSeenBesideTheRest) {
  Phase motion;
  Port::Connect(motion.phase, observation_.FindPort("phase"));
  task_.layout = {{{.name = "a", .type = "real", .unit = "m"}}};
  task_.numbers = {3};
  observation_.Start();
  EXPECT_THAT(Read(), ElementsAre(3, 0.6, 0.8));
  EXPECT_EQ(ToText(observation_.Layout(), ""), "0       a      real [m]\n1 .. 2  phase  vec2\n");

  Observation of_robot("of_robot", HumanoidContext());
  FakeTask blind;
  Port::Connect(blind.observations, of_robot.FindPort("task"));
  Port::Connect(motion.phase, of_robot.FindPort("phase"));
  sensors_.ConnectTo(of_robot);
  of_robot.Start();
  sensors_.flags(robot::SensorId::kContact)[kLinks - 1] = true;
  const Eigen::VectorXd& values = of_robot.Read();
  ASSERT_EQ(values.size(), 10 + 3 * kJoints + kLinks + 2);
  EXPECT_EQ(values.tail(3), (Eigen::VectorXd{{1, 0.6, 0.8}}));
}

TEST_F(ObservationTest, TheLayoutIsKnownBeforeTheModuleIsStarted) {
  task_.layout = {{{.name = "a", .type = "real", .unit = ""}}};
  EXPECT_EQ(observation_.Layout().size(), 1u);
}

TEST_F(ObservationTest, WhatIsNotConnectedIsNamed) {
  EXPECT_THAT(UserErrorOf([&] { observation_.Start(); }),
              testing::AllOf(HasSubstr("`observation.base.position` is not connected"),
                             HasSubstr("connect `ENVIRONMENT.*` to `observation.*`")));
  Observation alone("alone", HumanoidContext());
  EXPECT_THAT(UserErrorOf([&] { alone.Start(); }),
              HasSubstr("`alone.task` is not connected: connect it to an out port of the type "
                        "`task observations`"));
}

}  // namespace
}  // namespace runtime
