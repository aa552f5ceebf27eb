#include "compiler/driver/command_tree.h"

#include <algorithm>
#include <sstream>

#include "compiler/source/diagnostic_table.h"

namespace compiler {
namespace {

// "text|json|sarif" says its words; FILE.md|FILE.html does not.
CompletedValue WordsIn(const std::string& type) {
  CompletedValue value{CompletedValue::kWords, {}};
  std::istringstream stream(type);
  for (std::string word; std::getline(stream, word, '|');) value.words.push_back(word);
  return value;
}

CompletedValue ValueOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::string name = option.get_name();
  if (type == "DIR") return {CompletedValue::kFolder, {}};
  if (type.find('|') != std::string::npos && type.find("FILE") == std::string::npos) {
    return WordsIn(type);
  }
  if (type == "ROBOT" || name == "NAME") return {CompletedValue::kWords, {}};
  if (name == "FILE.task") return {CompletedValue::kTask, {}};
  if (name == "CODE") {
    CompletedValue codes{CompletedValue::kWords, {}};
    for (const DiagnosticKind& kind : kDiagnosticTable) codes.words.emplace_back(kind.code);
    return codes;
  }
  return {CompletedValue::kFile, {}};
}

CompletedOption Completed(const CLI::Option& option) {
  CompletedOption completed{{}, option.get_description(), {}};
  for (const std::string& name : option.get_snames()) completed.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) completed.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) completed.value = ValueOf(option);
  return completed;
}

}  // namespace

std::vector<CompletedVerb> VerbsOf(const CLI::App& app) {
  std::vector<CompletedVerb> verbs;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    CompletedVerb verb{command->get_name(), command->get_description(), {}, {}};
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_group().empty()) continue;  // hidden
      if (option->get_positional()) {
        verb.argument = ValueOf(*option);
      } else {
        verb.options.push_back(Completed(*option));
      }
    }
    verbs.push_back(std::move(verb));
  }
  return verbs;
}

}  // namespace compiler
