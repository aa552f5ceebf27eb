#include "runtime/analysis/preference/preferences_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "runtime/base/user_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

constexpr const char* kHeader =
    "# Which behaviors of robots are better than which, for `trainer prefer`.\n";

class PreferencesReader {
 public:
  explicit PreferencesReader(std::filesystem::path file) : file_(std::move(file)) {}

  std::vector<Preference> Read() const {
    const toml::table table = Parse();
    std::vector<Preference> preferences;
    for (const auto& [key, value] : table) {
      const toml::array* const list = value.as_array();
      if (key != "preference" || list == nullptr) {
        Fail(value, "expected statements, each headed by [[preference]]");
      }
      for (const toml::node& statement : *list) preferences.push_back(ReadStatement(statement));
    }
    return preferences;
  }

 private:
  [[noreturn]] void Fail(const toml::source_region& place, std::string_view what) const {
    throw UserError(
        fmt::format("{}:{}:{}: {}", file_.string(), place.begin.line, place.begin.column, what));
  }
  [[noreturn]] void Fail(const toml::node& node, std::string_view what) const {
    Fail(node.source(), what);
  }

  toml::table Parse() const {
    try {
      return toml::parse(ReadText(file_));
    } catch (const toml::parse_error& error) {
      Fail(error.source(), error.description());
    }
  }

  Preference ReadStatement(const toml::node& node) const {
    constexpr const char* kForm =
        R"(a [[preference]] has `better` and `worse`, or `equal = ["seed1", "seed2"]`)";
    const toml::table* const table = node.as_table();
    if (table == nullptr) Fail(node, kForm);
    Preference preference;
    preference.line = static_cast<int>(node.source().begin.line);
    const toml::array* const equal = (*table)["equal"].as_array();
    preference.is_tie = equal != nullptr;
    if (preference.is_tie) {
      if (table->size() != 1 || equal->size() != 2) Fail(node, kForm);
      preference.better = ReadName((*equal)[0]);
      preference.worse = ReadName((*equal)[1]);
    } else {
      const toml::node* const better = table->get("better");
      const toml::node* const worse = table->get("worse");
      if (table->size() != 2 || better == nullptr || worse == nullptr) Fail(node, kForm);
      preference.better = ReadName(*better);
      preference.worse = ReadName(*worse);
    }
    if (preference.better == preference.worse) Fail(node, "a behavior is compared with itself");
    return preference;
  }

  BehaviorName ReadName(const toml::node& node) const {
    const auto text = node.value<std::string>();
    if (!text || text->empty()) {
      Fail(node, R"(expected the name of a run, "EXPERIMENT/seed1", or of one of its episodes, )"
                 R"("EXPERIMENT/seed1:1200")");
    }
    return ParseBehaviorName(*text);
  }

  const std::filesystem::path file_;
};

bool SaysTheSame(const Preference& a, const Preference& b) {
  if (a.is_tie != b.is_tie) return false;
  return (a.better == b.better && a.worse == b.worse) ||
         (a.is_tie && a.better == b.worse && a.worse == b.better);
}

std::string Quoted(const BehaviorName& name) {
  std::ostringstream text;
  text << toml::value(name.text());
  return text.str();
}

std::string TomlOf(const Preference& preference) {
  const std::string better = Quoted(preference.better);
  const std::string worse = Quoted(preference.worse);
  return preference.is_tie
             ? fmt::format("\n[[preference]]\nequal = [{}, {}]\n", better, worse)
             : fmt::format("\n[[preference]]\nbetter = {}\nworse = {}\n", better, worse);
}

}  // namespace

std::string BehaviorName::text() const {
  return episode ? fmt::format("{}:{}", run, *episode) : run;
}

BehaviorName ParseBehaviorName(std::string_view text) {
  const size_t colon = text.rfind(':');
  if (colon != std::string_view::npos) {
    int64_t episode = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, episode);
    if (error == std::errc() && rest == end) {
      return {std::string(text.substr(0, colon)), episode};
    }
  }
  return {std::string(text), std::nullopt};
}

std::string Preference::text() const {
  return fmt::format("{} {} {}", better.text(), is_tie ? "as good as" : "over", worse.text());
}

std::vector<Preference> ReadPreferences(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kPreferencesFile;
  if (!std::filesystem::exists(file)) return {};
  return PreferencesReader(file).Read();
}

size_t AddPreferences(const std::filesystem::path& folder,
                      const std::vector<Preference>& preferences) {
  const std::filesystem::path file = folder / kPreferencesFile;
  std::vector<Preference> stated = ReadPreferences(folder);
  std::string text = std::filesystem::exists(file) ? ReadText(file) : kHeader;
  if (!text.empty() && text.back() != '\n') text += '\n';
  size_t added = 0;
  for (const Preference& preference : preferences) {
    if (std::ranges::any_of(stated,
                            [&](const auto& old) { return SaysTheSame(old, preference); })) {
      continue;
    }
    stated.push_back(preference);
    text += TomlOf(preference);
    ++added;
  }
  if (added > 0) WriteFile(file, text);
  return added;
}

}  // namespace runtime
