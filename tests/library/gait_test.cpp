// std/gait against another way to compute it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/library/functions.h"

namespace library {
namespace {

// How far it is to the middle of the stand on the circle of phases.
double ToMiddle(double phase, double duty) {
  double distance = std::fmod(std::abs(phase - duty / 2), 1);
  if (distance > 0.5) distance = 1 - distance;
  return distance;
}

double Stance(const Values& values) {
  const double duty = values.at("duty")[0];
  const double ramp = values.at("ramp")[0];
  const double rest = duty / 2 - ToMiddle(values.at("phase")[0], duty);  // to the change
  if (rest > ramp / 2) return 1;
  return rest < -ramp / 2 ? 0 : rest / ramp + 0.5;
}

double Bezier(double from, double to, double x) {
  return from + (to - from) * (x * x * x + 3 * (x * x * (1 - x)));
}

double SwingHeight(const Values& values) {
  const double duty = values.at("duty")[0];
  const double height = values.at("height")[0];
  const double swing = (values.at("phase")[0] - duty) / (1 - duty);
  if (swing <= 0) return 0;
  return swing < 0.5 ? Bezier(0, height, 2 * swing) : Bezier(height, 0, 2 * swing - 1);
}

const std::vector<Input> kGaitInputs = {
    {"time", "real [s]", 0, 20},    {"period", "real [s]", 0.2, 2}, {"phase", "real", 0, 1},
    {"duty", "real", 0.1, 0.9},     {"ramp", "real", 0.01, 0.2},    {"height", "real [m]", 0, 0.3},
    {"target", "real [m]", 0, 0.3}, {"speed", "real [m/s]", 0, 2},  {"slow", "real [m/s]", 0.1, 1},
    {"lands", "bool", -1, 1},       {"air_time", "real [s]", 0, 1}, {"least", "real [s]", 0, 0.5}};

TEST(Gait, HasTheClockOfALeg) {
  const auto phase = [](const Values& values) {
    return std::fmod(values.at("time")[0], values.at("period")[0]) / values.at("period")[0];
  };
  ExpectEqual("std/gait", kGaitInputs,
              {{"phase_of(time, period)", phase},
               {"shifted(phase, quadruped_amble).z",
                [](const Values& values) { return std::fmod(values.at("phase")[0] + 0.75, 1); }},
               {"shifted(phase, biped_walk).y",
                [](const Values& values) { return std::fmod(values.at("phase")[0] + 0.5, 1); }},
               {"clock(phase).x",
                [](const Values& values) {
                  return std::sin(2 * std::numbers::pi * values.at("phase")[0]);
                }},
               {"clock(phase).y",
                [](const Values& values) {
                  return std::cos(2 * std::numbers::pi * values.at("phase")[0]);
                }},
               {"count(stands(shifted(phase, quadruped_trot), duty))", [](const Values& values) {
                  int count = 0;
                  for (const double offset : {0.0, 0.5, 0.5, 0.0})
                    count += std::fmod(values.at("phase")[0] + offset, 1) < values.at("duty")[0];
                  return count;
                }}});
}

TEST(Gait, SaysWhereTheFootShouldBe) {
  ExpectEqual("std/gait", kGaitInputs,
              {{"stance(phase, duty, ramp)", Stance},
               {"swing_height(phase, duty, height)", SwingHeight},
               {"clearance_error(height, target, speed, slow)",
                [](const Values& values) {
                  return std::pow(values.at("height")[0] - values.at("target")[0], 2) *
                         std::tanh(values.at("speed")[0] / values.at("slow")[0]);
                }},
               {"landing(lands, air_time, least)", [](const Values& values) {
                  const bool lands = values.at("lands")[0] != 0;
                  return lands ? values.at("air_time")[0] - values.at("least")[0] : 0;
                }}});
}

}  // namespace
}  // namespace library
