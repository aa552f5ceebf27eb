// std/kernels against their formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/library/functions.h"

namespace library {
namespace {

// Of an error and a width.
Call KernelCall(const std::string& name, double (*kernel)(double error, double width)) {
  return {name + "(error, width)", [kernel](const Values& values) {
            return kernel(values.at("error")[0], values.at("width")[0]);
          }};
}

TEST(Kernels, AreAsPublished) {
  ExpectEqual(
      "std/kernels", {{"error", "real [rad]", -4, 4}, {"width", "real [rad]", 0.2, 3}},
      {KernelCall("squared_kernel",
                  [](double error, double width) {
                    return std::exp(-std::pow(error, 2) / std::pow(width, 2));
                  }),
       KernelCall("exponential_kernel",
                  [](double error, double width) { return std::pow(std::exp(-error), 1 / width); }),
       KernelCall("gaussian_kernel",
                  [](double error, double width) {
                    return std::exp(-std::pow(error, 2) / (2 * std::pow(width, 2)));
                  }),
       KernelCall("tanh_kernel",
                  [](double error, double width) { return 1 - std::tanh(error / width); }),
       KernelCall(
           "logistic_kernel",
           [](double error, double width) { return 1 / (2 + 2 * std::cosh(error / width)); }),
       KernelCall("huber", [](double error, double width) {
         const double size = std::abs(error);
         return size <= width ? error * error / 2 : width * (size - width / 2);
       })});
}

}  // namespace
}  // namespace library
