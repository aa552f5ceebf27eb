#include "runtime/trainer/ctl/arguments.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/user_error.h"
#include "runtime/live/client/set_words.h"
#include "runtime/training/run/value_json.h"

namespace runtime {
namespace {

using command_line::CallError;
using command_line::Command;
// The trainer may have been started in another folder.
std::string Absolute(const std::string& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

template <class Value, class Set>
void AddValue(Command& command, const ArgumentSpec& spec, const Set& set) {
  const std::string word = CtlWord(spec);
  if (spec.is_required) {
    command.OnOption<Value>(word, set, spec.doc).Required().ValueName("");
  } else {
    command.OnOption<Value>(std::string("--") + spec.name, set, spec.doc).ValueName(word);
  }
}

// A required argument stands without its name, the others are options.
void AddArgument(Command& command, const ArgumentSpec& spec, nlohmann::json& arguments) {
  const std::string name = spec.name;
  const auto set = [&arguments, name](const auto& value) { arguments[name] = value; };
  switch (spec.type) {
    case ArgumentType::kFlag:
      command.OnFlag(
          "--" + name, [set] { set(true); }, spec.doc);
      break;
    case ArgumentType::kText:
      AddValue<std::string>(command, spec, set);
      break;
    case ArgumentType::kTaskFile:
      AddValue<std::string>(command, spec, [set](const std::string& word) { set(Absolute(word)); });
      break;
    case ArgumentType::kWhole:
      AddValue<int64_t>(command, spec, set);
      break;
    case ArgumentType::kNumber:
      AddValue<double>(command, spec, set);
      break;
    case ArgumentType::kValue:
    case ArgumentType::kObject:
      AddValue<std::string>(command, spec,
                            [set](const std::string& word) { set(ValueOfWord(word)); });
      break;
  }
}

void DeclareByTable(Command& command, const CommandSpec& spec, nlohmann::json& arguments) {
  for (const ArgumentSpec& argument : spec.arguments) AddArgument(command, argument, arguments);
}

// load FILE [as NAME]
void DeclareLoad(Command& command, const CommandSpec& spec, nlohmann::json& arguments) {
  AddArgument(command, spec.arguments[0], arguments);
  const auto set_name = [&arguments](const std::string& name) { arguments["name"] = name; };
  const auto set_words = [set_name](const std::vector<std::string>& words) {
    if (words.front() != "as") {
      throw CallError("`" + words.front() + "`: write `as NAME`");
    }
    set_name(words.back());
  };
  const char* doc = spec.arguments[1].doc;
  command.OnOption<std::vector<std::string>>("as NAME", set_words, doc).Count(2, 2).ValueName("");
  command.OnOption<std::string>("--as", set_name, doc).ValueName("NAME");
}

// set NAME VALUE; what follows may begin with `-`, or be an arrow.
void DeclareSet(Command& command, const CommandSpec& spec, nlohmann::json& arguments) {
  command.FirstWord(CtlWord(spec.arguments[0]), spec.arguments[0].doc);
  command.Notes(
      "  trainer ctl set NAME VALUE\n"
      "  trainer ctl set NAME = FROM to TO over N episodes\n"
      "A value may have a unit: `20 s`. Instead of `to` you may write → or, in quotes, `->`.");
  command.OnWords([&arguments](const std::vector<std::string>& words) {
    try {
      arguments = SetArguments(words);
    } catch (const UserError& error) {
      throw CallError(error.what());
    }
  });
}

// hold NAME NUMBER...; a number may begin with `-`.
void DeclareHold(Command& command, const CommandSpec& spec, nlohmann::json& arguments) {
  command.FirstWord(CtlWord(spec.arguments[0]), spec.arguments[0].doc);
  command.Notes(
      "  trainer ctl hold NAME NUMBER...\n"
      "As many numbers as the goal has elements, in SI units: `hold task.velocity 0.5 -0.1`.");
  command.OnWords([&arguments](const std::vector<std::string>& words) {
    if (words.size() < 2) throw CallError("`hold` needs the name of a goal and its value");
    nlohmann::json value = nlohmann::json::array();
    for (size_t i = 1; i < words.size(); ++i) value.push_back(ValueOfWord(words[i]));
    arguments = {{"name", words[0]}, {"value", value.size() == 1 ? value[0] : value}};
  });
}

// rollback NAME [VERSION] [--now]
void DeclareRollback(Command& command, const CommandSpec& spec, nlohmann::json& arguments) {
  AddArgument(command, spec.arguments[0], arguments);
  const auto set_version = [&arguments](const std::string& word) { arguments["version"] = word; };
  command.OnOption<std::string>("VERSION", set_version, spec.arguments[1].doc).ValueName("");
  AddArgument(command, spec.arguments[2], arguments);
}

// step [COUNT] [--episodes]
void DeclareStep(Command& command, const CommandSpec& spec, nlohmann::json& arguments) {
  const auto set_count = [&arguments](int64_t count) { arguments["count"] = count; };
  command.OnOption<int64_t>("COUNT", set_count, spec.arguments[0].doc).ValueName("");
  command.OnFlag(
      "--episodes", [&arguments] { arguments["unit"] = "episode"; },
      "count episodes; by default time steps");
}

// module add TYPE NAME [PARAMETER=VALUE...]
void DeclareModuleAdd(Command& command, const CommandSpec& spec, nlohmann::json& arguments) {
  AddArgument(command, spec.arguments[0], arguments);
  AddArgument(command, spec.arguments[1], arguments);
  const auto set_parameters = [&arguments](const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
      const size_t equals = setting.find('=');
      if (equals == std::string::npos) {
        throw CallError("`" + setting + "`: write `PARAMETER=VALUE`");
      }
      const std::string name = setting.substr(0, equals);
      const std::string value = setting.substr(equals + 1);
      // As in agent files, a parameter called `file` names a file.
      arguments["parameters"][name] =
          name == "file" ? nlohmann::json(Absolute(value)) : ValueOfWord(value);
    }
  };
  command
      .OnOption<std::vector<std::string>>("PARAMETER=VALUE", set_parameters, spec.arguments[2].doc)
      .ValueName("");
}

// Commands that are not written as the table says.
struct Special {
  std::string_view command;
  void (*declare)(Command& command, const CommandSpec& spec, nlohmann::json& arguments);
};
constexpr Special kSpecial[] = {{"hold", DeclareHold},         {"load", DeclareLoad},
                                {"rollback", DeclareRollback}, {"set", DeclareSet},
                                {"step", DeclareStep},         {"module_add", DeclareModuleAdd}};

}  // namespace

void AddCtlArguments(Command& command, const CommandSpec& spec, nlohmann::json& arguments) {
  const auto special = std::ranges::find(kSpecial, std::string_view(spec.name), &Special::command);
  const auto declare = special == std::end(kSpecial) ? DeclareByTable : special->declare;
  declare(command, spec, arguments);
}

std::string CtlWords(const CommandSpec& spec) {
  std::string words = spec.name;
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string CtlWord(const ArgumentSpec& spec) {
  std::string word = spec.name;
  std::ranges::transform(word, word.begin(), [](unsigned char byte) { return std::toupper(byte); });
  return word;
}

}  // namespace runtime
