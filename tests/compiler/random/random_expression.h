// Random expressions of a wanted type and unit.
#pragma once

#include <string>
#include <vector>

#include "compiler/check/checked_task.h"
#include "tests/compiler/random/random_numbers.h"

namespace compiler {

// What an expression may read.
struct Readable {
  std::string name;
  Type type;
  Unit unit;
};

// A type with a unit, as a declaration writes it: "vec3 [m/s]".
std::string TypeText(const Type& type, const Unit& unit);
// " m/s" or " / s", to stand behind a number; "" for a plain one.
std::string UnitOfLiteral(const Unit& unit);

class RandomExpressions {
 public:
  // `readable` may change between two expressions. There must be a bool, an int and a plain real
  // among it: constants alone may not be divided by, or have no finite value.
  RandomExpressions(RandomNumbers& random, const std::vector<Readable>& readable);

  std::string OfType(const Type& type, const Unit& unit) { return Make(type, unit, kDepth).text; }
  // A type that OfType can make something of.
  Type RandomType();
  Unit RandomUnit();

 private:
  static constexpr int kDepth = 4;
  struct Text {
    std::string text;
    bool is_constant = false;  // made of literals only
  };

  Text Make(const Type& type, const Unit& unit, int depth);
  Text MakeBool(int depth);
  Text MakeInt(int depth);
  Text MakeReal(const Unit& unit, int depth);
  Text MakeRealOfReals(const Unit& unit, int depth);
  Text MakeReduction(const Unit& unit, int depth);
  Text MakeRow(const Type& type, const Unit& unit, int depth);
  Text MakeMatrix(const Type& type, const Unit& unit, int depth);
  Text Literal(Scalar scalar, const Unit& unit);
  // Not a constant.
  std::string Variable(const Type& type, const Unit& unit, int depth);
  std::string VariableReal(const Unit& unit, int depth);
  // A name of this type and unit, or else an element of one; empty where there is none.
  std::string Read(const Type& type, const Unit& unit);
  std::string ElementOf(const Readable& whole);
  Type RandomRow(Scalar scalar);
  bool IsRowType(const Type& type) const;

  RandomNumbers& random_;
  const std::vector<Readable>& readable_;
};

}  // namespace compiler
