// A sensor that is computed when it is read.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "runtime/core/module/sensor_data.h"
#include "runtime/training/simulation/randomization.h"
#include "runtime/training/simulation/world.h"

namespace runtime {

// What all sensors of an episode show.
struct SensorMoment {
  const World* world = nullptr;
  double time = 0;      // since the start of the episode [s]
  uint64_t number = 0;  // another one whenever the world has changed
  Randomization::Noise noise{};
  EpisodeRandom random{0, 0};
  uint64_t since_start = 0;  // how often the world has changed in this episode
  bool is_peeking = false;   // what is read now counts for nobody but who reads it
};

// Its elements are brought up to date at most once in each moment.
class LazySensor {
 public:
  virtual ~LazySensor() = default;
  LazySensor(const LazySensor&) = delete;
  LazySensor& operator=(const LazySensor&) = delete;

  // Here, since each task reads each of its sensors in each event: mostly there is nothing to do.
  const SensorData& Read() {
    if (number_ != moment_.number) {
      if (moment_.is_peeking) {
        Keep();
      } else {
        is_peeked_ = false;
      }
      number_ = moment_.number;
      Compute();
    }
    return data_;
  }

  // From now on it shows what it showed when it was last read, until the moment is another. What
  // somebody has peeked at does not count.
  void Freeze() {
    if (is_peeked_) TakeBack();
    number_ = moment_.number;
  }
  // Whoever reads it next computes it again.
  void EndPeek() {
    if (is_peeked_) number_ = 0;
  }

 protected:
  // `moment` outlives the sensor. `type`: in the task language, "bool[link]".
  LazySensor(const SensorMoment& moment, std::string_view type, size_t element_count)
      : moment_(moment) {
    if (type.starts_with("bool")) {
      flags_ = std::make_unique<bool[]>(element_count);
      kept_flags_.resize(element_count);
      data_.data = flags_.get();
    } else {
      reals_.resize(element_count);
      kept_reals_.resize(element_count);
      data_.data = reals_.data();
    }
  }

  virtual void Compute() = 0;

  const World& world() const { return *moment_.world; }
  double time() const { return moment_.time; }
  const SensorMoment& moment() const { return moment_; }
  double* reals() { return reals_.data(); }
  size_t real_count() const { return reals_.size(); }
  bool* flags() { return flags_.get(); }

 private:
  void Keep() {
    if (is_peeked_) return;
    is_peeked_ = true;
    std::ranges::copy(reals_, kept_reals_.begin());
    std::copy_n(flags_.get(), kept_flags_.size(), kept_flags_.begin());
  }
  void TakeBack() {
    is_peeked_ = false;
    std::ranges::copy(kept_reals_, reals_.begin());
    std::ranges::copy(kept_flags_, flags_.get());
  }

  const SensorMoment& moment_;
  std::vector<double> reals_;
  std::unique_ptr<bool[]> flags_;
  SensorData data_;
  uint64_t number_ = 0;  // of the last computation
  // What it showed before somebody peeked, as long as nobody has read it since.
  std::vector<double> kept_reals_;
  std::vector<char> kept_flags_;
  bool is_peeked_ = false;
};

}  // namespace runtime
