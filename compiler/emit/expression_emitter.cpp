#include "compiler/emit/expression_emitter.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/variant/overloaded.h"
#include "compiler/check/type.h"
#include "compiler/emit/chain.h"
#include "compiler/emit/lookup_tables.h"

namespace compiler {
namespace {

CppText LiteralText(const Constant& constant, Scalar scalar) {
  std::string literal = NumberLiteralText(constant.value, scalar);
  return {literal, literal.starts_with('-') ? Precedence::kPrefix : Precedence::kPrimary};
}

}  // namespace

ExpressionEmitter::ExpressionEmitter(const ValueNames& values, UniqueNames& names,
                                     HelperSet& helpers, uint32_t written_out)
    : values_(values), names_(names), helpers_(helpers), written_out_(written_out) {}

CppText ExpressionEmitter::EmitScalar(const CheckedExpression& expression) {
  Prepare(expression, Use::kOnce);
  return Element(expression, {});
}

std::vector<CppText> ExpressionEmitter::EmitElements(const CheckedExpression& expression,
                                                     uint32_t count) {
  bool is_spread = IsScalar(expression.type) && count > 1;
  Prepare(expression, is_spread ? Use::kRepeatedly : Use::kOnce);
  return AllElements(expression, count);
}

std::vector<CppText> ExpressionEmitter::EmitElementsFirst(const CheckedExpression& expression,
                                                          uint32_t count) {
  Prepare(expression, Use::kOnce);
  if (!named_.contains(&expression)) NameValue(expression);
  return AllElements(expression, count);
}

std::vector<std::string> ExpressionEmitter::TakeParts() {
  tables_.clear();
  return std::exchange(parts_, {});
}

std::vector<CppText> ExpressionEmitter::AllElements(const CheckedExpression& expression,
                                                    uint32_t count) {
  if (count > written_out_) return {Element(expression, {.variable = "i"})};
  std::vector<CppText> elements;
  for (uint32_t i = 0; i < count; ++i) elements.push_back(Element(expression, {.number = i}));
  return elements;
}

CppText ExpressionEmitter::Element(const CheckedExpression& expression, const Index& index) {
  const Type& type = expression.type;
  if (auto named = named_.find(&expression); named != named_.end()) {
    return Subscript(named->second, type, index);
  }
  return std::visit(
      variant::Overloaded{
          [&](const Constant& node) { return LiteralText(node, type.scalar); },
          [&](const ConstRead& node) { return Subscript(values_.consts[node.index], type, index); },
          [&](const SensorRead& node) {
            return Subscript(values_.sensors[node.sensor], type, index);
          },
          [&](const ParamRead& node) { return Subscript(values_.params[node.param], type, index); },
          [&](const MemoryRead& node) {
            return Subscript(values_.memory[node.memory], type, index);
          },
          [&](const LocalRead& node) { return Subscript(values_.locals[node.local], type, index); },
          [&](const ArgumentRead& node) {
            return Subscript(values_.arguments[node.argument], type, index);
          },
          [](const RewardSoFar&) { return CppText{"reward"}; },
          [](const TimeStep&) { return CppText{"frame->time_step"}; },
          [&](const Elements& node) { return ElementOf(node, expression, index); },
          [&](const CheckedUnary& node) { return ElementOf(node, index); },
          [&](const CheckedBinary& node) { return ElementOf(node, index); },
          [&](const BuiltinCall& node) { return ElementOf(node, expression, index); },
          [&](const FunctionCall& node) { return Call(node, index); },
          [&](const Draw& node) { return ElementOf(node, expression, index); },
          [&](const TableRead& node) { return ElementOf(node, expression, index); },
          [&](const IntToReal& node) { return AsReal(*node.operand, index); },
          // Only in tests, which plugins do not hold.
          [](const TestRead&) { return CppText{}; },
          [](const CheckedWithin&) { return CppText{}; },
      },
      expression.node);
}

CppText ExpressionEmitter::ElementOf(const Elements& node, const CheckedExpression& expression,
                                     const Index& index) {
  if (IsScalar(expression.type)) {
    return Element(*node.operand, {.number = node.indices.front()});
  }
  if (index.variable.empty()) {
    return Element(*node.operand, {.number = node.indices[index.number]});
  }
  if (!IsContiguous(node.indices)) {
    return Element(*node.operand,
                   {.variable = fmt::format("{}[{}]", TableOf(node.indices), index.variable)});
  }
  uint32_t first = node.indices.front();
  return Element(
      *node.operand,
      {.variable = first == 0 ? index.variable : fmt::format("{} + {}", index.variable, first)});
}

CppText ExpressionEmitter::ElementOf(const CheckedUnary& node, const Index& index) {
  std::string operand = AtLeast(Precedence::kPrimary, Element(*node.operand, index));
  return {(node.op == UnaryOperator::kNot ? "!" : "-") + operand, Precedence::kPrefix};
}

CppText ExpressionEmitter::ElementOf(const CheckedBinary& node, const Index& index) {
  if (node.op == BinaryOperator::kDivide) {
    return BinaryText(node.op, AsReal(*node.left, index), AsReal(*node.right, index));
  }
  return BinaryText(node.op, Element(*node.left, index), Element(*node.right, index));
}

CppText ExpressionEmitter::ElementOf(const BuiltinCall& node, const CheckedExpression& expression,
                                     const Index& index) {
  const Scalar scalar = expression.type.scalar;
  const bool is_int = scalar == Scalar::kInt;
  if (const auto chain = ChainOf(node)) return Reduced(node, *chain, scalar, index);
  return std::visit(variant::Overloaded{
                        [&](const Chain& chain) { return Joined(node, chain.join, scalar, index); },
                        [&](const CompilerFunction& function) {
                          const bool is_other = is_int && function.integer;
                          return CallText(
                              is_other ? helpers_.Use(*function.integer) : function.real,
                              ArgumentElements(node, index));
                        },
                        [&](const HelperFunction& function) {
                          return CallText(helpers_.Use(is_int ? function.integer : function.real),
                                          ArgumentElements(node, index));
                        },
                        [&](WrittenOut form) { return Written(form, node, scalar, index); },
                    },
                    EmissionOf(node.function));
}

CppText ExpressionEmitter::Joined(const BuiltinCall& call, Chain::Join join, Scalar scalar,
                                  const Index& index) {
  const std::vector<CppText> arguments = ArgumentElements(call, index);
  CppText result = arguments.front();
  for (size_t i = 1; i < arguments.size(); ++i) {
    result = Combine(join, scalar, result, arguments[i], helpers_);
  }
  return result;
}

CppText ExpressionEmitter::Written(WrittenOut form, const BuiltinCall& call, Scalar scalar,
                                   const Index& index) {
  switch (form) {
    case WrittenOut::kClamp: {
      const std::vector<CppText> arguments = ArgumentElements(call, index);
      const CppText raised =
          Combine(Chain::Join::kMax, scalar, arguments[0], arguments[1], helpers_);
      return Combine(Chain::Join::kMin, scalar, raised, arguments[2], helpers_);
    }
    case WrittenOut::kCross:
      return Cross(call, index);
    case WrittenOut::kSelect: {
      const std::vector<CppText> arguments = ArgumentElements(call, index);
      return {
          fmt::format("({} ? {} : {})", arguments[0].text, arguments[1].text, arguments[2].text)};
    }
    case WrittenOut::kVector:
      return AsReal(*call.arguments[index.number], {});
  }
  std::abort();
}

CppText ExpressionEmitter::ElementOf(const Draw& node, const CheckedExpression& expression,
                                     const Index& index) {
  std::string element = index.variable.empty() ? std::to_string(index.number) : index.variable;
  if (node.distribution == Distribution::kChoice) return Chosen(node, expression, index, element);
  if (IsScalar(expression.type)) element = "0";
  const bool is_uniform = node.distribution == Distribution::kUniform;
  return CallText(helpers_.Use(is_uniform ? Helper::kUniform : Helper::kNormal),
                  {{"draw"},
                   {element},
                   {std::to_string(node.site)},
                   Element(*node.arguments[0], index),
                   Element(*node.arguments[1], index)});
}

CppText ExpressionEmitter::ElementOf(const TableRead& node, const CheckedExpression& expression,
                                     const Index& index) {
  const LookupTable& table = values_.tables[node.table];
  const bool is_known = index.variable.empty();
  const std::string element = is_known ? std::to_string(index.number) : index.variable;
  const bool is_held =
      is_known ? table.held[index.number] : std::ranges::find(table.held, true) != table.held.end();
  if (is_held) helpers_.Use(Helper::kBetween);
  return CallText(helpers_.Use(is_held ? Helper::kReadHeld : Helper::kReadTable),
                  {{table.name}, {places_.at(&expression)}, {element}});
}

CppText ExpressionEmitter::Chosen(const Draw& node, const CheckedExpression& expression,
                                  const Index& index, const std::string& element) {
  const Choice& choice = choices_.at(&expression);
  const std::string number =
      choice.is_each ? fmt::format("{}[{}]", choice.name, element) : choice.name;
  std::string text = Element(*node.arguments.back(), index).text;
  for (size_t i = node.arguments.size() - 1; i-- > 0;) {
    text =
        fmt::format("{} == {} ? {} : {}", number, i, Element(*node.arguments[i], index).text, text);
  }
  return {"(" + text + ")"};
}

CppText ExpressionEmitter::Call(const FunctionCall& call, const Index& index) {
  return CallText(values_.functions[call.function], Arguments(call, index));
}

std::vector<CppText> ExpressionEmitter::Arguments(const FunctionCall& call, const Index& index) {
  std::vector<CppText> arguments;
  for (const CheckedExpressionPtr& argument : call.arguments) {
    const bool is_number = call.is_each || IsScalar(argument->type);
    arguments.push_back(is_number ? Element(*argument, index) : CppText{ArrayOf(*argument)});
  }
  return arguments;
}

std::string ExpressionEmitter::ArrayOf(const CheckedExpression& expression) const {
  if (auto named = named_.find(&expression); named != named_.end()) return named->second;
  return std::visit(variant::Overloaded{
                        [&](const ConstRead& node) { return values_.consts[node.index]; },
                        [&](const SensorRead& node) { return values_.sensors[node.sensor]; },
                        [&](const MemoryRead& node) { return values_.memory[node.memory]; },
                        [&](const LocalRead& node) { return values_.locals[node.local]; },
                        [&](const ArgumentRead& node) { return values_.arguments[node.argument]; },
                        [](const auto&) { return std::string(); },
                    },
                    expression.node);
}

std::vector<CppText> ExpressionEmitter::ArgumentElements(const BuiltinCall& call,
                                                         const Index& index) {
  bool is_real = std::ranges::any_of(call.arguments, [](const CheckedExpressionPtr& argument) {
    return argument->type.scalar == Scalar::kReal;
  });
  std::vector<CppText> elements;
  for (const CheckedExpressionPtr& argument : call.arguments) {
    elements.push_back(is_real ? AsReal(*argument, index) : Element(*argument, index));
  }
  return elements;
}

CppText ExpressionEmitter::AsReal(const CheckedExpression& expression, const Index& index) {
  if (expression.type.scalar != Scalar::kInt) return Element(expression, index);
  if (const auto* constant = std::get_if<Constant>(&expression.node)) {
    return LiteralText(*constant, Scalar::kReal);
  }
  return {fmt::format("(double){}", AtLeast(Precedence::kPrefix, Element(expression, index))),
          Precedence::kPrefix};
}

CppText ExpressionEmitter::Reduced(const BuiltinCall& call, const Chain& chain, Scalar scalar,
                                   const Index& index) {
  const Type& type = call.arguments.front()->type;
  const bool is_of_each = IsOfEachVector(call, chain);
  const auto term = [&](uint32_t i) {
    const Index element = is_of_each ? InRow(index, type.columns, i) : Index{.number = i};
    return ChainTerm(chain.term, ArgumentElements(call, element));
  };
  CppText result = term(0);
  for (uint32_t i = 1; i < (is_of_each ? type.columns : type.size()); ++i) {
    result = Combine(chain.join, scalar, result, term(i), helpers_);
  }
  return FinishChain(chain.finish, result);
}

// The element at `column` of a row.
ExpressionEmitter::Index ExpressionEmitter::InRow(const Index& row, uint32_t columns,
                                                  uint32_t column) {
  if (row.variable.empty()) return {.number = row.number * columns + column};
  const bool is_sum = row.variable.find(' ') != std::string::npos;
  std::string text =
      fmt::format(fmt::runtime(is_sum ? "{} * ({})" : "{} * {}"), columns, row.variable);
  if (column > 0) text += fmt::format(" + {}", column);
  return {.variable = std::move(text)};
}

CppText ExpressionEmitter::Cross(const BuiltinCall& call, const Index& index) {
  Index next{.number = (index.number + 1) % 3};
  Index after{.number = (index.number + 2) % 3};
  auto product = [&](const Index& left, const Index& right) {
    return BinaryText(BinaryOperator::kMultiply, Element(*call.arguments[0], left),
                      Element(*call.arguments[1], right));
  };
  return BinaryText(BinaryOperator::kSubtract, product(next, after), product(after, next));
}

CppText ExpressionEmitter::Subscript(const std::string& name, const Type& type,
                                     const Index& index) const {
  if (type.shape == Shape::kScalar) return {name};
  if (index.variable.empty()) return {fmt::format("{}[{}]", name, index.number)};
  return {fmt::format("{}[{}]", name, index.variable)};
}

}  // namespace compiler
