// taskc completion bash|zsh|fish
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "compiler/driver/command_tree.h"
#include "compiler/driver/verb.h"

namespace compiler {
namespace {

// For all three shells: text between single quotes.
std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// ---- bash ---------------------------------------------------------------------------------------

// The command that completes `$current`.
std::string BashReply(const CompletedValue& value) {
  switch (value.kind) {
    case CompletedValue::kNone:
      return ":";
    case CompletedValue::kWords:
      return fmt::format("compgen -W {} -- \"$current\"",
                         Quoted(fmt::format("{}", fmt::join(value.words, " "))));
    case CompletedValue::kTask:
      return "compgen -f -X '!*.task' -- \"$current\"; compgen -d -- \"$current\"";
    case CompletedValue::kFile:
      return "compgen -f -- \"$current\"";
    case CompletedValue::kFolder:
      return "compgen -d -- \"$current\"";
  }
  return ":";
}

std::string ToBash(const std::vector<CompletedVerb>& verbs) {
  std::string names, values, words, arguments;
  for (const CompletedVerb& verb : verbs) {
    names += verb.name + " ";
    words += "    " + verb.name + ") words='";
    for (const CompletedOption& option : verb.options) {
      for (const std::string& name : option.names) {
        words += name + " ";
        if (option.value.kind == CompletedValue::kNone) continue;
        values +=
            fmt::format("    {}:{}) reply=$({}) ;;\n", verb.name, name, BashReply(option.value));
      }
    }
    words += "' ;;\n";
    arguments += fmt::format("    {}) reply=$({}) ;;\n", verb.name, BashReply(verb.argument));
  }
  return "# Completion of taskc for bash.\n"
         "_taskc() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  local verb=${COMP_WORDS[1]} words='--help --version' reply=''\n"
         "  case $verb:$previous in\n" +
         values +
         "    *) reply=none ;;\n"
         "  esac\n"
         "  if [[ $reply != none ]]; then\n"
         "    :\n"
         "  elif ((COMP_CWORD == 1)); then\n"
         "    reply=$(compgen -W \"" +
         names +
         "$words\" -- \"$current\")\n"
         "  elif [[ $current == -* ]]; then\n"
         "    case $verb in\n" +
         words +
         "    esac\n"
         "    reply=$(compgen -W \"$words\" -- \"$current\")\n"
         "  else\n"
         "    case $verb in\n" +
         arguments +
         "    *) reply='' ;;\n"
         "    esac\n"
         "  fi\n"
         "  mapfile -t COMPREPLY < <(printf '%s' \"$reply\")\n"
         "}\n"
         "complete -o filenames -F _taskc taskc\n";
}

// ---- zsh ----------------------------------------------------------------------------------------

std::string ZshAction(const CompletedValue& value) {
  switch (value.kind) {
    case CompletedValue::kNone:
      return "";
    case CompletedValue::kWords:
      return fmt::format("({})", fmt::join(value.words, " "));
    case CompletedValue::kTask:
      return "_files -g \"*.task\"";
    case CompletedValue::kFile:
      return "_files";
    case CompletedValue::kFolder:
      return "_files -/";
  }
  return "";
}

// In the words of _arguments, where a few signs have a meaning.
std::string ZshText(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string ZshArguments(const CompletedVerb& verb) {
  std::string text = "    " + verb.name + ") _arguments";
  for (const CompletedOption& option : verb.options) {
    for (const std::string& name : option.names) {
      std::string spec = fmt::format("{}[{}]", name, ZshText(option.description));
      if (option.value.kind != CompletedValue::kNone) spec += ": :" + ZshAction(option.value);
      text += " " + Quoted(spec);
    }
  }
  if (verb.argument.kind != CompletedValue::kNone) {
    text += " " + Quoted("*: :" + ZshAction(verb.argument));
  }
  return text + " ;;\n";
}

std::string ToZsh(const std::vector<CompletedVerb>& verbs) {
  std::string text =
      "#compdef taskc\n"
      "# Completion of taskc for zsh.\n"
      "_taskc() {\n"
      "  if ((CURRENT == 2)); then\n"
      "    local -a verbs=(\n";
  for (const CompletedVerb& verb : verbs) {
    text += "      " + Quoted(ZshText(verb.name) + ":" + verb.title) + "\n";
  }
  text +=
      "    )\n"
      "    _describe 'verb' verbs\n"
      "    return\n"
      "  fi\n"
      "  local verb=$words[2]\n"
      "  shift words; ((CURRENT--))\n"
      "  case $verb in\n";
  for (const CompletedVerb& verb : verbs) text += ZshArguments(verb);
  return text +
         "  esac\n"
         "}\n"
         "compdef _taskc taskc\n";
}

// ---- fish ---------------------------------------------------------------------------------------

std::string FishValue(const CompletedValue& value) {
  switch (value.kind) {
    case CompletedValue::kNone:
      return "";
    case CompletedValue::kWords:
      return " -x -a " + Quoted(fmt::format("{}", fmt::join(value.words, " ")));
    case CompletedValue::kTask:
      return " -x -a '(__fish_complete_suffix .task)'";
    case CompletedValue::kFile:
      return " -r -F";
    case CompletedValue::kFolder:
      return " -x -a '(__fish_complete_directories)'";
  }
  return "";
}

std::string ToFish(const std::vector<CompletedVerb>& verbs) {
  std::string text = "# Completion of taskc for fish.\ncomplete -c taskc -f\n";
  for (const CompletedVerb& verb : verbs) {
    text += fmt::format("complete -c taskc -n __fish_use_subcommand -a {} -d {}\n", verb.name,
                        Quoted(verb.title));
    const std::string inside =
        fmt::format("complete -c taskc -n '__fish_seen_subcommand_from {}'", verb.name);
    for (const CompletedOption& option : verb.options) {
      text += inside;
      for (const std::string& name : option.names) {
        const bool is_long = name.starts_with("--");
        text += (is_long ? " -l " : " -s ") + name.substr(is_long ? 2 : 1);
      }
      text += " -d " + Quoted(option.description) + FishValue(option.value) + "\n";
    }
    if (verb.argument.kind != CompletedValue::kNone) {
      text += inside + FishValue(verb.argument) + "\n";
    }
  }
  return text;
}

}  // namespace

Action DeclareCompletion(CLI::App& app, Session&) {
  auto shell = std::make_shared<std::string>();
  AddChoice(app, "SHELL", *shell, {"bash", "zsh", "fish"}, "for which shell")->required();
  return [shell, program = app.get_parent()](Session&) {
    const std::vector<CompletedVerb> verbs = VerbsOf(*program);
    fmt::print("{}", *shell == "bash"  ? ToBash(verbs)
                     : *shell == "zsh" ? ToZsh(verbs)
                                       : ToFish(verbs));
    return ExitStatus::kOk;
  };
}

}  // namespace compiler
