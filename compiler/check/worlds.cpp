#include "compiler/check/worlds.h"

#include <fmt/format.h>

#include "compiler/check/report.h"
#include "compiler/check/symbol_table.h"
#include "plugins/world/thing_sensors.h"

namespace compiler {

void CheckWorld(const SyntaxTree& tree, const world::WorldDescription* world, TaskScope& scope) {
  if (!tree.world) return;
  const Span span = tree.world->path_span;
  if (!tree.robot && !tree.lost.has_header && !tree.lost.has_anything) {
    Report(scope.diagnostics, code::kWorldWithoutRobot, span,
           "only a robot can be in a world, and the task names none",
           {.help = "name it: `for ROBOT in \"FILE.toml\"`"});
    return;
  }
  if (world == nullptr || !scope.knows_robot) return;
  for (const world::Thing& thing : world->things)
    if (IsLanguageName({thing.name, span}, scope.diagnostics)) return;
  scope.sensors.AddThings(*world, scope.enumerations);
}

bool IsOfWorld(const SensorDeclaration& sensor, const SyntaxTree& tree,
               const world::WorldDescription& world, TaskScope& scope) {
  const std::string& name = sensor.name.text;
  for (const world::ThingSensor& known : world::SensorsOf(world)) {
    const bool is_same = known.name == name;
    if (!is_same && !known.name.starts_with(name + '.') && !name.starts_with(known.name + '.'))
      continue;
    Report(scope.diagnostics, code::kSensorOfRobot, sensor.name.span,
           is_same ? fmt::format("the world has a sensor `{}`", known.name)
                   : fmt::format("this could be mistaken for the world's sensor `{}`", known.name),
           {.help =
                is_same ? "leave out the declaration, and read the world's" : "choose another name",
            .labels = {{tree.world->path_span, "the world"}}});
    return true;
  }
  return false;
}

}  // namespace compiler
