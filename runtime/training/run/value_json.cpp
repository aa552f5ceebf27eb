#include "runtime/training/run/value_json.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace runtime {
namespace {

using Json = nlohmann::json;

template <class Value>
Json JsonOf(const Value& value) {
  return std::visit([](const auto& each) -> Json { return each; }, value);
}

std::optional<ParameterValue> ListFromJson(const Json& json) {
  std::vector<double> list;
  for (const Json& element : json) {
    if (!element.is_number()) return std::nullopt;
    list.push_back(element.get<double>());
  }
  return list;
}

}  // namespace

bool IsInt64(const Json& json) {
  if (json.is_number_unsigned()) return std::in_range<int64_t>(json.get<uint64_t>());
  return json.is_number_integer();
}

Json ToJson(const ParameterValue& value) { return JsonOf(value); }

Json ToJson(const WrittenNumber& number) { return JsonOf(number); }

std::optional<ParameterValue> ValueFromJson(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (IsInt64(json)) return json.get<int64_t>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return json.is_array() ? ListFromJson(json) : std::nullopt;
}

std::string NumbersJson(const std::vector<double>& numbers) { return Json(numbers).dump(); }

std::optional<std::vector<double>> ParseNumbers(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  const auto list = json.is_array() ? ListFromJson(json) : std::nullopt;
  return list ? std::optional(std::get<std::vector<double>>(*list)) : std::nullopt;
}

std::optional<WrittenNumber> NumberFromJson(const Json& json) {
  if (IsInt64(json)) return json.get<int64_t>();
  if (json.is_number()) return json.get<double>();
  return std::nullopt;
}

}  // namespace runtime
