#include "runtime/core/module/module.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/variant/overloaded.h"
#include "runtime/base/suggestion.h"

namespace runtime {
namespace {

std::string RealToText(double value) {
  std::string text = fmt::format("{}", value);  // the shortest that reads back to the same bits
  if (std::isfinite(value) && text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string Quoted(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      text += fmt::format("\\u{:04x}", c);
    } else {
      text += c;
    }
  }
  return text + '"';
}

[[noreturn]] void ThrowWrongType(const std::string& parameter, const char* wanted,
                                 const ParameterValue& value) {
  throw UserError(fmt::format("`{}` is {}, and {} is not one", parameter, wanted, ToText(value)));
}

// The value as a real, if it is a number.
const double* AsReal(const ParameterValue& value, double& buffer) {
  if (const int64_t* integer = std::get_if<int64_t>(&value)) {
    buffer = static_cast<double>(*integer);
    return &buffer;
  }
  return std::get_if<double>(&value);
}

// Assigns a value to one parameter of `module`, once for each type that a parameter can have.
class Assignment {
 public:
  Assignment(const std::string& module, const Parameter& parameter, const ParameterValue& value)
      : name_(module + "." + parameter.name), parameter_(parameter), value_(value) {}

  void operator()(bool* target) const {
    const bool* flag = std::get_if<bool>(&value_);
    if (flag == nullptr) ThrowWrongType(name_, "true or false", value_);
    *target = *flag;
  }

  void operator()(int* target) const { AssignWhole(target); }
  void operator()(int64_t* target) const { AssignWhole(target); }

  void operator()(double* target) const {
    double buffer = 0;
    const double* real = AsReal(value_, buffer);
    if (real == nullptr) ThrowWrongType(name_, "a number", value_);
    parameter_.CheckRange(name_, *real);
    *target = *real;
  }

  void operator()(std::string* target) const {
    // A name may be a number: the DoF configuration 5.
    const int64_t* number = std::get_if<int64_t>(&value_);
    const std::string digits = number == nullptr ? "" : std::to_string(*number);
    const std::string* text = number == nullptr ? std::get_if<std::string>(&value_) : &digits;
    if (text == nullptr) ThrowWrongType(name_, "a string", value_);
    const auto former = parameter_.former_choices.find(*text);
    if (former != parameter_.former_choices.end()) text = &former->second;
    const auto& choices = parameter_.choices;
    if (!choices.empty() && std::find(choices.begin(), choices.end(), *text) == choices.end()) {
      throw UserError(
          fmt::format("`{}` cannot be {}{}", name_, Quoted(*text), Suggestion(*text, choices)));
    }
    *target = *text;
  }

  void operator()(std::vector<double>* target) const {
    const auto* list = std::get_if<std::vector<double>>(&value_);
    double buffer = 0;
    if (const double* one = AsReal(value_, buffer)) {  // a list of one
      parameter_.CheckRange(name_, *one);
      *target = {*one};
      return;
    }
    if (list == nullptr) ThrowWrongType(name_, "a list of numbers", value_);
    for (const double element : *list) parameter_.CheckRange(name_, element);
    *target = *list;
  }

 private:
  template <class Integer>
  void AssignWhole(Integer* target) const {
    const int64_t* integer = std::get_if<int64_t>(&value_);
    if (integer == nullptr) ThrowWrongType(name_, "an integer", value_);
    parameter_.CheckRange(name_, static_cast<double>(*integer));
    if (*integer != static_cast<Integer>(*integer)) {
      throw UserError(fmt::format("`{}` does not hold a number as large as {}", name_, *integer));
    }
    *target = static_cast<Integer>(*integer);
  }

  std::string name_;
  const Parameter& parameter_;
  const ParameterValue& value_;
};

}  // namespace

void Parameter::CheckRange(const std::string& full_name, double value) const {
  if (!std::isfinite(value)) {
    throw UserError(fmt::format("`{}` must be finite, and {} is not", full_name, value));
  }
  if (minimum <= value && value <= maximum) return;
  throw UserError(fmt::format("`{}` must lie in {} .. {}, and {} does not", full_name, minimum,
                              maximum, value));
}

std::string ToText(const ParameterValue& value) {
  return std::visit(variant::Overloaded{
                        [](bool flag) -> std::string { return flag ? "true" : "false"; },
                        [](int64_t integer) { return std::to_string(integer); },
                        [](double real) { return RealToText(real); },
                        [](const std::string& text) { return Quoted(text); },
                        [](const std::vector<double>& list) {
                          std::vector<std::string> elements;
                          for (const double element : list) elements.push_back(RealToText(element));
                          return fmt::format("[{}]", fmt::join(elements, ", "));
                        },
                    },
                    value);
}

Port& Module::FindPort(std::string_view port) const {
  std::vector<std::string> names;
  for (Port* candidate : ports_) {
    if (candidate->name() == port) return *candidate;
    names.push_back(candidate->name());
  }
  throw UserError(
      fmt::format("the module `{}` has no port `{}`{}", name_, port, Suggestion(port, names)));
}

const Parameter& Module::FindParameter(std::string_view parameter) const {
  std::vector<std::string> names;
  for (const Parameter& candidate : parameters_) {
    if (candidate.name == parameter) return candidate;
    names.push_back(candidate.name);
  }
  throw UserError(fmt::format("the module `{}` has no parameter `{}`{}", name_, parameter,
                              Suggestion(parameter, names)));
}

void Module::Set(std::string_view parameter, const ParameterValue& value) {
  const Parameter& found = FindParameter(parameter);
  std::visit(Assignment(name_, found, value), found.target);
}

ParameterValue Module::Get(std::string_view parameter) const {
  return std::visit(variant::Overloaded{[](const int* integer) -> ParameterValue {
                                          return static_cast<int64_t>(*integer);
                                        },
                                        [](const auto* other) -> ParameterValue { return *other; }},
                    FindParameter(parameter).target);
}

}  // namespace runtime
