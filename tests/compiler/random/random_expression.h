// Random expressions of a wanted type and unit.
#pragma once

#include <optional>
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
  bool is_constant = false;  // only read as a whole: what its elements give might not be finite
};

// What an expression may call.
struct Callable {
  std::string name;
  Type type;  // of the result
  Unit unit;
  std::vector<Readable> arguments;
  // Takes any unit, and each element of rows: its arguments are reals of one unit, a plain one and
  // a bool.
  bool is_open = false;
};

class RandomExpressions {
 public:
  // Both lists may change between two expressions. Readable must be a bool, an int and a plain real
  // (constants alone may not be divided by, or have no finite value), and something plain of each
  // type that is asked for.
  RandomExpressions(RandomNumbers& random, const std::vector<Readable>& readable,
                    const std::vector<Callable>& callable);

  std::string OfType(const Type& type, const Unit& unit) { return Make(type, unit, kDepth).text; }
  // The type of something readable.
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
  // A function of single numbers, of rows; empty where what it needs is not there.
  std::string OfEachElement(const Type& type, const Unit& unit, int depth);
  Text MakeConditions(const Type& type, int depth);
  std::string SomeConditions(int depth);
  std::string Comparison(const Type& left, const Type& right, const Unit& unit, int depth);
  Text MakeVec3(const Unit& unit, int depth);
  Text MakeVectors(const Type& array, const Unit& unit, int depth);
  // What a function makes of an array of vectors, an array of numbers or a vector; empty where
  // there is no array for that.
  std::string OfEachVector(const Type& type, const Unit& unit, int depth);
  // A vector or quaternion out of its elements.
  std::string Constructed(const std::string& type, uint32_t size, const Unit& unit, int depth);
  Text MakeMatrix(const Type& type, const Unit& unit, int depth);
  Text Literal(Scalar scalar, const Unit& unit);
  // Not a constant.
  std::string Variable(const Type& type, const Unit& unit, int depth);
  std::string VariableReal(const Unit& unit, int depth);
  // A name of this type and unit, or else an element of one; empty where there is none.
  std::string Read(const Type& type, const Unit& unit);
  std::string ElementOf(const Readable& whole);
  // Neighboring elements; of an array of vectors also one of them, or an element of each. Empty
  // where none are of this type.
  std::string PartOf(const Readable& whole, const Type& type);
  // Of something readable and plain, if there is a row of such scalars.
  std::optional<Type> RandomRow(Scalar scalar);
  bool CanMakeArguments(const Callable& function);
  // Empty where no function gives this.
  std::string Call(const Type& type, const Unit& unit, int depth);
  std::string CallOfElements(const Callable& function, const Type& type, const Unit& unit,
                             int depth);

  RandomNumbers& random_;
  const std::vector<Readable>& readable_;
  const std::vector<Callable>& callable_;
};

}  // namespace compiler
