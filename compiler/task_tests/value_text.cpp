#include "compiler/task_tests/value_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "compiler/check/unit.h"

namespace compiler {
namespace {

std::string ElementText(double number) {
  if (std::isnan(number)) return "not a number";
  if (std::isinf(number)) return number > 0 ? "infinity" : "-infinity";
  return fmt::format("{}", number);
}

std::string ElementText(int64_t number) { return fmt::format("{}", number); }

}  // namespace

std::string ToString(const Value& value, const Type& type, const Unit& unit) {
  std::vector<std::string> texts;
  std::visit(
      [&](const auto& elements) {
        for (auto element : elements) {
          texts.push_back(type.scalar == Scalar::kBool ? (element != 0 ? "true" : "false")
                                                       : ElementText(element));
        }
      },
      value);
  std::string text = texts.front();
  if (type.shape != Shape::kScalar) text = fmt::format("({})", fmt::join(texts, ", "));
  const std::string unit_name = ToString(unit);
  return unit_name.empty() ? text : text + " " + unit_name;
}

}  // namespace compiler
