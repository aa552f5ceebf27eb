// Writes one random task, declaration by declaration and statement by statement.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/type.h"
#include "compiler/check/unit.h"
#include "compiler/syntax/words.h"
#include "tests/compiler/random/random_expression.h"
#include "tests/compiler/random/random_numbers.h"

namespace compiler {

class TaskWriter {
 public:
  explicit TaskWriter(uint32_t seed) : random_(seed), expressions_(random_, readable_, callable_) {}

  std::string Write();
  std::string WriteStart();

 private:
  void Line(const std::string& line) { text_ += std::string(indent_ * 2, ' ') + line + "\n"; }
  bool IsStep() const { return event_ >= EventKind::kStartOfTimeStep; }
  std::string NewName(std::string_view kind) { return fmt::format("{}{}", kind, ++names_); }

  static constexpr const char* kTypes[] = {
      "bool",    "int",     "real",    "vec2",     "vec3",    "vec4",    "mat3",     "quat",
      "bool[2]", "bool[3]", "bool[5]", "bool[40]", "int[2]",  "int[3]",  "int[5]",   "int[40]",
      "real[2]", "real[3]", "real[5]", "real[40]", "vec2[3]", "vec3[2]", "vec3[18]", "quat[3]"};

  // A task for a robot has no sensors of its own.
  void DeclareInsteadOfSensor(const std::string& type_name);

  // One of each type in plain numbers, so that everything can be made; then some with units.
  void DeclareSensors();
  void DeclareSensor(const std::string& type_name, const Unit& unit);

  // What a robot has for each link, joint and site, and sets of these.
  void ReadRobot();

  // Sets and numbers for loops, and consts with a shape.
  void DeclareConsts();
  void DeclareConst(const Type& type, const Unit& unit);
  static Type TypeOf(const std::string& name);
  void DeclareParams();
  std::string ConstantOf(const Type& type, const Unit& unit);
  void DeclareMemory();
  std::string InitialValue(const Type& type, const Unit& unit);

  // Of files in tests/compiler/check/tables. Expressions call them through a function, which with
  // constant arguments is no constant, and so may be divided by.
  void DeclareTables();
  void AddTable(const std::string& type_name, const std::string& file, const Unit& argument,
                const Unit& unit);

  // Of the type of a memory, so that it can be chosen from that.
  void DeclareGoal();

  // Their names, which may be read before the phases are written.
  void NamePhases();
  void DeclarePotentials();

  // A function reads nothing but its arguments and consts; it may call those before it.
  void DeclareFunction();

  // Of numbers of any unit, to be applied to rows as well.
  void DeclareOpenFunction();
  Unit UnitFor(const Type& type);
  void DeclareMetrics();

  // Of any type; functions of the past among them.
  void DeclareObservations();
  void WritePhase(const std::string& name);
  void WriteStartBlock(uint32_t statements, int depth);
  void WriteStartStatement(int depth);
  void WriteStartAssignment();
  void WriteEvent(std::string_view name, EventKind event);
  void WriteTopBlock(const std::string& head, EventKind event);
  void WriteBlock(uint32_t statements, int depth);
  void WriteStatement(int depth);
  std::string Condition() { return expressions_.OfType(ScalarType(Scalar::kBool), {}); }

  void WriteLet();

  // What a declared value was, or how it changes.
  void WritePast();

  // What a table says for a sensor or a constant: directly, and a step ago.
  void WriteTable();
  void WriteAssignment();

  // Some neighboring elements: to a scalar, or to as many elements.
  void WriteElementAssignment();
  void WriteLog();

  // The loop's variable is a constant. What is computed with it is not: it has a sensor in it.
  void WriteFor(int depth);
  void WriteReward();
  void WriteEnd();
  void WriteIf(int depth);

  RandomNumbers random_;
  std::vector<Readable> readable_;
  std::vector<Callable> callable_;
  const std::vector<Callable> no_callable_{};
  std::vector<Readable> consts_;
  std::vector<Readable> params_;
  std::vector<Readable> memory_;
  std::vector<Readable> goals_;
  std::vector<Readable> tables_;  // with the units of their arguments
  std::vector<std::string> phases_;
  RandomExpressions expressions_;
  std::string text_;
  size_t past_ = 0;  // as many of `readable_` are declared
  size_t indent_ = 0;
  int names_ = 0;
  EventKind event_{};
  bool is_in_phase_ = false;
};

}  // namespace compiler
