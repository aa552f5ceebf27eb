#include "plugins/robot/toml_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/text/nearest_name.h"
#include "plugins/robot/reserved_words.h"

namespace robot {
namespace {

bool IsName(std::string_view text) {
  const auto fits = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); };
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), fits);
}

}  // namespace

toml::table ParseToml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const toml::source_position& place = error.source().begin;
    throw PlacedError(file, place.line, place.column, error.description(),
                      "the file is written in TOML 1.0, see https://toml.io");
  }
}

std::string ListNames(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += fmt::format("`{}`", names[i]);
  }
  return text;
}

std::string SuggestName(std::string_view name, const std::vector<std::string>& names) {
  if (const auto nearest = text::NearestName(name, names)) {
    return fmt::format("did you mean `{}`?", *nearest);
  }
  return names.empty() ? "there is none at all" : fmt::format("choose from {}", ListNames(names));
}

TomlValue::TomlValue(const std::string& file, const toml::node& node, std::string what)
    : file_(&file), node_(&node), position_(node.source().begin), what_(std::move(what)) {}

double TomlValue::Number() const {
  if (!node_->is_number()) FailType("a number");
  const double number = *node_->value<double>();
  if (!std::isfinite(number)) Fail(what_ + " is not finite", "give a finite number");
  return number;
}

double TomlValue::PositiveNumber() const {
  const double number = Number();
  if (number <= 0) Fail(what_ + " is not positive", "give a number above 0");
  return number;
}

double TomlValue::NumberNotBelowZero() const {
  const double number = Number();
  if (number < 0) Fail(what_ + " is negative", "give 0 or more");
  return number;
}

bool TomlValue::Flag() const {
  if (!node_->is_boolean()) FailType("true or false");
  return *node_->value<bool>();
}

int TomlValue::Count() const {
  if (!node_->is_integer()) FailType("an integer");
  const int64_t number = *node_->value<int64_t>();
  if (number < 1 || number > 1'000'000) Fail(what_ + " is out of range", "give 1 to 1000000");
  return static_cast<int>(number);
}

std::string TomlValue::Text() const {
  if (!node_->is_string()) FailType("a string in quotes");
  return *node_->value<std::string>();
}

std::string TomlValue::Name() const {
  const std::string text = Text();
  CheckIsName(text);
  return text;
}

void TomlValue::CheckIsName(std::string_view text) const {
  if (IsReservedWord(text)) {
    Fail(fmt::format("`{}` is a word of the task language and cannot be used as a name in a task",
                     text),
         fmt::format("call it otherwise, for example `{}_`", text));
  }
  if (IsName(text)) return;
  Fail(fmt::format("`{}` cannot be used as a name in a task", text),
       "use letters, digits and underscores, and do not begin with a digit");
}

std::vector<TomlValue> TomlValue::Items() const {
  const toml::array* array = node_->as_array();
  if (array == nullptr) FailType("an array");
  std::vector<TomlValue> items;
  for (size_t i = 0; i < array->size(); ++i) {
    items.emplace_back(*file_, (*array)[i], fmt::format("item {} of {}", i + 1, what_));
  }
  return items;
}

std::vector<double> TomlValue::Numbers(size_t count) const {
  std::vector<double> numbers;
  for (const TomlValue& item : Items()) numbers.push_back(item.Number());
  if (numbers.size() != count) {
    Fail(fmt::format("{} has {} numbers instead of {}", what_, numbers.size(), count),
         fmt::format("give exactly {}", count));
  }
  return numbers;
}

Vector3 TomlValue::ToVector3() const {
  const std::vector<double> numbers = Numbers(3);
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<std::pair<std::string, TomlValue>> TomlValue::Entries() const {
  std::vector<std::pair<std::string, TomlValue>> entries;
  for (const auto& [key, node] : Table()) {
    TomlValue entry(*file_, node, fmt::format("`{}` of {}", key.str(), what_));
    entry.position_ = key.source().begin;
    entries.emplace_back(std::string(key.str()), std::move(entry));
  }
  // toml++ sorts by name.
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    const auto place = [](const TomlValue& value) {
      return std::pair(value.position_.line, value.position_.column);
    };
    return place(a.second) < place(b.second);
  });
  return entries;
}

std::optional<TomlValue> TomlValue::Find(std::string_view key) const {
  const toml::node* node = Table().get(key);
  if (node == nullptr) return std::nullopt;
  return TomlValue(*file_, *node, fmt::format("`{}` of {}", key, what_));
}

TomlValue TomlValue::At(std::string_view key) const {
  if (auto value = Find(key)) return *value;
  Fail(fmt::format("{} has no `{}`", what_, key), fmt::format("add `{}`", key));
}

void TomlValue::AllowKeys(std::span<const std::string_view> keys) const {
  for (const auto& [key, value] : Entries()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::vector<std::string> names(keys.begin(), keys.end());
    value.Fail(fmt::format("unknown key `{}` in {}", key, what_), SuggestName(key, names));
  }
}

int TomlValue::IndexIn(const std::vector<std::string>& names, std::string_view kind) const {
  const std::string name = Text();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    Fail(fmt::format("there is no {} `{}`", kind, name), SuggestName(name, names));
  }
  return static_cast<int>(found - names.begin());
}

TomlValue TomlValue::Called(std::string what) const {
  TomlValue value = *this;
  value.what_ = std::move(what);
  return value;
}

void TomlValue::Fail(std::string_view message, std::string_view help) const {
  throw PlacedError(*file_, position_.line, position_.column, message, help);
}

void TomlValue::FailType(std::string_view expected) const {
  Fail(fmt::format("{} is not {}", what_, expected), fmt::format("write {}", expected));
}

const toml::table& TomlValue::Table() const {
  const toml::table* table = node_->as_table();
  if (table == nullptr) FailType("a table");
  return *table;
}

}  // namespace robot
