#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "runtime/agent/agent.h"
#include "runtime/module/suggestion.h"

namespace runtime {
namespace {

// Turns the tree of a TOML file into an Agent.
class AgentReader {
 public:
  explicit AgentReader(std::string file) : file_(std::move(file)) {}

  Agent Read(const toml::table& root) const {
    Agent agent;
    for (const auto& [key, node] : root) {
      if (key == "modules") {
        agent.modules = ReadModules(TableAt(node, "`modules`"));
      } else if (key == "connections") {
        agent.connections = ReadConnections(node);
      } else {
        Fail(key.source(), fmt::format("an agent has no `{}`{}", key.str(),
                                       Suggestion(key.str(), {"modules", "connections"})));
      }
    }
    return agent;
  }

  [[noreturn]] void Fail(const toml::source_region& source, const std::string& message) const {
    throw UserError(fmt::format("{}: {}", PlaceOf(source).ToText(), message));
  }

 private:
  SourcePlace PlaceOf(const toml::source_region& source) const {
    return {file_, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
  }

  const toml::table& TableAt(const toml::node& node, const std::string& what) const {
    if (const toml::table* table = node.as_table()) return *table;
    Fail(node.source(), what + " is no table: write [modules.NAME]");
  }

  // toml++ keeps a table in the order of its keys, not of its file.
  template <class Setting>
  static void SortByPlace(std::vector<Setting>& settings) {
    std::stable_sort(settings.begin(), settings.end(), [](const Setting& a, const Setting& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
  }

  std::vector<ModuleSetting> ReadModules(const toml::table& table) const {
    std::vector<ModuleSetting> modules;
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      modules.push_back(ReadModule(name, PlaceOf(key.source()),
                                   TableAt(node, fmt::format("the module `{}`", name))));
    }
    SortByPlace(modules);
    return modules;
  }

  ModuleSetting ReadModule(const std::string& name, const SourcePlace& place,
                           const toml::table& table) const {
    ModuleSetting module{name, "", place, {}};
    for (const auto& [key, node] : table) {
      if (key == "type") {
        module.type = ReadText(node, "`type`");
      } else {
        const std::string parameter(key.str());
        module.parameters.push_back({parameter,
                                     ReadValue(node, fmt::format("`{}.{}`", name, parameter)),
                                     PlaceOf(key.source())});
      }
    }
    SortByPlace(module.parameters);
    return module;
  }

  ParameterValue ReadValue(const toml::node& node, const std::string& what) const {
    if (const auto* flag = node.as_boolean()) return flag->get();
    if (const auto* integer = node.as_integer()) return integer->get();
    if (const auto* real = node.as_floating_point()) return real->get();
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* list = node.as_array()) return ReadNumbers(*list, what);
    Fail(node.source(), what + " is no number, text, flag or list of numbers");
  }

  std::vector<double> ReadNumbers(const toml::array& list, const std::string& what) const {
    std::vector<double> numbers;
    for (const toml::node& node : list) {
      if (!node.is_number())
        Fail(node.source(), what + " is a list of something else than numbers");
      numbers.push_back(*node.value<double>());
    }
    return numbers;
  }

  std::string ReadText(const toml::node& node, const std::string& what) const {
    if (const auto* text = node.as_string()) return text->get();
    Fail(node.source(), what + " is no text in quotes");
  }

  std::vector<ConnectionSetting> ReadConnections(const toml::node& node) const {
    constexpr const char* kForm = "`connections` is a list of pairs: [[\"a.out\", \"b.in\"], ...]";
    const toml::array* list = node.as_array();
    if (list == nullptr) Fail(node.source(), kForm);
    std::vector<ConnectionSetting> connections;
    for (const toml::node& item : *list) {
      const toml::array* pair = item.as_array();
      if (pair == nullptr || pair->size() != 2) Fail(item.source(), kForm);
      connections.push_back({ReadText(*pair->get(0), "the name of a port"),
                             ReadText(*pair->get(1), "the name of a port"),
                             PlaceOf(item.source())});
    }
    return connections;
  }

  std::string file_;
};

}  // namespace

Agent ParseAgent(std::string_view text, const std::string& name) {
  const AgentReader reader(name);
  try {
    return reader.Read(toml::parse(text));
  } catch (const toml::parse_error& error) {
    reader.Fail(error.source(), std::string(error.description()));
  }
}

Agent ReadAgent(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  // Reading a folder fails only here.
  if (!stream || !(text << stream.rdbuf())) {
    throw UserError(fmt::format("{}: cannot be read", file.string()));
  }
  return ParseAgent(text.str(), file.string());
}

}  // namespace runtime
