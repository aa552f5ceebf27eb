#include "runtime/core/module/layout_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace runtime {
namespace {

using Json = nlohmann::ordered_json;

// "0 .. 2", or "3" of a single one.
std::string PlaceText(size_t first, size_t size) {
  return size == 1 ? fmt::format("{}", first) : fmt::format("{} .. {}", first, first + size - 1);
}

Json End(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

std::string ToText(const ObservationLayout& layout, const std::string& prefix) {
  size_t place_width = 0;
  size_t name_width = 0;
  size_t first = 0;
  for (const ObservedValue& value : layout.values) {
    place_width = std::max(place_width, PlaceText(first, value.size).size());
    name_width = std::max(name_width, value.name.size());
    first += value.size;
  }
  std::string text;
  first = 0;
  for (const ObservedValue& value : layout.values) {
    text += fmt::format("{}{:<{}}  {:<{}}  {}{}\n", prefix, PlaceText(first, value.size),
                        place_width, value.name, name_width, value.type,
                        value.unit.empty() ? "" : " [" + value.unit + "]");
    first += value.size;
  }
  return text;
}

Json ToJson(const ObservationLayout& layout) {
  Json json = Json::array();
  size_t first = 0;
  for (const ObservedValue& value : layout.values) {
    json.push_back({{"name", value.name},
                    {"type", value.type},
                    {"unit", value.unit},
                    {"first", first},
                    {"size", value.size},
                    {"least", End(value.minimum)},
                    {"greatest", End(value.maximum)}});
    first += value.size;
  }
  return json;
}

}  // namespace runtime
