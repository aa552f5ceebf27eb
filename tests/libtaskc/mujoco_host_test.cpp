// A robot that MuJoCo simulates, seen by a task: in the same states it senses the same and pays the
// same as in the trainer, whose profile `mujoco` is where these states come from.
#include <gmock/gmock.h>
#include <taskc/mujoco.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "runtime/training/simulation/link_motion.h"
#include "runtime/training/simulation/mujoco_model.h"
#include "runtime/training/simulation/robot_sensors.h"
#include "tests/libtaskc/opened_task.h"
#include "tests/runtime/training/simulation/robots.h"

namespace runtime {
namespace {

using testing::HasSubstr;

// What depends on who drives the joints: MuJoCo's actuators, or the trainer's controller.
bool IsOfTheDrive(std::string_view sensor) {
  return sensor == "joint.target" || sensor == "contact_force";
}

// The humanoid in the trainer's simulation, and beside it an mjData in the same states.
class Twins {
 public:
  Twins() {
    const SolverSettings settings{.time_step = world_.physics_time_step(), .contacts = {}};
    model_ = CompiledModel(MjcfOf(Humanoid(), world_.surroundings(), settings, world_.body()));
    data_.reset(mj_makeData(model_.get()));
    CopyState();
    sensors_.Refresh(world_, 0);
  }

  const mjModel* model() const { return model_.get(); }
  mjData* data() const { return data_.get(); }
  std::deque<RobotSensor>& sensors() { return sensors_.sensors(); }
  int steps() const { return world_.physics_steps_per_time_step(); }

  void StartTimeStep(taskc_mujoco& robot) {
    if (time_steps_ % 20 == 0) {
      for (double& target : targets_) target = 0.8 * std::sin(++draws_);
    }
    ++time_steps_;
    world_.StartTimeStep(
        {.base_acceleration = true, .joint_accelerations = true, .site_accelerations = true});
    taskc_mujoco_start_time_step(&robot, data());
  }
  // As MuJoCo does it: the contacts are those of the state before.
  void Step(taskc_mujoco& robot) {
    mj_forward(model(), data());
    world_.Step(targets_);
    CopyState();
    taskc_mujoco_step(&robot, data());
    sensors_.Refresh(world_, ++physics_steps_ * world_.physics_time_step());
  }

 private:
  void CopyState() {
    const dBodyID base = world_.body().body(0);
    std::copy_n(dBodyGetPosition(base), 3, data_->qpos);
    std::copy_n(dBodyGetQuaternion(base), 4, data_->qpos + 3);
    std::copy_n(dBodyGetLinearVel(base), 3, data_->qvel);
    Vector3::Map(data_->qvel + 3) =
        RotationOf(base).transpose() * ToEigen(dBodyGetAngularVel(base));
    for (int j = 0; j < world_.body().joint_count(); ++j) {
      const int id = mj_name2id(model(), mjOBJ_JOINT, Humanoid().joints[j].name.c_str());
      data_->qpos[model()->jnt_qposadr[id]] = world_.body().JointAngle(j);
      data_->qvel[model()->jnt_dofadr[id]] = world_.body().joint(j).Rate();
      // What actuators would have applied, of which this model has none.
      data_->qfrc_actuator[model()->jnt_dofadr[id]] = world_.controller().torques()[j];
    }
  }

