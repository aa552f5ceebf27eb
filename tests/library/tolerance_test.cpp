// std/tolerance against the formulas of dm_control.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/library/functions.h"

namespace library {
namespace {

using Sigmoid = double (*)(double x, double value_at_1);

double Tolerance(const Values& values, Sigmoid sigmoid, double value) {
  const double x = values.at("x")[0];
  const double low = values.at("low")[0];
  const double high = low + values.at("width")[0];
  if (low <= x && x <= high) return 1;
  return sigmoid((x < low ? low - x : x - high) / values.at("margin")[0], value);
}

Call ToleranceCall(const std::string& name, Sigmoid sigmoid) {
  return {name + "_tolerance(x, low, low + width, margin, left)",
          [=](const Values& values) { return Tolerance(values, sigmoid, values.at("left")[0]); }};
}

double Gaussian(double x, double value) {
  return std::exp(-0.5 * std::pow(x * std::sqrt(-2 * std::log(value)), 2));
}

const std::vector<Input> kToleranceInputs = {{"x", "real [m]", -3, 3},
                                             {"low", "real [m]", -2, 1},
                                             {"width", "real [m]", 0, 1},
                                             {"margin", "real [m]", 0.2, 2},
                                             {"left", "real", 0.05, 0.95}};

TEST(Tolerance, HasTheShapesAsPublished) {
  ExpectEqual(
      "std/tolerance", kToleranceInputs,
      {ToleranceCall("gaussian", Gaussian),
       ToleranceCall("hyperbolic",
                     [](double x, double v) { return 1 / std::cosh(x * std::acosh(1 / v)); }),
       ToleranceCall(
           "long_tail",
           [](double x, double v) { return 1 / (std::pow(x * std::sqrt(1 / v - 1), 2) + 1); }),
       ToleranceCall("reciprocal", [](double x, double v) { return 1 / (x * (1 / v - 1) + 1); }),
       ToleranceCall("cosine",
                     [](double x, double v) {
                       const double scaled = x * std::acos(2 * v - 1) / std::numbers::pi;
                       return scaled < 1 ? (1 + std::cos(std::numbers::pi * scaled)) / 2 : 0.0;
                     }),
       ToleranceCall("linear",
                     [](double x, double v) {
                       const double scaled = x * (1 - v);
                       return scaled < 1 ? 1 - scaled : 0.0;
                     }),
       ToleranceCall("quadratic",
                     [](double x, double v) {
                       const double scaled = x * std::sqrt(1 - v);
                       return scaled < 1 ? 1 - scaled * scaled : 0.0;
                     }),
       ToleranceCall("tanh_squared", [](double x, double v) {
         return 1 - std::pow(std::tanh(x * std::atanh(std::sqrt(1 - v))), 2);
       })});
}

TEST(Tolerance, MayLeaveNothing) {
  ExpectEqual("std/tolerance", kToleranceInputs,
              {{"linear_tolerance(x, low, low + width, margin, 0)",
                [](const Values& values) {
                  return Tolerance(
                      values, [](double x, double) { return x < 1 ? 1 - x : 0.0; }, 0);
                }},
               {"quadratic_tolerance(x, low, low + width, margin, 0)",
                [](const Values& values) {
                  return Tolerance(
                      values, [](double x, double) { return x < 1 ? 1 - x * x : 0.0; }, 0);
                }},
               {"cosine_tolerance(x, low, low + width, margin, 0)", [](const Values& values) {
                  return Tolerance(
                      values,
                      [](double x, double) {
                        return x < 1 ? (1 + std::cos(std::numbers::pi * x)) / 2 : 0.0;
                      },
                      0);
                }}});
}

TEST(Tolerance, HasOneBound) {
  ExpectEqual("std/tolerance", kToleranceInputs,
              {{"outside(x, low, low + width)",
                [](const Values& values) {
                  const double x = values.at("x")[0];
                  const double low = values.at("low")[0];
                  const double high = low + values.at("width")[0];
                  return x < low ? low - x : x > high ? x - high : 0;
                }},
               {"at_least(x, low, margin)",
                [](const Values& values) {
                  const double d = values.at("low")[0] - values.at("x")[0];
                  return d <= 0 ? 1 : Gaussian(d / values.at("margin")[0], 0.1);
                }},
               {"at_most(x, low, margin)", [](const Values& values) {
                  const double d = values.at("x")[0] - values.at("low")[0];
                  return d <= 0 ? 1 : Gaussian(d / values.at("margin")[0], 0.1);
                }}});
}

}  // namespace
}  // namespace library
