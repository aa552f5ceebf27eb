#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <utility>

#include "base/file/read.h"
#include "base/file/search_path.h"
#include "runtime/base/suggestion.h"
#include "runtime/core/agent/agent.h"

namespace runtime {
namespace {

// Turns the tree of a TOML file into an Agent.
class AgentReader {
 public:
  explicit AgentReader(std::string file) : file_(std::move(file)) {}

  Agent Read(const toml::table& root) const {
    Agent agent;
    for (const auto& [key, node] : root) {
      if (key == "include") continue;  // has been read
      if (key == "whole") {
        agent.is_whole = ReadFlag(node, "`whole`");
      } else if (key == "libraries") {
        agent.libraries = ReadLibraries(node);
      } else if (key == "composites") {
        agent.composites = ReadComposites(TableAt(node, "`composites`"));
      } else if (!ReadPart(key, node, agent)) {
        const std::vector<std::string> keys = {"modules",   "connections", "composites",
                                               "libraries", "include",     "whole"};
        Fail(key.source(),
             fmt::format("an agent has no `{}`{}", key.str(), Suggestion(key.str(), keys)));
      }
    }
    return agent;
  }

  struct Include {
    std::string file;
    SourcePlace place;
  };
  std::vector<Include> ReadIncludes(const toml::table& root) const {
    std::vector<Include> includes;
    const toml::node* node = root.get("include");
    if (node == nullptr) return includes;
    const toml::array* list = node->as_array();
    if (list == nullptr) Fail(node->source(), "`include` is a list of files: [\"base.toml\"]");
    for (const toml::node& item : *list) {
      includes.push_back({ReadText(item, "the name of a file"), PlaceOf(item.source())});
    }
    return includes;
  }

  [[noreturn]] void Fail(const toml::source_region& source, const std::string& message) const {
    throw UserError(fmt::format("{}: {}", PlaceOf(source).ToText(), message));
  }

 private:
  // Modules and connections, which the whole and a composite have. False for any other key.
  bool ReadPart(const toml::key& key, const toml::node& node, Agent& agent) const {
    if (key == "modules") {
      agent.modules = ReadModules(TableAt(node, "`modules`"));
    } else if (key == "connections") {
      agent.connections = ReadConnections(node);
    } else {
      return false;
    }
    return true;
  }

  std::vector<LibrarySetting> ReadLibraries(const toml::node& node) const {
    const toml::array* list = node.as_array();
    if (list == nullptr) Fail(node.source(), "`libraries` is a list of files: [\"lidar.so\"]");
    std::vector<LibrarySetting> libraries;
    for (const toml::node& item : *list) {
      libraries.push_back({ReadText(item, "the name of a library"), PlaceOf(item.source())});
    }
    return libraries;
  }

  std::vector<CompositeSetting> ReadComposites(const toml::table& table) const {
    std::vector<CompositeSetting> composites;
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      composites.push_back(ReadComposite(name, PlaceOf(key.source()),
                                         TableAt(node, fmt::format("the composite `{}`", name))));
    }
    SortByPlace(composites);
    return composites;
  }

  CompositeSetting ReadComposite(const std::string& name, const SourcePlace& place,
                                 const toml::table& table) const {
    CompositeSetting composite{name, place, {}, {}, {}};
    for (const auto& [key, node] : table) {
      if (key == "ports") {
        composite.ports = ReadExports(node, "`ports`");
      } else if (key == "parameters") {
        composite.parameters = ReadExports(node, "`parameters`");
      } else if (!ReadPart(key, node, composite.inside)) {
        const std::vector<std::string> keys = {"modules", "connections", "ports", "parameters"};
        Fail(key.source(),
             fmt::format("a composite has no `{}`{}", key.str(), Suggestion(key.str(), keys)));
      }
    }
    return composite;
  }

  // {state = "features.state"}
  std::vector<ExportSetting> ReadExports(const toml::node& node, const std::string& what) const {
    const toml::table* table = node.as_table();
    if (table == nullptr) Fail(node.source(), what + " is not a table: {NAME = \"MODULE.NAME\"}");
    std::vector<ExportSetting> exports;
    for (const auto& [key, inner] : *table) {
      exports.push_back({std::string(key.str()), ReadText(inner, fmt::format("`{}`", key.str())),
                         PlaceOf(key.source())});
    }
    SortByPlace(exports);
    return exports;
  }

