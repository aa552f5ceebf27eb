// Small modules that the tests of ports and graphs connect.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"
#include "runtime/core/module/values.h"

namespace runtime {

class Source : public Module {
 public:
  explicit Source(std::string name) : Module(std::move(name)) {}

  const double& Refresh() {
    ++refreshes;
    return level_value;
  }

  double level_value = 2.5;
  int refreshes = 0;
  SensorData velocity_data;

  Signal<double> reward{this, "reward"};
  Signal<EpisodeEnd> end{this, "end"};
  Out<double> level{this, "level", Bind<&Source::Refresh>{}};
  Out<double> still{this, "still", &level_value};
  SensorOut velocity{this, "base.velocity", &velocity_data, SensorTypeText("vec3", "m/s")};
};

// Writes down what it is called with, and then does what the test wants.
class Sink : public Module {
 public:
  static constexpr const char* kRole = "sink";

  explicit Sink(std::string name) : Module(std::move(name)) {}

  void OnReward(double value) {
    received.push_back(value);
    if (then) then(value);
  }
  void OnEnd(EpisodeEnd end_of_episode) { reasons.push_back(end_of_episode.reason); }

  std::vector<double> received;
  std::vector<std::string> reasons;
  std::function<void(double)> then;

  Slot<double> reward{this, "reward", Bind<&Sink::OnReward>{}};
  Slot<EpisodeEnd> end{this, "end", Bind<&Sink::OnEnd>{}};
  In<double> level{this, "level"};
  SensorIn velocity{this, "base.velocity", SensorTypeText("vec3", "m/s")};
  SensorIn position{this, "base.position", SensorTypeText("vec3", "m")};
};

}  // namespace runtime
