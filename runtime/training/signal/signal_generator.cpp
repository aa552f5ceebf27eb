#include "runtime/training/signal/signal_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/training/signal/signal_file.h"

namespace runtime {
namespace {

constexpr const char* kConstant = "constant";
constexpr const char* kSine = "sine";
constexpr const char* kSamples = "samples";
constexpr double kShortestPeriod = 1e-3;  // [s]

double ElementOf(const std::vector<double>& list, size_t i) { return list.empty() ? 0 : list[i]; }

}  // namespace

SignalGenerator::SignalGenerator(std::string name, const Context&) : Module(std::move(name)) {
  ReplaceParameters(Parameters());
}

std::vector<Parameter> SignalGenerator::Parameters() {
  return {
      {.name = "sensor",
       .doc = "name of the sensor that it offers, as tasks declare it",
       .target = &sensor_,
       .is_live = false},
      {.name = "shape",
       .doc = "of the sensor",
       .target = &shape_,
       .choices = {"real", "vec2", "vec3", "vec4"},
       .is_live = false},
      {.name = "unit",
       .doc = "of the sensor, as `taskc` writes it: \"m/s\"; \"\" for plain numbers",
       .target = &unit_,
       .is_live = false},
      {.name = "signal",
       .doc = "what it gives: always `value`; `value` and a sine on top; what the samples say",
       .target = &signal_,
       .choices = {kConstant, kSine, kSamples}},
      {.name = "value",
       .doc = "a number for each element; none: all are 0",
       .target = &value_,
       .unit = unit_},
      {.name = "amplitude",
       .doc = "of the sine, a number for each element; none: all are 0",
       .target = &amplitude_,
       .unit = unit_},
      {.name = "period",
       .doc = "of the sine",
       .target = &period_,
       .minimum = kShortestPeriod,
       .unit = "s"},
      {.name = "phase",
       .doc = "of the sine at the start of an episode",
       .target = &phase_,
       .unit = "rad"},
      // Before the file, which is not read where there are samples: the record of a run, with
      // the parameters in this order, says what the file held.
      {.name = "samples",
       .doc = "rows of a time [s] and the elements then, one after the other; between them the "
              "signal is a straight line",
       .target = &samples_},
      {.name = "file",
       .doc = "CSV file that the samples are read from, beside the agent file; \"\" from then on",
       .target = &file_,
       .is_live = false},
      {.name = "loop",
       .doc = "whether the samples begin again after the last one, or hold it",
       .target = &loop_}};
}

size_t SignalGenerator::elements() const {
  return shape_ == "real" ? 1 : static_cast<size_t>(shape_.back() - '0');
}

void SignalGenerator::Set(std::string_view parameter, const ParameterValue& value) {
  const ParameterValue before = Get(parameter);
  Module::Set(parameter, value);
  try {
    if (parameter == "unit") ReplaceParameters(Parameters());
    if (parameter == "sensor" || parameter == "shape" || parameter == "unit") MakePort();
    if (parameter == "file") ReadFile();
    if (is_started_) CheckSignal();
  } catch (...) {
    Module::Set(parameter, before);
    throw;
  }
}

// From here on only the samples count: a run that is resumed has them, and needs no file.
void SignalGenerator::ReadFile() {
  if (file_.empty()) return;
  SignalFile read = ReadSignalFile(file_);
  samples_ = std::move(read.samples);
  source_ = Source{std::exchange(file_, ""), read.elements, std::move(read.unit)};
}

void SignalGenerator::MakePort() {
  out_.reset();
  if (sensor_.empty()) return;
  if (sensor_ == time_.name())
    throw UserError(fmt::format("`{}.sensor` cannot be `time`: that is the robot's", name()));
  out_ = std::make_unique<SensorOut>(this, sensor_, Bind<&SignalGenerator::Read>{},
                                     SensorTypeText(shape_, unit_));
}

void SignalGenerator::Start() {
  if (out_ == nullptr) {
    throw UserError(fmt::format(
        "`{}.sensor` is empty: name the sensor that it offers, as the task declares it", name()));
  }
  CheckSource();
  CheckSignal();
  is_started_ = true;
}

void SignalGenerator::CheckSource() const {
  if (!source_) return;
  if (source_->unit != unit_) {
    throw UserError(fmt::format("`{}` is in `{}`, and `{}.unit` is `{}`: they must be the same",
                                source_->file, source_->unit, name(), unit_));
  }
  if (source_->elements != elements()) {
    throw UserError(fmt::format("`{}` has {} column{} beside the time, and a `{}` has {} elements",
                                source_->file, source_->elements, source_->elements == 1 ? "" : "s",
                                shape_, elements()));
  }
}

void SignalGenerator::CheckSignal() const {
  CheckLength("value", value_);
  CheckLength("amplitude", amplitude_);
  const bool has_samples = signal_ == kSamples || !samples_.empty();
  if (has_samples) CheckSamples(samples_, elements(), fmt::format("{}.samples", name()));
  if (signal_ != kConstant && !time_.connected())
    throw UserError(
        fmt::format("`{}.time` is not connected: connect it to `environment.time`, or "
                    "take a constant signal",
                    name()));
}

void SignalGenerator::CheckLength(std::string_view parameter,
                                  const std::vector<double>& list) const {
  if (list.empty() || list.size() == elements()) return;
  throw UserError(fmt::format("`{}.{}` has {} elements, and a `{}` has {}", name(), parameter,
                              list.size(), shape_, elements()));
}

const SensorData& SignalGenerator::Read() {
  if (!is_started_) return data_;
  if (signal_ == kSamples) {
    ReadSamples(*time_().reals());
    return data_;
  }
  double swing = 0;
  if (signal_ == kSine)
    swing = std::sin(2 * std::numbers::pi * *time_().reals() / period_ + phase_);
  for (size_t i = 0; i < elements(); ++i)
    elements_[i] = ElementOf(value_, i) + ElementOf(amplitude_, i) * swing;
  return data_;
}

void SignalGenerator::ReadSamples(double time) {
  const size_t columns = 1 + elements();
  const size_t rows = samples_.size() / columns;
  const auto time_of = [&](size_t row) { return samples_[row * columns]; };
  const double first = time_of(0);
  const double length = time_of(rows - 1) - first;
  if (loop_ && length > 0) time = first + std::fmod(std::max(time - first, 0.0), length);
  size_t low = 0;  // the last row that is not later, or the first
  for (size_t high = rows; low + 1 < high;) {
    const size_t middle = (low + high) / 2;
    (time_of(middle) <= time ? low : high) = middle;
  }
  const size_t next = std::min(low + 1, rows - 1);
  const double span = time_of(next) - time_of(low);
  const double share = span > 0 ? std::clamp((time - time_of(low)) / span, 0.0, 1.0) : 0;
  for (size_t i = 0; i < elements(); ++i) {
    const double from = samples_[low * columns + 1 + i];
    elements_[i] = from + share * (samples_[next * columns + 1 + i] - from);
  }
}

}  // namespace runtime
