// The verbs and their options as data, read from the parsed command line's own declarations: what
// the shells' completions are written from.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace compiler {

struct CompletedValue {
  enum Kind { kNone, kWords, kTask, kFile, kFolder };
  Kind kind = kNone;
  std::vector<std::string> words;  // of kWords
};

struct CompletedOption {
  std::vector<std::string> names;  // "-o", "--output"
  std::string description;
  CompletedValue value;  // kNone: a flag
};

struct CompletedVerb {
  std::string name;
  std::string title;
  std::vector<CompletedOption> options;
  CompletedValue argument;
};

// `app`: that of the whole program.
std::vector<CompletedVerb> VerbsOf(const CLI::App& app);

}  // namespace compiler
