// What surrounds a task module in these tests.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "plugins/robot/sensors.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/values.h"

namespace runtime {

// Offers all sensors of a robot, and counts who is read how often.
class FakeEnvironment : public Module {
 public:
  explicit FakeEnvironment(const robot::RobotDescription& robot) : Module("environment") {
    for (const robot::SensorDescription& description : robot::Sensors()) {
      auto sensor = std::make_unique<Sensor>();
      sensor->values.resize(static_cast<size_t>(robot::ElementCount(description, robot)));
      const bool is_flag = description.type.starts_with("bool");
      sensor->data.data = is_flag ? static_cast<const void*>(sensor->flags) : sensor->values.data();
      ports_of_sensors_.push_back(std::make_unique<SensorOut>(
          this, std::string(description.name), sensor.get(), Bind<&Sensor::Read>{},
          SensorTypeText(description.type, description.unit)));
      sensors_[std::string(description.name)] = std::move(sensor);
    }
  }

  std::vector<double>& values(const std::string& sensor) { return sensors_.at(sensor)->values; }
  bool* flags(const std::string& sensor) { return sensors_.at(sensor)->flags; }

  // How often each sensor was read since the last call; those that were not are not listed.
  std::map<std::string, int> TakeReads() {
    std::map<std::string, int> reads;
    for (auto& [name, sensor] : sensors_) {
      if (sensor->reads > 0) reads[name] = std::exchange(sensor->reads, 0);
    }
    return reads;
  }

 private:
  struct Sensor {
    const SensorData& Read() {
      ++reads;
      return data;
    }
    std::vector<double> values;
    bool flags[8] = {};
    SensorData data;
    int reads = 0;
  };
  std::map<std::string, std::unique_ptr<Sensor>> sensors_;
  std::vector<std::unique_ptr<SensorOut>> ports_of_sensors_;
};

// Writes down what the task emits, in its order.
class FakeLearner : public Module {
 public:
  FakeLearner() : Module("learner") { rewards.reserve(10000); }

  void OnReward(double value) {
    rewards.push_back(value);
    if (on_reward) on_reward();
  }
  void OnEnd(EpisodeEnd episode_end) {
    ends.emplace_back(episode_end.kind, episode_end.reason);
    rewards_before_end = rewards.size();
    if (on_end) on_end();
  }

  std::vector<double> rewards;
  std::vector<std::pair<EndKind, std::string>> ends;
  size_t rewards_before_end = 0;
  std::function<void()> on_reward, on_end;

  Slot<double> reward{this, "reward", Bind<&FakeLearner::OnReward>{}};
  Slot<EpisodeEnd> end{this, "end", Bind<&FakeLearner::OnEnd>{}};
};

}  // namespace runtime
