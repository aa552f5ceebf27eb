#include "runtime/training/signal/signal_generator.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "runtime/core/module/connections.h"
#include "runtime/core/module/module_graph.h"
#include "tests/runtime/training/run/temporary_folder.h"

namespace runtime {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Offers a time, and reads a sensor.
class Clock : public Module {
 public:
  Clock() : Module("environment") {}
  double now = 0;

 private:
  SensorData data_{&now};
  SensorOut time_{this, "time", &data_, "real [s]"};
};

class Reader : public Module {
 public:
  Reader(const std::string& sensor, const std::string& type)
      : Module("task"), sensor_(this, sensor, type) {}
  bool connected() const { return sensor_.connected(); }
  std::vector<double> Read(size_t count) const {
    const double* reals = sensor_().reals();
    return {reals, reals + count};
  }

 private:
  SensorIn sensor_;
};

class SignalGeneratorTest : public testing::Test {
 protected:
  SignalGeneratorTest() {
    clock_ = static_cast<Clock*>(&graph_.Add(std::make_unique<Clock>()));
    signal_ = &graph_.Add(std::make_unique<SignalGenerator>("wish", Context{}));
  }

  void Start(const std::string& sensor, const std::string& type) {
    reader_ = static_cast<Reader*>(&graph_.Add(std::make_unique<Reader>(sensor, type)));
    graph_.Start();
  }
  double At(double time) {
    clock_->now = time;
    return reader_->Read(1)[0];
  }
  template <class Action>
  static std::string Refusal(Action action) {
    try {
      action();
    } catch (const UserError& error) {
      return error.what();
    }
    return "none";
  }

  ModuleGraph graph_;
  Clock* clock_;
  Module* signal_;
  Reader* reader_ = nullptr;
};

TEST_F(SignalGeneratorTest, OffersASensorThatIsFoundByNameTypeAndUnit) {
  signal_->Set("sensor", std::string("ball.position"));
  signal_->Set("unit", std::string("m"));
  signal_->Set("shape", std::string("vec3"));
  signal_->Set("value", std::vector<double>{1, 2, 3});
  Start("ball.position", "vec3 [m]");
  ASSERT_TRUE(reader_->connected());
  EXPECT_THAT(reader_->Read(3), ElementsAre(1, 2, 3));
  EXPECT_EQ(signal_->FindParameter("value").unit, "m");
}

TEST_F(SignalGeneratorTest, IsNotTakenForAnotherType) {
  signal_->Set("sensor", std::string("wish"));
  signal_->Set("unit", std::string("m"));
  Start("wish", "real [m/s]");
  EXPECT_FALSE(reader_->connected());
}

TEST_F(SignalGeneratorTest, IsToldItsValueWhileItRuns) {
  signal_->Set("sensor", std::string("wish"));
  Start("wish", "real");
  EXPECT_EQ(At(0), 0);
  signal_->Set("value", 0.25);  // a list of one
  EXPECT_EQ(At(1), 0.25);
  EXPECT_EQ(Refusal([&] {
              signal_->Set("value", std::vector<double>{1, 2});
            }),
            "`wish.value` has 2 elements, and a `real` has 1");
  EXPECT_EQ(At(2), 0.25);
}

TEST_F(SignalGeneratorTest, SwingsWithTheTimeOfTheEpisode) {
  signal_->Set("sensor", std::string("wish"));
  signal_->Set("signal", std::string("sine"));
  signal_->Set("value", 1.0);
  signal_->Set("amplitude", 0.5);
  signal_->Set("period", 4.0);
  signal_->Set("phase", std::numbers::pi / 2);
  Start("wish", "real");
  EXPECT_DOUBLE_EQ(At(0), 1.5);
  EXPECT_NEAR(At(1), 1, 1e-15);
  EXPECT_DOUBLE_EQ(At(2), 0.5);
  EXPECT_DOUBLE_EQ(At(0.5), 1 + 0.5 * std::cos(std::numbers::pi / 4));
}

TEST_F(SignalGeneratorTest, FollowsSamples) {
  signal_->Set("sensor", std::string("wish"));
  signal_->Set("signal", std::string("samples"));
  signal_->Set("samples", std::vector<double>{1, 10, 2, 20, 4, 0});
  Start("wish", "real");
  EXPECT_EQ(At(0), 10);
  EXPECT_EQ(At(1), 10);
  EXPECT_EQ(At(1.25), 12.5);
  EXPECT_EQ(At(2), 20);
  EXPECT_EQ(At(3), 10);
  EXPECT_EQ(At(4), 0);
  EXPECT_EQ(At(100), 0);
  signal_->Set("loop", true);
  EXPECT_EQ(At(0.5), 10);
  EXPECT_EQ(At(4.25), 12.5);
  EXPECT_EQ(At(1 + 3 * 7 + 2), 10);
}

TEST_F(SignalGeneratorTest, HoldsASingleSample) {
  signal_->Set("sensor", std::string("wish"));
  signal_->Set("signal", std::string("samples"));
  signal_->Set("samples", std::vector<double>{3, 7});
  signal_->Set("loop", true);
  Start("wish", "real");
  EXPECT_EQ(At(0), 7);
  EXPECT_EQ(At(9), 7);
}

TEST_F(SignalGeneratorTest, ReadsAFileOnce) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "signal.csv";
  std::ofstream(file) << "time [s], wish [m/s]\n0, 0\n2, 1\n";
  signal_->Set("file", file);
  signal_->Set("sensor", std::string("wish"));
  signal_->Set("unit", std::string("m/s"));
  signal_->Set("signal", std::string("samples"));
  Start("wish", "real [m/s]");
  EXPECT_EQ(At(1), 0.5);
  EXPECT_EQ(signal_->Get("file"), ParameterValue(std::string()));
  EXPECT_EQ(signal_->Get("samples"), ParameterValue(std::vector<double>{0, 0, 2, 1}));
}

