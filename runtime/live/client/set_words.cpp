#include "runtime/live/client/set_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <regex>

#include "runtime/base/user_error.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr const char* kForms =
    "write `set NAME VALUE`, or `set NAME = FROM to TO over N episodes` for a schedule; `->` may "
    "stand for `to`, but only in quotes: the shell takes `>` for itself";

// A name, and what follows it.
const std::regex kSetting(R"(\s*([^\s=]+)(?:\s*=\s*|\s+)([^\s=].*?)\s*)");
const std::regex kSchedule(R"((\S+)\s*(?:->|→|\bto\b)\s*(\S+)\s+over\s+(\d+)\s+episodes?)");
// What only somebody writes who means a schedule.
const std::regex kLooksLikeSchedule(R"(.*(->|→|\bover\b|\bepisodes?\b).*)");

double Number(const std::string& text) {
  const json value = ValueOfWord(text);
  if (value.is_number()) return value;
  throw UserError(fmt::format("`{}` is not a number; {}", text, kForms));
}

int64_t Count(const std::string& digits) {
  const json value = ValueOfWord(digits);
  if (value.is_number_integer()) return value;
  throw UserError(fmt::format("{} is too many episodes", digits));
}

}  // namespace

json SetArguments(const std::vector<std::string>& words) {
  const std::string text = fmt::format("{}", fmt::join(words, " "));
  std::smatch setting;
  if (!std::regex_match(text, setting, kSetting)) throw UserError(kForms);
  const std::string name = setting[1];
  const std::string value = setting[2];
  std::smatch schedule;
  if (std::regex_match(value, schedule, kSchedule)) {
    return {{"name", name},
            {"from", Number(schedule[1])},
            {"to", Number(schedule[2])},
            {"episodes", Count(schedule[3])}};
  }
  if (std::regex_match(value, kLooksLikeSchedule)) throw UserError(kForms);
  return {{"name", name}, {"value", ValueOfWord(value)}};
}

}  // namespace runtime