  World world_{Humanoid(), FindProfile("mujoco"), Humanoid().poses[1]};
  RobotSensors sensors_{Humanoid(), nullptr};
  std::shared_ptr<const mjModel> model_;
  MujocoData data_;
  std::vector<double> targets_ = Zeros(Humanoid());
  int time_steps_ = 0;
  int draws_ = 0;
  int physics_steps_ = 0;
};

// A second instance of the task reads what the trainer's tasks read.
void BindTrainersSensors(Twins& twins, taskc_instance* instance, const taskc_plugin& table) {
  std::map<std::string_view, const void*> places;
  for (RobotSensor& sensor : twins.sensors()) {
    places[sensor.description().name] = sensor.Read().data;
  }
  for (taskc_uint32 i = 0; i < table.sensor_count; ++i) {
    const taskc_sensor& sensor = table.sensors[i];
    const taskc_view view{.data = places.at(sensor.name),
                          .format = sensor.scalar == TASKC_BOOL ? TASKC_BOOL8 : TASKC_FLOAT64};
    ASSERT_EQ(taskc_bind(instance, sensor.name, sensor.unit, view), TASKC_OK) << taskc_error();
  }
}

class MujocoHostTest : public testing::TestWithParam<const char*> {};

TEST_P(MujocoHostTest, SensesAndPaysWhatTheTrainerDoes) {
  Twins twins;
  const libtaskc::OpenedTask task(GetParam());
  const libtaskc::Instance host(task);
  const libtaskc::Instance trainer(task);
  taskc_mujoco robot;
  ASSERT_EQ(taskc_mujoco_open(&robot, task.get(), host, twins.model()), 0) << robot.error;
  BindTrainersSensors(twins, trainer, task.table());
  taskc_mujoco_start(&robot, twins.data());
  ASSERT_EQ(taskc_start_episode(host, 1, nullptr), TASKC_OK) << taskc_error();
  ASSERT_EQ(taskc_start_episode(trainer, 1, nullptr), TASKC_OK) << taskc_error();

  double paid = 0;
  int touched = 0;
  for (int i = 0; i < 400; ++i) {
    twins.StartTimeStep(robot);
    for (int step = 0; step < twins.steps(); ++step) twins.Step(robot);
    std::vector<double> filled(200);
    for (RobotSensor& sensor : twins.sensors()) {
      const std::string name(sensor.description().name);
      const SensorData& right = sensor.Read();
      if (name.starts_with("site.") && robot.site_count == 0) continue;  // the task reads none
      if (const taskc_mujoco_fill fill = taskc_mujoco_find(name.c_str());
          fill != nullptr && !IsOfTheDrive(name)) {
        fill(&robot, twins.data(), filled.data());
        const int count = robot::ElementCount(sensor.description(), Humanoid());
        for (int k = 0; k < count; ++k) {
          ASSERT_NEAR(filled[k], right.reals()[k], 1e-9 * (1 + std::abs(filled[k]))) << name << i;
        }
      } else if (name == "contact") {
        for (size_t link = 0; link < Humanoid().links.size(); ++link) {
          ASSERT_EQ(robot.contact[link] != 0, static_cast<const bool*>(right.data)[link])
              << Humanoid().links[link].name << i;
          touched += robot.contact[link];
        }
      }
    }
    taskc_result of_host;
    taskc_result of_trainer;
    const double length = twins.steps() * twins.model()->opt.timestep;
    ASSERT_EQ(taskc_event(host, TASKC_END_OF_TIME_STEP, length, &of_host), TASKC_OK);
    ASSERT_EQ(taskc_event(trainer, TASKC_END_OF_TIME_STEP, length, &of_trainer), TASKC_OK);
    ASSERT_NEAR(of_host.reward, of_trainer.reward, 1e-12) << i;
    paid += std::abs(of_host.reward);
  }
  EXPECT_GT(paid, 0.1);
  EXPECT_GT(touched, 500);
  taskc_mujoco_close(&robot);
}

INSTANTIATE_TEST_SUITE_P(, MujocoHostTest, testing::Values("crawling", "tips"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(MujocoHost, AModelWithoutTheSitesIsRefusedByNameWhereTheTaskReadsThem) {
  robot::RobotDescription without = Humanoid();
  without.sites.pop_back();
  const World world(without, FindProfile("fast-tree"), without.poses[0]);
  const auto model = CompiledModel(
      MjcfOf(without, world.surroundings(), {.time_step = 0.002, .contacts = {}}, world.body()));
  taskc_mujoco robot;
  const libtaskc::OpenedTask crawling("crawling");
  const libtaskc::Instance first(crawling);
  EXPECT_EQ(taskc_mujoco_open(&robot, crawling.get(), first, model.get()), 0) << robot.error;
  taskc_mujoco_close(&robot);
  const libtaskc::OpenedTask tips("tips");
  const libtaskc::Instance second(tips);
  EXPECT_NE(taskc_mujoco_open(&robot, tips.get(), second, model.get()), 0);
  EXPECT_STREQ(robot.error, "the model has no site `right_heel`, which is a site of `humanoid`");
}

TEST(MujocoHost, AModelOfAnotherRobotIsRefusedByName) {
  const libtaskc::OpenedTask task("crawling");
  const libtaskc::Instance host(task);
  const World world(Hopper(), FindProfile("fast-tree"), Hopper().poses[0]);
  const auto model = CompiledModel(
      MjcfOf(Hopper(), world.surroundings(), {.time_step = 0.002, .contacts = {}}, world.body()));
  taskc_mujoco robot;
  EXPECT_NE(taskc_mujoco_open(&robot, task.get(), host, model.get()), 0);
  EXPECT_THAT(robot.error, HasSubstr("the model has no body `"));
  EXPECT_THAT(robot.error, HasSubstr("which is a link of `humanoid`"));
}

TEST(MujocoHost, ATaskWithoutARobotIsRefused) {
  const libtaskc::OpenedTask task("each");
  const libtaskc::Instance host(task);
  const World world(Hopper(), FindProfile("fast-tree"), Hopper().poses[0]);
  const auto model = CompiledModel(
      MjcfOf(Hopper(), world.surroundings(), {.time_step = 0.002, .contacts = {}}, world.body()));
  taskc_mujoco robot;
  EXPECT_NE(taskc_mujoco_open(&robot, task.get(), host, model.get()), 0);
  EXPECT_STREQ(robot.error, "the task is for no robot");
}

}  // namespace
}  // namespace runtime
