#include "runtime/training/run/value_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "runtime/base/user_error.h"

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

ParameterValue ValueFromJson(const Json& json, const std::string& name) {
  std::optional<ParameterValue> value = ValueFromJson(json);
  if (value) return *std::move(value);
  if (!json.is_array()) throw UserError(fmt::format("`{}` cannot be {}", name, json.dump()));
  const auto wrong = std::ranges::find_if_not(json, &Json::is_number);
  throw UserError(
      fmt::format("`{}`: a list holds numbers only, and {} is not one", name, wrong->dump()));
}

Json ValueOfWord(const std::string& word) {
  const Json value = Json::parse(word, nullptr, false);
  const bool is_meant = value.is_number() || value.is_boolean() || value.is_array();
  return is_meant ? value : Json(word);
}

ParameterValue ParameterOfWord(const std::string& word, const std::string& name) {
  return ValueFromJson(ValueOfWord(word), name);
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
