#include "compiler/language_server/known_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/check/unit.h"
#include "plugins/robot/sensors.h"
#include "plugins/world/thing_sensors.h"

namespace compiler {
namespace {

// The numbers in Sources::files() of those that are no tasks.
std::set<size_t> NoTaskFiles(const Analysis& analysis) {
  std::set<size_t> files;
  for (const Declaration& declaration : analysis.tree->declarations) {
    const auto* table = std::get_if<TableDeclaration>(&declaration.node);
    if (table != nullptr && table->source.file)
      files.insert(analysis.sources.IndexOf(table->source.file->columns.front().span));
  }
  if (const auto& world = analysis.tree->world) {
    for (const std::optional<size_t>& file : {world->file, world->map_file})
      if (file) files.insert(*file);
  }
  return files;
}

}  // namespace

KnownValues::KnownValues(const Document& document, Workspace& workspace)
    : document_(document), good_(workspace.LastGood(document)) {
  if (const robot::RobotDescription* robot = workspace.RobotOf(document)) {
    enumerations_ = EnumerationsOf(robot);
    const auto add = [this](const auto& sensor, bool is_constant) {
      const std::string unit = sensor.unit.empty() ? "" : fmt::format(" [{}]", sensor.unit);
      robot_sensors_.push_back({std::string(sensor.name), NameKind::kSensor,
                                std::string(sensor.type) + unit, std::string(sensor.doc),
                                is_constant});
    };
    for (const robot::SensorDescription& sensor : robot::SensorsOf(*robot)) add(sensor, false);
    for (const robot::ConstantDescription& constant : robot::Constants()) add(constant, true);
  }
  if (good_ == nullptr) return;
  if (good_->analysis.world) AddThings(*good_->analysis.world);
  AddInherited(*good_);
}

void KnownValues::AddThings(const world::WorldDescription& world) {
  for (const world::ThingSensor& sensor : world::SensorsOf(world)) {
    const std::string unit = sensor.unit.empty() ? "" : fmt::format(" [{}]", sensor.unit);
    robot_sensors_.push_back({sensor.name, NameKind::kSensor, std::string(sensor.type) + unit,
                              std::string(sensor.doc), false});
  }
}

void KnownValues::AddInherited(const Findings& findings) {
  const auto& files = findings.analysis.sources.files();
  const std::set<size_t> tables = NoTaskFiles(findings.analysis);
  for (size_t i = 1; i < files.size(); ++i) {
    if (tables.contains(i)) continue;
    const TextTokens tokens(files[i].text());
    for (const DeclaredName& name : FindDeclaredNames(tokens)) {
      const bool is_local = name.kind == NameKind::kArgument || name.kind == NameKind::kLet ||
                            name.kind == NameKind::kLoop || name.kind == NameKind::kTask;
      if (is_local) continue;
      inherited_.push_back(
          {name.name, name.kind, name.type, DocAbove(files[i].text(), name.span.begin)});
    }
  }
}

std::string KnownValues::TypeOf(const DeclaredName& name) const {
  if (!name.type.empty() || good_ == nullptr) return name.type;
  // A `let` has the type that the compiler last found for one of this name.
  for (const auto& [place, reference] : good_->references.by_place()) {
    const bool is_local =
        reference.kind == ReferenceKind::kLocal || reference.kind == ReferenceKind::kLoop;
    if (is_local && reference.name == name.name) return TypeText(reference.type, reference.unit);
  }
  return "";
}

std::vector<KnownValue> KnownValues::VisibleAt(uint32_t offset) const {
  std::vector<KnownValue> values;
  for (const DeclaredName& name : document_.names()) {
    if (name.visible.begin > offset || offset > name.visible.end) continue;
    values.push_back(
        {name.name, name.kind, TypeOf(name), DocAbove(document_.text(), name.span.begin)});
  }
  values.insert(values.end(), inherited_.begin(), inherited_.end());
  values.insert(values.end(), robot_sensors_.begin(), robot_sensors_.end());
  return values;
}

std::optional<KnownValue> KnownValues::Find(std::string_view name, uint32_t offset) const {
  const auto can_be_read = [](NameKind kind) {
    return kind != NameKind::kTerm && kind != NameKind::kMetric && kind != NameKind::kLog &&
           kind != NameKind::kObservation && kind != NameKind::kSet && kind != NameKind::kEvent &&
           kind != NameKind::kTest && kind != NameKind::kTask;
  };
  for (KnownValue& value : VisibleAt(offset)) {
    if (value.name == name && can_be_read(value.kind)) return std::move(value);
  }
  return std::nullopt;
}

std::vector<KnownValue> KnownValues::Sensors() const {
  std::vector<KnownValue> sensors = robot_sensors_;
  for (const KnownValue& value : VisibleAt(0)) {
    const bool is_new = std::ranges::find(sensors, value.name, &KnownValue::name) == sensors.end();
    if (value.kind == NameKind::kSensor && is_new) sensors.push_back(value);
  }
  return sensors;
}

const Enumeration* KnownValues::IndexOf(std::string_view name, uint32_t offset) const {
  const auto value = Find(name, offset);
  if (!value) return nullptr;
  const size_t open = value->type.find('[');
  if (open == std::string::npos) return nullptr;
  const size_t close = value->type.find(']', open);
  return FindEnumeration(enumerations_, value->type.substr(open + 1, close - open - 1));
}

}  // namespace compiler
