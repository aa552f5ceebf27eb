#include "compiler/emit/cpp_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "compiler/emit/cpp_literal.h"

namespace compiler {
namespace {

struct Operator {
  std::string_view symbol;
  Precedence precedence;
};

Operator Describe(BinaryOperator op) {
  switch (op) {
    case BinaryOperator::kAdd:
      return {"+", Precedence::kSum};
    case BinaryOperator::kSubtract:
      return {"-", Precedence::kSum};
    case BinaryOperator::kMultiply:
      return {"*", Precedence::kProduct};
    case BinaryOperator::kDivide:
      return {"/", Precedence::kProduct};
    case BinaryOperator::kLess:
      return {"<", Precedence::kRelation};
    case BinaryOperator::kLessEqual:
      return {"<=", Precedence::kRelation};
    case BinaryOperator::kGreater:
      return {">", Precedence::kRelation};
    case BinaryOperator::kGreaterEqual:
      return {">=", Precedence::kRelation};
    case BinaryOperator::kEqual:
      return {"==", Precedence::kEquality};
    case BinaryOperator::kNotEqual:
      return {"!=", Precedence::kEquality};
    case BinaryOperator::kAnd:
      return {"&&", Precedence::kAnd};
    case BinaryOperator::kOr:
      break;
  }
  return {"||", Precedence::kOr};
}

Precedence Tighter(Precedence precedence) {
  return static_cast<Precedence>(static_cast<int>(precedence) + 1);
}

// How tightly an operand must bind to stand without parentheses. Only chains of one operator, and
// the usual mixture of sums and products, go without.
Precedence Required(Precedence op, Precedence operand, bool is_left) {
  switch (op) {
    case Precedence::kOr:
    case Precedence::kAnd:
      return is_left && operand == op ? op : Precedence::kEquality;
    case Precedence::kEquality:
    case Precedence::kRelation:
      return Precedence::kSum;
    default:
      return is_left ? op : Tighter(op);
  }
}

}  // namespace

std::string AtLeast(Precedence precedence, const CppText& text) {
  return text.precedence >= precedence ? text.text : fmt::format("({})", text.text);
}

CppText BinaryText(BinaryOperator op, const CppText& left, const CppText& right) {
  auto [symbol, precedence] = Describe(op);
  return {fmt::format("{} {} {}", AtLeast(Required(precedence, left.precedence, true), left),
                      symbol, AtLeast(Required(precedence, right.precedence, false), right)),
          precedence};
}

CppText CallText(std::string_view function, const std::vector<CppText>& arguments) {
  std::vector<std::string_view> texts;
  for (const CppText& argument : arguments) texts.push_back(argument.text);
  return {fmt::format("{}({})", function, fmt::join(texts, ", "))};
}

std::string_view CppType(Scalar scalar) {
  switch (scalar) {
    case Scalar::kBool:
      return "bool";
    case Scalar::kInt:
      return "long long";
    case Scalar::kReal:
      break;
  }
  return "double";
}

std::string NumberLiteralText(double value, Scalar scalar) {
  switch (scalar) {
    case Scalar::kBool:
      return value != 0 ? "true" : "false";
    case Scalar::kInt:
      return IntLiteral(value);
    case Scalar::kReal:
      break;
  }
  return RealLiteral(value);
}

std::string MaybeUnused(bool is_read) { return is_read ? "" : "[[maybe_unused]] "; }

std::string Declarator(const std::string& name, const Type& type) {
  std::string_view element = CppType(type.scalar);
  if (type.shape == Shape::kScalar) return fmt::format("{} {}", element, name);
  return fmt::format("{} {}[{}]", element, name, type.size());
}

std::vector<std::string> ArrayDefinition(const std::string& name, const Type& type,
                                         const std::vector<CppText>& elements) {
  std::string declarator = Declarator(name, type);
  if (elements.size() < type.size()) {
    return {declarator + ";", fmt::format("for (int i = 0; i < {}; ++i) {}[i] = {};", type.size(),
                                          name, elements.front().text)};
  }
  std::vector<std::string_view> texts;
  for (const CppText& element : elements) texts.push_back(element.text);
  return {fmt::format("const {} = {{{}}};", declarator, fmt::join(texts, ", "))};
}

std::vector<uint32_t> AllIndices(uint32_t count) {
  std::vector<uint32_t> indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

bool IsContiguous(const std::vector<uint32_t>& indices) {
  return std::ranges::adjacent_find(indices, [](uint32_t a, uint32_t b) { return b != a + 1; }) ==
         indices.end();
}

std::string IndexTable(const std::string& name, const std::vector<uint32_t>& indices) {
  return fmt::format("static constexpr short {}[] = {{{}}};", name, fmt::join(indices, ", "));
}

std::vector<std::string> ArrayAssignment(const std::string& array, std::string_view op,
                                         const std::vector<CppText>& values,
                                         const std::vector<uint32_t>& indices, UniqueNames& names) {
  if (values.size() == indices.size()) {
    std::vector<std::string> stores;
    for (size_t i = 0; i < indices.size(); ++i) {
      stores.push_back(fmt::format("{}[{}] {} {};", array, indices[i], op, values[i].text));
    }
    return {fmt::format("{}", fmt::join(stores, " "))};
  }
  std::vector<std::string> lines;
  std::string index = indices.front() == 0 ? "i" : fmt::format("i + {}", indices.front());
  if (!IsContiguous(indices)) {
    std::string table = names.Add("indices");
    lines.push_back(IndexTable(table, indices));
    index = table + "[i]";
  }
  lines.push_back(fmt::format("for (int i = 0; i < {}; ++i) {}[{}] {} {};", indices.size(), array,
                              index, op, values.front().text));
  return lines;
}

}  // namespace compiler
