// The values that a document can read, with their types: those it declares, its robot's sensors,
// and those of the files that it is made of.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/enumeration.h"
#include "compiler/check/sensor_catalog.h"
#include "compiler/language_server/workspace.h"

namespace compiler {

struct KnownValue {
  std::string name;  // a sensor's with its dots
  NameKind kind = NameKind::kSensor;
  std::string type;  // "vec3 [m/s]"; empty where it is not known
  std::string doc;
  bool is_constant = false;  // of the robot, in the place of a sensor
};

class KnownValues {
 public:
  KnownValues(const Document& document, Workspace& workspace);

  // What can be used at `offset`.
  std::vector<KnownValue> VisibleAt(uint32_t offset) const;
  std::optional<KnownValue> Find(std::string_view name, uint32_t offset) const;

  std::vector<KnownValue> Sensors() const;
  // What the files declare from which this one takes over everything or some functions.
  const std::vector<KnownValue>& inherited() const { return inherited_; }

  // Links, joints and sites; none without a robot.
  const std::vector<Enumeration>& enumerations() const { return enumerations_; }
  // The one that indexes the value of this name, or null.
  const Enumeration* IndexOf(std::string_view name, uint32_t offset) const;

 private:
  void AddThings(const world::WorldDescription& world);
  void AddInherited(const Findings& findings);
  std::string TypeOf(const DeclaredName& name) const;

  const Document& document_;
  const Findings* good_;
  std::vector<Enumeration> enumerations_;
  std::vector<KnownValue> robot_sensors_;
  std::vector<KnownValue> inherited_;
};

}  // namespace compiler
