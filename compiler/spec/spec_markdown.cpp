#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compiler/check/unit.h"
#include "compiler/spec/manual.h"
#include "compiler/spec/spec.h"

namespace compiler {
namespace {

// Of the manual: what no list says. The rest of it is in the tables and the examples.
constexpr const char* kSections[] = {
    "Lines and comments", "Types",      "Units",     "Expressions",
    "Elements",           "Index sets", "Functions", "Functions of the past"};

constexpr const char* kIntroduction =
    "This page is all that is needed to write a task: what an episode is paid for, when it ends, "
    "and what is measured. It is made by `taskc spec` from the lists that the compiler itself "
    "uses.\n\n"
    "How to proceed:\n\n"
    "1. Write a file NAME.task: a header, declarations, events.\n"
    "2. `taskc check NAME.task --json` reports all mistakes, each with its place and, where there "
    "are any, `fixes`: put `text` in the place of the bytes from `offset` to `end_offset`. "
    "`taskc check --fix NAME.task` does that for every error with one fix.\n"
    "3. Repeat until `errors` is 0; then mind the warnings: they name what a learner would "
    "exploit, or what can never happen.\n"
    "4. Write tests into the file, and run them: `taskc test NAME.task`.\n\n"
    "`taskc explain CODE` explains a mistake. Names are those below and nothing else: there are no "
    "hidden sensors or functions. Every quantity has a unit, and the compiler checks it.\n";

constexpr const char* kGrammarWords =
    "In the EBNF of the W3C. `end_of_line` is a line's end where a statement can end: not inside "
    "of `( )` and `[ ]`, not after an operator or a comma, and not before `{`, `else`, `in`, `per` "
    "or `->`. Between tokens there may be blanks and comments.\n";

std::string Number(double value) {
  return std::isfinite(value) ? fmt::format("{:.5g}", value) : "any";
}

// "-0.5 .. 2"; of elements with different ranges, all that any of them can be.
std::string RangeOf(const CheckedSensor& sensor) {
  if (!sensor.constant.empty()) {
    const auto [least, greatest] = std::ranges::minmax(sensor.constant);
    return least == greatest ? Number(least) : Number(least) + " .. " + Number(greatest);
  }
  const double least = std::ranges::min(sensor.minimum);
  const double greatest = std::ranges::max(sensor.maximum);
  if (sensor.type.scalar == Scalar::kBool) return "";
  if (std::isinf(least) && std::isinf(greatest)) return "any";
  if (std::isinf(least)) return Number(greatest) + " or less";
  if (std::isinf(greatest)) return Number(least) + " or more";
  return Number(least) + " .. " + Number(greatest);
}

void AddSensors(const Spec& spec, std::string& page) {
  page +=
      "\n## Sensors\n\nRanges are in the unit; of an array, from the least to the greatest of all "
      "elements.\n\n| sensor | type | range | onboard | |\n|---|---|---|---|---|\n";
  for (const CheckedSensor& sensor : spec.sensors) {
    if (!sensor.constant.empty()) continue;
    page += fmt::format("| `{}` | `{}` | {} | {} | {} |\n", sensor.name,
                        TypeText(sensor.type, sensor.unit), RangeOf(sensor),
                        sensor.is_onboard ? "yes" : "no", sensor.doc);
  }
  page +=
      "\nWhat is known before any run is read in the same way, also where a constant is "
      "needed:\n\n| constant | type | values | |\n|---|---|---|---|\n";
  for (const CheckedSensor& sensor : spec.sensors) {
    if (sensor.constant.empty()) continue;
    page += fmt::format("| `{}` | `{}` | {} | {} |\n", sensor.name,
                        TypeText(sensor.type, sensor.unit), RangeOf(sensor), sensor.doc);
  }
}

std::string Names(const std::vector<std::string>& names) {
  return fmt::format("`{}`", fmt::join(names, "` `"));
}

void AddParts(const Enumeration& parts, std::string& page) {
  page += fmt::format("\n- Each {0}, an index of every `...[{0}]`: {1}. All of them: `{2}`.\n",
                      parts.name, Names(parts.members), parts.all);
  for (const robot::Group& group : parts.groups) {
    std::vector<std::string> members;
    for (const int member : group.members)
      members.push_back(parts.members[static_cast<size_t>(member)]);
    page += fmt::format("- The set `{}`: {}.\n", group.name, Names(members));
  }
}

void AddRobot(const Spec& spec, std::string& page) {
  const robot::RobotDescription& robot = *spec.robot;
  page += fmt::format(
      "\n## The robot `{0}`\n\n{1}\n\nThe header of its tasks: `task NAME for {0}`. "
      "It faces +x, +y is to its left, +z is up. The time step is {2} s.\n",
      robot.name, robot.doc, robot.controller.time_step);
  std::vector<std::string> poses;
  for (const robot::Pose& pose : robot.poses) poses.push_back(pose.name);
  if (!poses.empty()) page += fmt::format("\n- Poses for `start`: {}.", Names(poses));
  for (const Enumeration& parts : spec.enumerations) AddParts(parts, page);
  AddSensors(spec, page);
}

void AddWithoutRobot(std::string& page) {
  page +=
      "\n## Sensors\n\nThe task declares its own, and whatever runs it supplies them: `sensor "
      "NAME: TYPE [UNIT] in LOW .. HIGH`. With `--robot NAME` this page lists those of a "
      "robot.\n";
}

void AddWords(const Spec& spec, std::string& page) {
  page += "\n## Words\n";
  for (const SpecWords& words : spec.words) {
    page += fmt::format("\n### {}\n\n", words.what);
    for (const SpecWord& word : words.words)
      page += fmt::format("- `{}`: {}\n", word.word, word.doc);
  }
}

// Between a heading of this level and its text.
void AddSection(const std::string& heading, const std::string& text, std::string& page) {
  page += fmt::format("\n## {}\n\n{}\n", heading, text);
}

void AddRandom(const Spec& spec, std::string& page) {
  page +=
      "\n## Random values\n\nOnly in the equation of a `goal`, and in the block of `start`.\n\n";
  for (const SpecFunction& function : spec.functions) {
    if (function.kind == "random")
      page += fmt::format("- `{}`: {}\n", fmt::join(function.usages, "` `"), function.doc);
  }
}

void AddExamples(const Spec& spec, std::string& page) {
  page += "\n## Examples\n";
  for (const SpecExample& example : spec.examples) {
    page += fmt::format("\n### {}\n\n```task\n{}```\n", example.name, example.text);
  }
}

}  // namespace

std::string ToMarkdown(const Spec& spec) {
  std::string page = fmt::format("# How to write a task{}\n\n{}",
                                 spec.robot ? " for " + spec.robot->name : "", kIntroduction);
  if (spec.robot) {
    AddRobot(spec, page);
  } else {
    AddWithoutRobot(page);
  }
  AddWords(spec, page);
  for (const char* section : kSections) AddSection(section, SectionOf(spec.manual, section), page);
  AddRandom(spec, page);
  page += "\n## Libraries\n";
  for (const SpecLibrary& library : spec.libraries)
    page += fmt::format("\n### import \"{}\"\n\n{}\n", library.name, library.doc);
  page += fmt::format("\n## Grammar\n\n{}\n```ebnf\n{}```\n", kGrammarWords, ToEbnf(spec.grammar));
  AddExamples(spec, page);
  return page;
}

}  // namespace compiler
