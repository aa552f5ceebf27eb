#include "tests/compiler/random/random_task.h"

#include "tests/compiler/random/random_task_writer.h"

namespace compiler {

std::string TaskWriter::Write() {
  const bool has_robot = random_.OneIn(2);
  text_ = has_robot ? "task random for humanoid\n" : "task random\n";
  // Else an early end would leave little to compare.
  if (!random_.OneIn(3)) Line("after_end continue");
  DeclareSensors();
  if (has_robot) ReadRobot();
  DeclareConsts();
  DeclareParams();
  DeclareMemory();
  for (int i = 0; i < 4; ++i) DeclareGoal();
  if (random_.OneIn(2)) NamePhases();
  past_ = readable_.size();
  DeclareTables();
  DeclarePotentials();
  for (int i = 0; i < 4; ++i) DeclareFunction();
  for (int i = 0; i < 2; ++i) DeclareOpenFunction();
  DeclareMetrics();
  DeclareObservations();
  for (const auto& event : kEventNames) {
    if (random_.OneIn(2)) WriteEvent(event.text, event.meaning);
  }
  for (const std::string& phase : phases_) WritePhase(phase);
  return text_;
}

std::string TaskWriter::WriteStart() {
  text_ = "task random for humanoid\n";
  for (const char* type : kTypes) DeclareInsteadOfSensor(type);
  DeclareConsts();
  DeclareParams();
  DeclareMemory();
  for (int i = 0; i < 2; ++i) DeclareGoal();
  for (int i = 0; i < 2; ++i) DeclareFunction();
  Line(fmt::format("start {} {{", random_.OneOf({"standing", "standing or lying",
                                                 "lying or sitting or standing"})));
  WriteStartBlock(4 + random_.Below(6), 2);
  Line("}");
  return text_;
}

std::string RandomTask(uint32_t seed) { return TaskWriter(seed).Write(); }
std::string RandomStart(uint32_t seed) { return TaskWriter(seed).WriteStart(); }

}  // namespace compiler
