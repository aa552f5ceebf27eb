// All that a program or a language model needs to write a correct task, as one value: from the very
// lists that the compiler checks tasks against, from the grammar that the parser is made of, and
// from the manual.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/check/enumeration.h"
#include "compiler/check/sensor_catalog.h"
#include "compiler/report/report.h"
#include "compiler/spec/ebnf.h"
#include "plugins/robot/robot_description.h"

namespace compiler {

// The texts that it is made of.
struct SpecSources {
  std::string grammar;  // Task.g4
  std::string manual;   // language.md
  struct Example {
    std::string name;  // "tasks/crawling.task"
    std::string text;
  };
  std::vector<Example> examples;
};

struct SpecFunction {
  std::string name;
  std::vector<std::string> usages;  // "min(x, y)"
  std::string doc;
  std::string kind;  // "function", "of the past", "random", only in goals and starts
};

struct SpecUnit {
  std::string name;
  double factor = 1;  // one of it, in the SI unit
  std::string si;     // that unit; "" for none
};

struct SpecWord {
  std::string word;
  std::string doc;
};
struct SpecWords {
  std::string what;  // "declarations"
  std::vector<SpecWord> words;
};

struct SpecLibrary {
  std::string name;  // "std/gait"
  std::string doc;   // Markdown, with its functions
};

struct SpecExample {
  std::string name;
  std::string robot;  // "": the task declares its own sensors
  std::string text;
};

struct Spec {
  std::optional<robot::RobotDescription> robot;
  std::vector<Enumeration> enumerations;  // its links, joints and sites
  std::vector<CheckedSensor> sensors;     // a constant of the robot has `constant`
  std::vector<SpecFunction> functions;
  std::vector<SpecUnit> units;
  std::vector<SpecWords> words;
  std::vector<SpecLibrary> libraries;
  std::vector<GrammarRule> grammar;
  std::vector<SpecExample> examples;  // those of the robot first
  std::string manual;
};

// How many examples there are at most.
inline constexpr size_t kSpecExamples = 10;

// Without a robot: for tasks that declare their sensors.
Spec SpecOf(std::optional<robot::RobotDescription> robot, const SpecSources& sources);

std::string ToMarkdown(const Spec& spec);
Json ToJson(const Spec& spec);

}  // namespace compiler
