#include "tests/compiler/random/random_task_writer.h"

namespace compiler {

void TaskWriter::DeclareInsteadOfSensor(const std::string& type_name) {
  const std::string name = NewName("s");
  const Type type = TypeOf(type_name);
  Line(fmt::format("memory {}: {} = {} per run", name, type_name, ConstantOf(type, {})));
  readable_.push_back({name, type, {}});
}

void TaskWriter::WriteStartBlock(uint32_t statements, int depth) {
  ++indent_;
  const size_t outside = readable_.size();
  for (uint32_t i = 0; i < statements; ++i) WriteStartStatement(depth);
  readable_.resize(outside);
  --indent_;
}

void TaskWriter::WriteStartStatement(int depth) {
  switch (random_.Below(depth > 0 ? 6 : 4)) {
    case 0:
      return WriteLet();
    case 4:
      Line(fmt::format("if {} {{", Condition()));
      WriteStartBlock(1 + random_.Below(2), depth - 1);
      return Line("}");
    case 5:
      Line(fmt::format("for {} in 0..1 {{", NewName("i")));
      WriteStartBlock(1 + random_.Below(2), depth - 1);
      return Line("}");
    default:
      return WriteStartAssignment();
  }
}

void TaskWriter::WriteStartAssignment() {
  struct StartTarget {
    const char* name;
    Unit unit;
  };
  const Unit speed{.meter = 1, .second = -1};
  const Unit turn{.second = -1, .radian = 1};
  const StartTarget target = random_.OneOf(
      {StartTarget{"joint.angle", {.radian = 1}}, StartTarget{"joint.angle[3..7]", {.radian = 1}},
       StartTarget{"joint.velocity[legs]", turn}, StartTarget{"base.position", {.meter = 1}},
       StartTarget{"base.position.z", {.meter = 1}}, StartTarget{"base.yaw", {.radian = 1}},
       StartTarget{"base.velocity.xy", speed}, StartTarget{"base.angular_velocity", turn}});
  std::string value = expressions_.OfType(ScalarType(Scalar::kReal), target.unit);
  const std::string other = expressions_.OfType(ScalarType(Scalar::kReal), target.unit);
  if (random_.OneIn(2)) value = fmt::format("uniform({0}, {0} + abs({1}))", value, other);
  if (random_.OneIn(4)) value = fmt::format("normal({}, abs({}))", value, other);
  if (random_.OneIn(4)) value = fmt::format("choose({0}, {1}, {0})", value, other);
  Line(fmt::format("{} {} {}", target.name, random_.OneOf({"=", "+=", "-="}), value));
}

}  // namespace compiler
