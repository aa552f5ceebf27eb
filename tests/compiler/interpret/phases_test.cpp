// Which phase is the present one, and for how long.
#include <gtest/gtest.h>

#include <stdexcept>

#include "compiler/interpret/evaluator.h"
#include "tests/compiler/check/checked_source.h"

namespace compiler {
namespace {

constexpr double kQuarterSecond = 0.25;  // [s]; exact, so that sums of it are

class PhaseRun {
 public:
  explicit PhaseRun(const std::string& text)
      : task_(CheckTask("task tested\nsensor x: real\n" + text)), evaluator_(task_) {
    Start();
  }

  void Start() { evaluator_.Fire(EventKind::kStartOfEpisode, 0); }
  // A time step at whose end the sensor has this value.
  void Step(double x = 0) {
    evaluator_.frame().sensors.at(0) = Reals{x};
    evaluator_.Fire(EventKind::kEndOfTimeStep, kQuarterSecond);
  }
  std::string Phase() const {
    const Value& present = evaluator_.frame().memory[task_.phase_memory.present];
    return task_.phases[static_cast<size_t>(RealOf(present))].name;
  }
  double Time() const { return RealOf(evaluator_.frame().memory[task_.phase_memory.time]); }
  double Paid(const std::string& term) const {
    for (size_t i = 0; i < task_.terms.size(); ++i) {
      if (task_.terms[i].name == term) return evaluator_.frame().terms[i];
    }
    throw std::runtime_error("no term " + term);
  }

 private:
  CheckedTask task_;
  Evaluator evaluator_;
};

const std::string kReachAndLift =
    "phase reach { reward near = 1 if x > 1 { next lift } }\n"
    "phase lift { reward up = 1 if x < 0 { next reach } }\n";

TEST(Phases, BeginWithTheFirst) {
  PhaseRun run(kReachAndLift);
  EXPECT_EQ(run.Phase(), "reach");
  EXPECT_EQ(run.Time(), 0);
  run.Step(2);
  EXPECT_EQ(run.Phase(), "lift");
  run.Start();
  EXPECT_EQ(run.Phase(), "reach");
  EXPECT_EQ(run.Time(), 0);
}

TEST(Phases, ChangeFromTheNextTimeStepOn) {
  PhaseRun run(kReachAndLift);
  run.Step(2);
  EXPECT_EQ(run.Paid("near"), 1);
  EXPECT_EQ(run.Paid("up"), 0);
  run.Step(2);
  EXPECT_EQ(run.Paid("near"), 1);
  EXPECT_EQ(run.Paid("up"), 1);
}

TEST(Phases, RunAfterTheTasksOwnBlockWhereverThatStands) {
  PhaseRun run(
      "memory n: int = 0\n"
      "phase only { if n == 1 { reward seen = 1 + x } n = 0 }\n"
      "on end_of_time_step { n += 1 }\n");
  run.Step();
  run.Step();
  EXPECT_EQ(run.Paid("seen"), 2);
}

TEST(Phases, TakeTheFirstNextThatIsReached) {
  PhaseRun run(
      "phase a { if x > 0 { next b } next c }\n"
      "phase b { reward in_b = 1 next a }\n"
      "phase c { reward in_c = 1 next a }\n");
  run.Step(1);
  EXPECT_EQ(run.Phase(), "b");
  run.Step();
  EXPECT_EQ(run.Phase(), "a");
  run.Step(0);
  EXPECT_EQ(run.Phase(), "c");
}

TEST(Phases, CountTheirTimeFromTheStepInWhichTheyBegin) {
  PhaseRun run(
      "phase a { reward first = phase_time / 1 s if x > 0 { next b } }\n"
      "phase b { reward second = phase_time / 1 s }\n");
  run.Step();
  run.Step(1);
  EXPECT_EQ(run.Paid("first"), 0.25 + 0.5);
  EXPECT_EQ(run.Time(), 0);
  run.Step();
  EXPECT_EQ(run.Paid("second"), 0.25);
}

TEST(Phases, StartAnewWhereTheyFollowThemselves) {
  PhaseRun run("phase a { if x > 0 { next a } reward r = phase_time / 1 s }\n");
  run.Step();
  run.Step(1);
  EXPECT_EQ(run.Time(), 0);
  EXPECT_EQ(run.Phase(), "a");
}

TEST(Phases, EndAtTheirLimitUnlessANextCameBefore) {
  PhaseRun run(
      "phase a within 0.5 s else late { reward r = x if x > 0 { next early } }\n"
      "phase early { reward r = x if x < 0 { next a } }\n"
      "phase late { reward r = x if x < 0 { next a } }\n");
  run.Step();
  EXPECT_EQ(run.Phase(), "a");
  run.Step();
  EXPECT_EQ(run.Phase(), "late");
  run.Step(-1);
  run.Step();
  run.Step(1);
  EXPECT_EQ(run.Phase(), "early");
}

TEST(Phases, EndAtTheStepThatIsNearestToTheirLimit) {
  for (const char* limit : {"0.4 s", "0.5 s", "0.6 s"}) {
    PhaseRun run("phase a within " + std::string(limit) +
                 " else b { reward r = x }\nphase b { reward r = x next b }\n");
    run.Step();
    EXPECT_EQ(run.Phase(), "a") << limit;
    run.Step();
    EXPECT_EQ(run.Phase(), "b") << limit;
  }
}

TEST(Phases, AreReadByFunctionsOfThePast) {
  PhaseRun run(
      "phase a { if x > 0 { next b } }\n"
      "phase b { if x < 0 { next a } }\n"
      "on end_of_time_step { reward entered = select(rising(phase == b), 1, 0) }\n");
  run.Step(1);
  EXPECT_EQ(run.Paid("entered"), 0);
  run.Step();
  run.Step();
  EXPECT_EQ(run.Paid("entered"), 1);
}

TEST(Phases, DoNothingAfterAnEnd) {
  PhaseRun run(
      "phase a { reward r = 1 if x > 0 { next b } }\n"
      "phase b { reward r = 10 if x > 1 { next a } }\n"
      "on end_of_time_step { if x > 2 { end_episode success \"far\" } }\n");
  run.Step(3);  // the block of the callback that reaches the end still runs
  EXPECT_EQ(run.Paid("r"), 1);
  EXPECT_EQ(run.Phase(), "b");
  run.Step(3);
  EXPECT_EQ(run.Paid("r"), 1);
  EXPECT_EQ(run.Phase(), "b");
  EXPECT_EQ(run.Time(), 0);
}

}  // namespace
}  // namespace compiler
