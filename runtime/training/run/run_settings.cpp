#include "runtime/training/run/run_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace runtime {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson ToJson(const std::vector<Setting>& settings) {
  OrderedJson json = OrderedJson::array();
  for (const Setting& setting : settings) {
    json.push_back({{"name", setting.name}, {"value", setting.value}, {"origin", setting.origin}});
  }
  return json;
}

std::string Text(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

// A word as a shell reads it.
std::string ShellWord(const std::string& word) {
  const bool is_plain = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("_-+=.,:/@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// The words of a call; none where the text is no list of texts.
std::vector<std::string> WordsOf(const std::string& call) {
  std::vector<std::string> words;
  const OrderedJson json = OrderedJson::parse(call, nullptr, false);
  if (!json.is_array()) return words;
  for (const OrderedJson& word : json) {
    if (word.is_string()) words.push_back(word.get<std::string>());
  }
  return words;
}

}  // namespace

std::string SettingsText(const std::vector<Setting>& settings) { return Text(ToJson(settings)); }

std::string CallText(const std::vector<std::string>& words) { return Text(OrderedJson(words)); }

std::vector<Setting> SettingsOf(const RunRecord& run) {
  std::vector<Setting> settings;
  const OrderedJson json = OrderedJson::parse(run.settings, nullptr, false);
  if (!json.is_array()) return settings;
  const auto text = [](const OrderedJson& setting, const char* key) {
    const auto found = setting.find(key);
    return found != setting.end() && found->is_string() ? found->get<std::string>() : "";
  };
  for (const OrderedJson& setting : json) {
    if (!setting.is_object()) continue;
    settings.push_back({text(setting, "name"), text(setting, "value"), text(setting, "origin")});
  }
  return settings;
}

OrderedJson SettingsJson(const RunRecord& run) { return ToJson(SettingsOf(run)); }

std::string NameOfRuns(const RunRecord& run) {
  const std::string& task = run.tasks.front().task;
  return run.profile.empty() ? task : fmt::format("{}-{}", task, run.profile);
}

std::string RobotText(const RunRecord& run) {
  return run.robot.empty() ? "no robot"
                           : fmt::format("robot {}, profile {}", run.robot, run.profile);
}

std::string TrainCommand(const RunRecord& run, int64_t runs) {
  std::vector<std::string> words = WordsOf(run.call);
  if (words.empty()) return "";
  if (!run.profile.empty()) words.insert(words.end(), {"--profile", run.profile});
  words.insert(words.end(), {"--episodes", std::to_string(run.episodes_planned), "--seed",
                             std::to_string(run.seed)});
  if (runs > 1) words.insert(words.end(), {"--runs", std::to_string(runs)});
  std::string command = "trainer train";
  for (const std::string& word : words) command += " " + ShellWord(word);
  return command;
}

}  // namespace runtime