  SourcePlace PlaceOf(const toml::source_region& source) const {
    return {file_, static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
  }

  const toml::table& TableAt(const toml::node& node, const std::string& what) const {
    if (const toml::table* table = node.as_table()) return *table;
    Fail(node.source(), what + " is not a table: write [modules.NAME]");
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
    Fail(node.source(), what + " is not a number, string, boolean or list of numbers");
  }

  std::vector<double> ReadNumbers(const toml::array& list, const std::string& what) const {
    std::vector<double> numbers;
    for (const toml::node& node : list) {
      if (!node.is_number())
        Fail(node.source(), what + " is a list of something other than numbers");
      numbers.push_back(*node.value<double>());
    }
    return numbers;
  }

  std::string ReadText(const toml::node& node, const std::string& what) const {
    if (const auto* text = node.as_string()) return text->get();
    Fail(node.source(), what + " is not a quoted string");
  }

  bool ReadFlag(const toml::node& node, const std::string& what) const {
    if (const auto* flag = node.as_boolean()) return flag->get();
    Fail(node.source(), what + " is neither true nor false");
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

toml::table Parse(std::string_view text, const AgentReader& reader) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    reader.Fail(error.source(), std::string(error.description()));
  }
}

// A library, and what a parameter called `file` names, is a file beside the agent file.
void NameFilesFrom(const std::filesystem::path& folder, Agent& agent) {
  for (LibrarySetting& library : agent.libraries) {
    library.file = (folder / library.file).lexically_normal().string();
  }
  for (ModuleSetting& module : agent.modules) {
    for (ParameterSetting& parameter : module.parameters) {
      auto* path = std::get_if<std::string>(&parameter.value);
      if (parameter.name != "file" || path == nullptr || path->empty()) continue;
      *path = (folder / *path).lexically_normal().string();
    }
  }
  for (CompositeSetting& composite : agent.composites) NameFilesFrom(folder, composite.inside);
}

// Reads files one inside the other.
class FileReader {
 public:
  explicit FileReader(std::filesystem::path robot_folder)
      : robot_folder_(std::move(robot_folder)) {}

  Agent Read(const std::filesystem::path& file) {
    const AgentReader reader(file.string());
    const toml::table root = Parse(TextOf(file), reader);
    open_.push_back(std::filesystem::weakly_canonical(file));
    Agent agent;
    for (const AgentReader::Include& include : reader.ReadIncludes(root)) {
      agent = Joined(std::move(agent), ReadIncluded(FileOf(include, file.parent_path()), include));
    }
    open_.pop_back();
    Agent own = reader.Read(root);
    NameFilesFrom(file.parent_path(), own);
    return Joined(std::move(agent), own);
  }

 private:
  // What is not there comes with the trainer, or is nowhere.
  std::filesystem::path FileOf(const AgentReader::Include& include,
                               const std::filesystem::path& folder) const {
    const bool is_file = IsAgentFile(include.file);
    const std::string name = include.file + (is_file ? "" : std::string(kAgentEnding));
    std::filesystem::path own = (is_file ? folder : robot_folder_) / name;
    const std::filesystem::path shared = is_file ? file::SharedFolder() : AgentsOfAnyRobot();
    return std::filesystem::exists(own) || !std::filesystem::exists(shared / name) ? own
                                                                                   : shared / name;
  }

  Agent ReadIncluded(const std::filesystem::path& file, const AgentReader::Include& include) {
    const auto is_open = std::ranges::find(open_, std::filesystem::weakly_canonical(file));
    if (is_open != open_.end()) {
      throw UserError(
          fmt::format("{}: `{}` includes itself", include.place.ToText(), include.file));
    }
    if (!std::filesystem::exists(file)) {
      throw UserError(
          fmt::format("{}: there is no file `{}`", include.place.ToText(), file.string()));
    }
    return Read(file);
  }

  static std::string TextOf(const std::filesystem::path& file) {
    file::Reading reading = file::Read(file);
    if (reading.problem.empty()) return std::move(reading.bytes);
    throw UserError(fmt::format("{}: cannot be read: {}", file.string(), reading.problem));
  }

  const std::filesystem::path robot_folder_;
  std::vector<std::filesystem::path> open_;  // those that are being read
};

}  // namespace

Agent ParseAgent(std::string_view text, const std::string& name) {
  const AgentReader reader(name);
  const toml::table root = Parse(text, reader);
  for (const AgentReader::Include& include : reader.ReadIncludes(root)) {
    throw UserError(
        fmt::format("{}: only a file can include `{}`", include.place.ToText(), include.file));
  }
  return reader.Read(root);
}

std::filesystem::path AgentsOfAnyRobot() { return file::SharedFolder() / "agents"; }

std::filesystem::path AgentsWithoutRobot() { return AgentsOfAnyRobot() / "without_robot"; }

bool IsAgentFile(const std::string& agent) {
  return agent.find('/') != std::string::npos || agent.ends_with(".toml");
}

Agent ReadAgent(const std::filesystem::path& file, const std::filesystem::path& robot_folder) {
  return FileReader(robot_folder).Read(file);
}

}  // namespace runtime
