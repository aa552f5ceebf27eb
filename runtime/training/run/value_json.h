// Values of parameters as JSON: in a run's record, and where clients write and read them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runtime/core/module/module.h"
#include "runtime/training/run/change.h"

namespace runtime {

// Whether it is a whole number that int64_t holds. Beyond it, nlohmann::json wraps around.
bool IsInt64(const nlohmann::json& json);

nlohmann::json ToJson(const ParameterValue& value);
nlohmann::json ToJson(const WrittenNumber& number);

// Nothing where no parameter can have it, such as null. Numbers that no int64_t holds are reals.
std::optional<ParameterValue> ValueFromJson(const nlohmann::json& json);
// The same of a parameter that a UserError calls `name`.
ParameterValue ValueFromJson(const nlohmann::json& json, const std::string& name);
// Nothing where it is not a number.
std::optional<WrittenNumber> NumberFromJson(const nlohmann::json& json);

// The value that a word stands for which a user has written: as JSON where it is a number, a
// boolean or a list, otherwise a text.
nlohmann::json ValueOfWord(const std::string& word);
// The same of a parameter that a UserError calls `name`.
ParameterValue ParameterOfWord(const std::string& word, const std::string& name);

// A list of numbers as the run's record holds it, and back; nothing where it is no such list.
std::string NumbersJson(const std::vector<double>& numbers);
std::optional<std::vector<double>> ParseNumbers(const std::string& text);

}  // namespace runtime
