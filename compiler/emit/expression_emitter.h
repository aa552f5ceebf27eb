// Expressions as C++.
//
// C++ without a library has no vectors, so vector operations are written out element by element.
// Where that would compute something more than once (a vector's elements in a norm, a factor of a
// whole vector), the value first gets a name: a local constant or array in the lines before the
// statement. All expressions are pure and total, so computing one early changes nothing.
#pragma once

#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/emit/builtin_emission.h"
#include "compiler/emit/cpp_text.h"
#include "compiler/emit/helper_functions.h"
#include "compiler/emit/unique_names.h"

namespace compiler {

// A table of the task.
struct LookupTable {
  std::string name;  // "table_gait"
  // The table in which its rows are searched for: the first one with the same arguments.
  std::string searched;
  // Of each element: whether a value between two rows can be rounded to beyond one of them.
  std::vector<bool> held;
};

// How C++ calls the values of a task inside one function, and the task's functions. Indexed like
// the lists of the task, of the event, and of the function.
struct ValueNames {
  std::vector<std::string> consts;
  std::vector<LookupTable> tables;
  std::vector<std::string> sensors;
  std::vector<std::string> params;
  std::vector<std::string> memory;  // with the struct: "memory.fallen"
  std::vector<std::string> locals;
  std::vector<std::string> arguments;
  std::vector<std::string> functions;
};

class ExpressionEmitter {
 public:
  // Places in tables that have been searched for: by their text, their names.
  using Places = std::map<std::string, std::string>;

  // Refers to its arguments, which must outlive it. `names` gains those of the parts it names.
  // Operations on up to `written_out` elements are written out, those on more become loops.
  ExpressionEmitter(const ValueNames& values, UniqueNames& names, HelperSet& helpers,
                    uint32_t written_out);

  // A scalar value. Read `TakeParts` before using the text.
  CppText EmitScalar(const CheckedExpression& expression);
  // Each element of a value; a scalar counts as one that has this element everywhere. More elements
  // than are written out give one text in which `i` is the index.
  std::vector<CppText> EmitElements(const CheckedExpression& expression, uint32_t count);
  // The same, but the elements are computed before any of them is used.
  std::vector<CppText> EmitElementsFirst(const CheckedExpression& expression, uint32_t count);

  // Up to so many elements are written out.
  uint32_t written_out() const { return written_out_; }

  // What is found in a block of C++ is known to the end of this block: whoever closes it sets back
  // what was known where it began.
  const Places& known_places() const { return known_places_; }
  void set_known_places(Places places) { known_places_ = std::move(places); }

  // The lines that have to stand before the texts emitted since the last call.
  std::vector<std::string> TakeParts();

 private:
  // Which element: a number, or a C++ variable.
  struct Index {
    uint32_t number = 0;
    std::string variable{};  // empty: `number` counts
  };
  static Index InRow(const Index& row, uint32_t columns, uint32_t column);
  enum class Use { kOnce, kRepeatedly };

  // Gives a name to what in `expression` needs one.
  void Prepare(const CheckedExpression& expression, Use use);
  void PrepareElementwise(const CheckedExpression& expression);
  void PrepareCall(const CheckedExpression& expression, const BuiltinCall& call);
  void PrepareCall(const CheckedExpression& expression, const FunctionCall& call);
  void PrepareDraw(const CheckedExpression& expression, const Draw& draw);
  void PrepareTable(const CheckedExpression& expression, const TableRead& read);
  const std::string& PlaceOf(const TableRead& read);
  void NameChoice(const CheckedExpression& expression, const Draw& draw);
  void NameValue(const CheckedExpression& expression);
  void NameResult(const CheckedExpression& expression, const FunctionCall& call);
  void NameLongChain(const CheckedExpression& expression, const BuiltinCall& call,
                     const Chain& chain);
  void NameLongList(const CheckedExpression& expression, const BuiltinCall& call);
  const std::string& TableOf(const std::vector<uint32_t>& indices);
  std::vector<CppText> AllElements(const CheckedExpression& expression, uint32_t count);

  // The text of one element, after Prepare.
  CppText Element(const CheckedExpression& expression, const Index& index);
  CppText ElementOf(const Elements& node, const CheckedExpression& expression, const Index& index);
  CppText ElementOf(const CheckedUnary& node, const Index& index);
  CppText ElementOf(const CheckedBinary& node, const Index& index);
  CppText ElementOf(const BuiltinCall& node, const CheckedExpression& expression,
                    const Index& index);
  CppText ElementOf(const TableRead& node, const CheckedExpression& expression, const Index& index);
  CppText ElementOf(const Draw& node, const CheckedExpression& expression, const Index& index);
  CppText Chosen(const Draw& node, const CheckedExpression& expression, const Index& index,
                 const std::string& element);
  CppText Call(const FunctionCall& call, const Index& index);
  std::vector<CppText> Arguments(const FunctionCall& call, const Index& index);
  // The C++ array that holds the whole value; empty where there is none.
  std::string ArrayOf(const CheckedExpression& expression) const;
  std::vector<CppText> ArgumentElements(const BuiltinCall& call, const Index& index);
  CppText AsReal(const CheckedExpression& expression, const Index& index);
  CppText Reduced(const BuiltinCall& call, const Chain& chain, Scalar scalar, const Index& index);
  CppText Joined(const BuiltinCall& call, Chain::Join join, Scalar scalar, const Index& index);
  CppText Written(WrittenOut form, const BuiltinCall& call, Scalar scalar, const Index& index);
  CppText Cross(const BuiltinCall& call, const Index& index);
  CppText Subscript(const std::string& name, const Type& type, const Index& index) const;

  const ValueNames& values_;
  UniqueNames& names_;
  HelperSet& helpers_;
  uint32_t written_out_;
  std::vector<std::string> parts_;
  std::unordered_map<const CheckedExpression*, std::string> named_;  // values that have a name
  std::map<std::vector<uint32_t>, std::string> tables_;  // of Elements::indices, among parts_
  // Where in its table a value is read: the name of a place.
  std::unordered_map<const CheckedExpression*, std::string> places_;
  Places known_places_;
  // Which value a draw has chosen: a number, or an array of them.
  struct Choice {
    std::string name;
    bool is_each = false;
  };
  std::unordered_map<const CheckedExpression*, Choice> choices_;
};

}  // namespace compiler
