#include "compiler/check/unknown_names.h"

#include <algorithm>
#include <utility>

#include "compiler/check/builtins.h"
#include "compiler/check/names.h"
#include "compiler/check/phase_names.h"
#include "compiler/check/report.h"
#include "compiler/check/type.h"
#include "compiler/syntax/foreign_words.h"
#include "compiler/syntax/power_help.h"

namespace compiler {
namespace {

std::vector<std::string> ReadableNames(const TaskScope& scope) {
  std::vector<std::string> names = scope.symbols.Names();
  for (std::string& sensor : scope.sensors.Names()) names.push_back(std::move(sensor));
  for (const std::string_view built_in : {kReward, kTimeStep, kPi}) names.emplace_back(built_in);
  return names;
}

// A sensor of several names that `path` begins with, were it not for a few wrong letters. False:
// there is none.
bool ReportMisspelledSensor(const std::vector<Identifier>& path, const TaskScope& scope) {
  std::string nearest;
  size_t length = 0;
  size_t smallest = std::string::npos;
  for (const std::string& name : scope.sensors.Names()) {
    const auto parts = static_cast<size_t>(1 + std::ranges::count(name, '.'));
    if (parts < 2 || parts > path.size()) continue;
    const auto distance = text::DottedDistance(PathText(path, parts), name);
    if (!distance || *distance >= smallest) continue;
    nearest = name;
    length = parts;
    smallest = *distance;
  }
  if (nearest.empty()) return false;
  const Span span = SpanOfPath(path, length);
  Report(scope.diagnostics, code::kUnknownSensor, span,
         fmt::format("there is no sensor `{}`", PathText(path, length)),
         {.help = DidYouMean(span, nearest)});
  return true;
}

// `path` begins as sensors do.
void ReportUnknownSensor(const std::vector<Identifier>& path, const TaskScope& scope) {
  std::vector<std::string> siblings;
  for (std::string& name : scope.sensors.Names())
    if (name.starts_with(path[0].text + '.')) siblings.push_back(std::move(name));
  if (path.size() == 1) {
    Report(scope.diagnostics, code::kMisplacedName, path[0].span,
           fmt::format("`{}` alone is not a value", path[0].text),
           {.help = fmt::format("its sensors are {}", List(siblings))});
    return;
  }
  Report(scope.diagnostics, code::kUnknownSensor, SpanOfPath(path, 2),
         fmt::format("there is no sensor `{}`", PathText(path, 2)),
         {.help = fmt::format("the sensors of this kind are {}", List(siblings))});
}

// A sensor that robots have, in a task without a robot. False: it is no such sensor.
bool ReportSensorOfRobot(const std::vector<Identifier>& path, const TaskScope& scope) {
  for (size_t length = path.size(); length > 0 && !scope.has_robot; --length) {
    const std::string name = PathText(path, length);
    if (!IsSensorOfRobots(name)) continue;
    const std::string declaration = DeclarationOf(name);
    Report(scope.diagnostics, code::kUnknownSensor, SpanOfPath(path, length),
           fmt::format("`{}` is a sensor of robots, and this task names no robot", name),
           {.help = declaration.empty()
                        ? "write `for ROBOT` after the task's name"
                        : fmt::format("write `for ROBOT` after the task's name, or declare `{}`",
                                      declaration)});
    return true;
  }
  return false;
}

// A sensor of sites, of a robot without any. False: it is no such sensor.
bool ReportSensorOfSites(const std::vector<Identifier>& path, const TaskScope& scope) {
  const bool is_sensor = path.size() > 1 && IsSensorOfRobots(PathText(path, 2));
  if (!is_sensor || scope.sensors.IsRoot(path[0].text)) return false;  // others all robots have
  Report(scope.diagnostics, code::kUnknownSensor, SpanOfPath(path, 2),
         fmt::format("`{}` is a sensor of sites, and the robot has none", PathText(path, 2)),
         {.help = "name places on its links in the robot's file, as `sites`; or read what links "
                  "have, such as `link.position`"});
  return true;
}

// A name that means something, but not as a value. False: it means nothing at all.
bool ReportMisplacedName(const Identifier& name, const TaskScope& scope) {
  if (const Enumeration* parts = FindEnumerationOf(scope.enumerations, name.text)) {
    ReportPartAsValue(name, parts->name, scope);
    return true;
  }
  if (const BuiltinDescription* builtin = FindBuiltin(name.text)) {
    Report(scope.diagnostics, code::kMisplacedName, name.span,
           fmt::format("`{}` is a function", name.text),
           {.help = fmt::format("write `{}`", builtin->usage)});
    return true;
  }
  return false;
}

// A local value of the event that is not visible here. False: there is none of this name.
bool ReportInvisibleLocal(const Identifier& name, const TaskScope& scope) {
  const auto found = scope.locals.find(name.text);
  if (found == scope.locals.end()) return false;
  const Span defined = found->second.span;
  if (found->second.is_loop) {
    Report(scope.diagnostics, code::kOutOfScope, name.span,
           fmt::format("`{}` is known only inside its loop", name.text),
           {.labels = {{defined, "defined here"}}});
    return true;
  }
  const bool is_later = defined.begin > name.span.begin;
  Report(scope.diagnostics, code::kOutOfScope, name.span,
         is_later ? fmt::format("`{}` is used before its `let`", name.text)
                  : fmt::format("`{}` is known only inside the block of its `let`", name.text),
         {.help = is_later ? "move the `let` up" : "move the `let` out of the block",
          .labels = {{defined, "defined here"}}});
  return true;
}

// `True`, `dt`; `sec` and `s2` behind a unit and `/`.
Help HelpForForeignName(const Identifier& name) {
  Help help = HelpForForeign(ForeignPlace::kOperand, name.text, name.span);
  if (help.empty()) help = HelpForPowerInName(name.text, name.span);
  if (help.empty()) help = HelpForForeign(ForeignPlace::kUnit, name.text, name.span);
  return help;
}

// `math.pi`, `self.speed`: a path that begins with a word of other languages. False: it does not.
bool ReportForeignPath(const std::vector<Identifier>& path, const TaskScope& scope) {
  if (path.size() < 2) return false;
  const Identifier& root = path.front();
  const Span prefix{root.span.begin, path[1].span.begin};
  const bool is_module = FindForeign(ForeignPlace::kModule, root.text) != nullptr;
  const bool is_owner = root.text == "self" || root.text == "this";
  if (!is_module && !is_owner) return false;
  Help help = fmt::format("leave out `{}.`: a task has one namespace", root.text);
  help.fixes = {{prefix, ""}};
  Report(scope.diagnostics, code::kUnknownName, root.span,
         fmt::format("there is nothing called `{}`", root.text), {.help = std::move(help)});
  return true;
}

}  // namespace

std::string PathText(const std::vector<Identifier>& path, size_t length) {
  std::string text = path[0].text;
  for (size_t i = 1; i < length; ++i) text += '.' + path[i].text;
  return text;
}

Span SpanOfPath(const std::vector<Identifier>& path, size_t length) {
  return Cover(path[0].span, path[length - 1].span);
}

std::string_view SensorOver(std::string_view enumeration) {
  if (enumeration == "link") return "contact";
  return enumeration == "joint" ? "joint.angle" : "site.position";
}

void ReportPartAsValue(const Identifier& name, std::string_view enumeration,
                       const TaskScope& scope) {
  const std::string element = fmt::format("{}[{}]", SensorOver(enumeration), name.text);
  Report(scope.diagnostics, code::kMisplacedName, name.span,
         fmt::format("`{}` is allowed only inside an index", name.text),
         {.help = {fmt::format("write it in the brackets of an array over {}s: `{}`", enumeration,
                               element),
                   {{name.span, element}}}});
}

std::nullopt_t NotConstant(std::string_view name, Span span, const Place& place,
                           const TaskScope& scope) {
  Report(scope.diagnostics, code::kNotConstant, span,
         fmt::format("`{}` is not known before the task runs", name),
         {.help = place.kind == Place::kGiven
                      ? "a test gives constants"
                      : "constants are allowed here; a memory may also start with the value of a "
                        "param"});
  return std::nullopt;
}

void ReportUnknownPath(const std::vector<Identifier>& path, const TaskScope& scope) {
  const Identifier& root = path[0];
  if (!scope.knows_names || scope.sensors.IsInvalidRoot(root.text)) return;
  if (ReportMissingPhases(root, scope) || ReportForeignPath(path, scope)) return;
  if (ReportSensorOfRobot(path, scope) || ReportSensorOfSites(path, scope)) return;
  if (ReportMisspelledSensor(path, scope)) return;
  if (scope.sensors.IsRoot(root.text)) {
    ReportUnknownSensor(path, scope);
  } else if (!ReportMisplacedName(root, scope)) {
    ReportUnknownName(root, scope);
  }
}

void ReportUnknownName(const Identifier& name, const TaskScope& scope) {
  if (!scope.knows_names || scope.refused.contains(name.text)) return;
  if (ReportInvisibleLocal(name, scope)) return;
  Help help = HelpForForeignName(name);
  if (help.empty()) help = Suggest(name.span, name.text, ReadableNames(scope), "known names");
  if (help.fixes.empty() && !scope.reported.insert(name.text).second) return;
  Report(scope.diagnostics, code::kUnknownName, name.span,
         fmt::format("there is nothing called `{}`", name.text), {.help = std::move(help)});
}

}  // namespace compiler