TEST_F(SignalGeneratorTest, RefusesAFileOfAnotherForm) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "signal.csv";
  std::ofstream(file) << "time [s], wish [m]\n0, 0\n2, 1\n";
  signal_->Set("file", file);
  signal_->Set("sensor", std::string("wish"));
  signal_->Set("unit", std::string("m/s"));
  EXPECT_EQ(Refusal([&] { signal_->Start(); }),
            "`" + file + "` is in `m`, and `wish.unit` is `m/s`: they must be the same");
  signal_->Set("unit", std::string("m"));
  signal_->Set("shape", std::string("vec2"));
  EXPECT_EQ(Refusal([&] { signal_->Start(); }),
            "`" + file + "` has 1 column beside the time, and a `vec2` has 2 elements");
  EXPECT_THAT(Refusal([&] { signal_->Set("file", std::string("/nowhere.csv")); }),
              HasSubstr("`/nowhere.csv` cannot be read"));
}

TEST_F(SignalGeneratorTest, RefusesToStartWithoutWhatItNeeds) {
  EXPECT_EQ(Refusal([&] { signal_->Start(); }),
            "`wish.sensor` is empty: name the sensor that it offers, as the task declares it");
  EXPECT_EQ(Refusal([&] { signal_->Set("sensor", std::string("time")); }),
            "`wish.sensor` cannot be `time`: that is the robot's");
  signal_->Set("sensor", std::string("wish"));
  signal_->Set("signal", std::string("sine"));
  EXPECT_EQ(Refusal([&] { signal_->Start(); }),
            "`wish.time` is not connected: connect it to `environment.time`, or take a constant "
            "signal");
  ConnectSensors(*signal_, graph_);
  signal_->Set("signal", std::string("samples"));
  EXPECT_EQ(Refusal([&] { signal_->Start(); }),
            "`wish.samples` holds 0 numbers, and not 2 for each row: the time, and 1 element");
  signal_->Set("samples", std::vector<double>{1, 0, 1, 0});
  EXPECT_EQ(Refusal([&] { signal_->Start(); }),
            "the times in `wish.samples` must ascend, and 1 s is no later than 1 s");
  signal_->Set("samples", std::vector<double>{1, 0, 2, 0});
  signal_->Start();
  EXPECT_THAT(Refusal([&] { signal_->Set("samples", std::vector<double>{1}); }),
              HasSubstr("holds 1 numbers"));
  EXPECT_EQ(signal_->Get("samples"), ParameterValue(std::vector<double>{1, 0, 2, 0}));
}

}  // namespace
}  // namespace runtime
