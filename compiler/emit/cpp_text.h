// Pieces of C++ text, and how they join.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/check/checked_task.h"
#include "compiler/emit/unique_names.h"

namespace compiler {

// From loosest to tightest, as C++ binds.
enum class Precedence { kOr, kAnd, kEquality, kRelation, kSum, kProduct, kPrefix, kPrimary };

// An expression and how tightly its outermost operator binds.
struct CppText {
  std::string text;
  Precedence precedence = Precedence::kPrimary;
};

// In parentheses, unless it binds at least as tightly as asked.
std::string AtLeast(Precedence precedence, const CppText& text);

// Two operands with the operator between them, in as many parentheses as a reader needs.
CppText BinaryText(BinaryOperator op, const CppText& left, const CppText& right);

// "function(a, b)"
CppText CallText(std::string_view function, const std::vector<CppText>& arguments);

// The type that holds one element: "bool", "long long", "double".
std::string_view CppType(Scalar scalar);

// One element of a constant: "true", "2LL", "0.5".
std::string NumberLiteralText(double value, Scalar scalar);

// What stands before a declaration of what nothing may read: "[[maybe_unused]] ", else nothing.
std::string MaybeUnused(bool is_read);

// "double name" or "bool name[18]".
std::string Declarator(const std::string& name, const Type& type);

// The lines that define an array from its elements: one text for each, or one text in which `i` is
// the index.
std::vector<std::string> ArrayDefinition(const std::string& name, const Type& type,
                                         const std::vector<CppText>& elements);

// 0 .. count - 1
std::vector<uint32_t> AllIndices(uint32_t count);

// Each one more than the one before.
bool IsContiguous(const std::vector<uint32_t>& indices);

// "static constexpr short name[] = {2, 5};"
std::string IndexTable(const std::string& name, const std::vector<uint32_t>& indices);

// The lines that change these elements of an array by the operator `op`: one value for each, or one
// text in which `i` counts them. `names` gains the name of a table of indices where one is needed.
std::vector<std::string> ArrayAssignment(const std::string& array, std::string_view op,
                                         const std::vector<CppText>& values,
                                         const std::vector<uint32_t>& indices, UniqueNames& names);

}  // namespace compiler
