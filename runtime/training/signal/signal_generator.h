// A module that offers a sensor which no robot has: what somebody tells it, or a course in time.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/module/context.h"
#include "runtime/core/module/module.h"
#include "runtime/core/module/sensor_data.h"

namespace runtime {

// Out port: one sensor, of the name in the parameter `sensor`, with the type that `shape` and
// `unit` say. It is there as soon as it has a name. In port: `time` [s] since the start of the
// episode; a constant does not read it.
//
// What it gives follows from its parameters and the time alone, so there is nothing to save. All
// but the sensor's name and type, and the file, can be set while a run goes on.
class SignalGenerator : public Module {
 public:
  static constexpr const char* kType = "SignalGenerator";  // in agent files

  SignalGenerator(std::string name, const Context& context);

  // Throws as Module::Set(); also for a file that cannot be read, or, once the module is started,
  // for values that do not fit each other. Nothing has changed then.
  void Set(std::string_view parameter, const ParameterValue& value) override;
  void Start() override;

 private:
  static constexpr size_t kMostElements = 4;

  // The file that the samples were read from, and what its headings say.
  struct Source {
    std::string file;
    size_t elements = 0;
    std::string unit;
  };

  std::vector<Parameter> Parameters();
  size_t elements() const;
  void ReadFile();
  void MakePort();
  void CheckSource() const;
  void CheckSignal() const;
  void CheckLength(std::string_view parameter, const std::vector<double>& list) const;
  const SensorData& Read();
  void ReadSamples(double time);

  std::string sensor_;
  std::string shape_ = "real";
  std::string unit_;
  std::string signal_ = "constant";
  std::vector<double> value_;
  std::vector<double> amplitude_;
  double period_ = 1;
  double phase_ = 0;
  std::vector<double> samples_;
  std::string file_;
  std::optional<Source> source_;  // nothing: no file was read
  bool loop_ = false;

  bool is_started_ = false;
  std::array<double, kMostElements> elements_{};
  SensorData data_{elements_.data()};
  SensorIn time_{this, "time", "real [s]", SensorIn::Need::kOptional};
  std::unique_ptr<SensorOut> out_;
};

}  // namespace runtime
