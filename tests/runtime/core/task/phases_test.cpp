// What is noted of each phase of a task.
#include <gmock/gmock.h>

#include "runtime/core/module/module_graph.h"
#include "runtime/core/task/universal_task.h"
#include "tests/runtime/core/task/test_plugins.h"

namespace runtime {
namespace {

using testing::ElementsAre;

class PhasesTest : public testing::Test {
 protected:
  PhasesTest() {
    task_.SetRole(UniversalTask::Role::kActive);
    task_.on_start_of_episode();
  }
  const TaskPhases& phases() const { return task_.instance().phases(); }

  robot::RobotDescription robot_ = Walker();
  ModuleGraph graph_;
  UniversalTask task_{"task", robot_, std::make_unique<TaskInstance>(LoadTask("phased")), 1};
};

TEST_F(PhasesTest, TimeAndRewardBelongToThePhaseInWhichTheStepRan) {
  task_.on_end_of_time_step(0.5);
  EXPECT_EQ(phases().present(), 1u);
  EXPECT_THAT(phases().sums(), ElementsAre(PhaseSums{0.5, 1}, PhaseSums{0, 0}));
  task_.on_end_of_time_step(0.25);
  task_.on_end_of_time_step(0.25);
  EXPECT_THAT(phases().sums(), ElementsAre(PhaseSums{0.5, 1}, PhaseSums{0.5, 2}));
}

TEST_F(PhasesTest, AnEpisodeStartsWithNothingInTheFirst) {
  task_.on_end_of_time_step(0.5);
  task_.on_end_of_episode({});
  task_.on_start_of_episode();
  EXPECT_EQ(phases().present(), 0u);
  EXPECT_THAT(phases().sums(), ElementsAre(PhaseSums{}, PhaseSums{}));
}

TEST_F(PhasesTest, ASwapInAnEpisodeGoesOnInThePhaseOfTheSameName) {
  task_.on_end_of_time_step(0.5);
  task_.Swap(std::make_unique<TaskInstance>(LoadTask("phased_more"), 2), graph_);
  EXPECT_EQ(phases().present(), 1u);
  EXPECT_THAT(phases().sums(), ElementsAre(PhaseSums{}, PhaseSums{0, 0}, PhaseSums{0.5, 1}));
}

TEST_F(PhasesTest, ASwapIsNotMisledByTheNumberOfThePhase) {
  task_.Swap(std::make_unique<TaskInstance>(LoadTask("phased_more"), 2), graph_);
  EXPECT_EQ(phases().present(), 2u);  // `reach`
}

TEST_F(PhasesTest, ASwapBeginsInTheFirstWhereThePhaseIsNoMore) {
  task_.Swap(std::make_unique<TaskInstance>(LoadTask("phased_more"), 2), graph_);
  task_.on_end_of_episode({});
  task_.on_start_of_episode();  // in `lie`
  task_.Swap(std::make_unique<TaskInstance>(LoadTask("phased"), 3), graph_);
  EXPECT_EQ(phases().present(), 0u);
}

TEST_F(PhasesTest, ATaskWithoutPhasesHasNone) {
  const TaskInstance other(LoadTask("told"));
  EXPECT_TRUE(other.phases().phases().empty());
  EXPECT_EQ(other.phases().present(), 0u);
}

TEST_F(PhasesTest, ATableWithPhasesOutsideTheMemoryIsRefused) {
  EXPECT_EQ(MessageOf([&] { LoadTask("phase_outside"); }),
            "phase_outside.so: its table is damaged: the phases lie outside the memory; build it "
            "again with `taskc build`");
}

}  // namespace
}  // namespace runtime
