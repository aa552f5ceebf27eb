#include "compiler/difference/expression_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/variant/overloaded.h"
#include "compiler/check/builtins.h"
#include "compiler/check/draws.h"
#include "compiler/check/names.h"
#include "compiler/check/time_functions.h"
#include "compiler/check/unit.h"
#include "compiler/syntax/words.h"

namespace compiler {
namespace {

// A longer text stands for itself by its hash, so that values of values do not grow without bound.
constexpr size_t kLongest = 20'000;

ExpressionText Shortened(ExpressionText text) {
  if (text.text.size() <= kLongest) return text;
  return {fmt::format("<{:x}>", std::hash<std::string>()(text.text)), TextBinding::kAtom,
          text.is_changing};
}

TextBinding BindingOf(BinaryOperator op) {
  switch (op) {
    case BinaryOperator::kAdd:
    case BinaryOperator::kSubtract:
      return TextBinding::kSum;
    case BinaryOperator::kMultiply:
    case BinaryOperator::kDivide:
      return TextBinding::kProduct;
    case BinaryOperator::kLess:
    case BinaryOperator::kLessEqual:
    case BinaryOperator::kGreater:
    case BinaryOperator::kGreaterEqual:
    case BinaryOperator::kEqual:
    case BinaryOperator::kNotEqual:
      return TextBinding::kComparison;
    case BinaryOperator::kAnd:
      return TextBinding::kAnd;
    case BinaryOperator::kOr:
      return TextBinding::kOr;
  }
  return TextBinding::kAtom;
}

std::string AtLeast(TextBinding least, const ExpressionText& operand) {
  return operand.binding < least ? "(" + operand.text + ")" : operand.text;
}

TextBinding Next(TextBinding binding) {
  return static_cast<TextBinding>(static_cast<int>(binding) + 1);
}

std::string_view NameOf(Builtin function, const Type& type) {
  if (function == Builtin::kVector) {
    switch (type.shape) {
      case Shape::kQuaternion:
        return "quat";
      case Shape::kVector:
        return type.rows == 2 ? "vec2" : type.rows == 3 ? "vec3" : "vec4";
      case Shape::kScalar:
      case Shape::kMatrix:
      case Shape::kArray:
        return "values";
    }
  }
  for (const std::string& name : BuiltinNames()) {
    const BuiltinDescription* found = FindBuiltin(name);
    const Builtin* builtin = std::get_if<Builtin>(&found->function);
    if (builtin != nullptr && *builtin == function) return found->name;
  }
  return "";
}

std::string_view NameOf(Distribution distribution) {
  return std::ranges::find(kDraws, distribution, &DrawDescription::distribution)->name;
}

const char* ElementName(const Type& type, uint32_t element) {
  static constexpr const char* kOfVector[] = {"x", "y", "z", "w"};
  static constexpr const char* kOfQuaternion[] = {"w", "x", "y", "z"};
  const Shape shape = type.shape == Shape::kArray ? type.entry : type.shape;
  return shape == Shape::kQuaternion ? kOfQuaternion[element % 4] : kOfVector[element % 4];
}

// `on` and all that it has before it reads the advance of each time function from the event.
void FindAdvances(const CheckedBlock& block, const CheckedTask& task,
                  std::map<uint32_t, const CheckedAdvance*>& found) {
  for (const CheckedStatement& statement : block) {
    if (const auto* advance = std::get_if<CheckedAdvance>(&statement.node)) {
      if (!advance->is_start) found[task.time_functions[advance->function].value] = advance;
    }
  }
}

}  // namespace

std::string OwnName(const std::string& name) { return name.substr(0, name.find('#')); }

std::string NumberWithUnit(double value, const Type& type, const Unit& unit) {
  if (type.scalar == Scalar::kBool) return value != 0 ? "true" : "false";
  const std::string name = ToString(unit);
  return name.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, name);
}

ExpressionWriter::ExpressionWriter(const CheckedTask& task,
                                   const std::vector<Enumeration>& enumerations)
    : task_(task), enumerations_(enumerations) {
  for (const CheckedEvent& event : task.events) FindAdvances(event.body, task, time_functions_);
}

void ExpressionWriter::Begin(std::set<uint32_t> changed) {
  changed_ = std::move(changed);
  locals_.clear();
}

std::string ExpressionWriter::EntryText(const Type& type, uint32_t entry) const {
  const Enumeration* parts = FindEnumeration(enumerations_, type.index);
  return parts != nullptr ? parts->members[entry] : fmt::format("{}", entry);
}

std::string ExpressionWriter::SelectionText(const Type& type,
                                            const std::vector<uint32_t>& elements) const {
  if (elements.empty()) return "";
  if (type.shape == Shape::kVector || type.shape == Shape::kQuaternion) {
    std::string text = ".";
    for (const uint32_t element : elements) text += ElementName(type, element);
    return text;
  }
  std::vector<std::string> names;
  std::vector<uint32_t> entries;
  for (size_t i = 0; i < elements.size(); ++i) {
    const uint32_t entry = elements[i] / type.columns;
    bool is_whole = elements[i] % type.columns == 0 && i + type.columns <= elements.size();
    for (uint32_t j = 0; is_whole && j < type.columns; ++j)
      is_whole = elements[i + j] == elements[i] + j;
    if (is_whole) {
      entries.push_back(entry);
      names.push_back(EntryText(type, entry));
      i += type.columns - 1;
    } else if (type.shape == Shape::kMatrix) {
      names.push_back(fmt::format("{}, {}", entry, elements[i] % type.columns));
    } else {
      names.push_back(EntryText(type, entry) + "." + ElementName(type, elements[i] % type.columns));
    }
  }
  const Enumeration* parts = FindEnumeration(enumerations_, type.index);
  if (parts != nullptr && entries.size() == names.size()) {
    for (const robot::Group& group : parts->groups)
      if (std::ranges::equal(group.members, entries, std::equal_to<>(), {},
                             [](uint32_t entry) { return static_cast<int>(entry); }))
        return "[" + group.name + "]";
  }
  return fmt::format("[{}]", fmt::join(names, ", "));
}

ExpressionText ExpressionWriter::WriteCall(const FunctionCall& call) {
  const CheckedFunction& function = task_.functions[call.function];
  Texts arguments;
  for (uint32_t i = 0; i < call.arguments.size(); ++i) arguments[i] = Write(*call.arguments[i]);
  std::swap(arguments, arguments_);
  Texts locals;
  std::swap(locals, locals_);
  for (const CheckedLet& let : function.lets) locals_[let.local] = Write(let.value);
  ExpressionText text = Write(function.value);
  std::swap(locals, locals_);
  std::swap(arguments, arguments_);
  if (call.is_each) text = {"each(" + text.text + ")", TextBinding::kAtom, text.is_changing};
  return text;
}

ExpressionText ExpressionWriter::WriteMemory(uint32_t memory) {
  const bool is_changing = changed_.contains(memory);
  const auto advance = time_functions_.find(memory);
  if (advance == time_functions_.end())
    return {OwnName(task_.memory[memory].name), TextBinding::kAtom, is_changing};
  const TimeFunction function = task_.time_functions[advance->second->function].function;
  std::string text = fmt::format("{}({}", NameOf(function), Text(advance->second->value));
  if (advance->second->duration) text += ", " + Text(*advance->second->duration);
  return {text + ")", TextBinding::kAtom, false};
}

class ExpressionWriter::Visitor {
 public:
  Visitor(ExpressionWriter& writer, const CheckedExpression& expression)
      : writer_(writer), task_(writer.task_), expression_(expression) {}

  ExpressionText operator()(const Constant& constant) {
    ExpressionText text{NumberWithUnit(constant.value, expression_.type, expression_.unit)};
    if (text.text.starts_with('-')) text.binding = TextBinding::kMinus;
    return text;
  }
  ExpressionText operator()(const ConstRead& read) {
    const CheckedConst& constant = task_.consts[read.index];
    return {fmt::format("{} {{{}}}", TypeText(constant.type, constant.unit),
                        fmt::join(constant.elements, ", "))};
  }
  ExpressionText operator()(const SensorRead& read) { return {task_.sensors[read.sensor].name}; }
  ExpressionText operator()(const ParamRead& read) { return {task_.params[read.param].name}; }
  ExpressionText operator()(const MemoryRead& read) { return writer_.WriteMemory(read.memory); }
  ExpressionText operator()(const LocalRead& read) { return writer_.locals_.at(read.local); }
  ExpressionText operator()(const ArgumentRead& read) {
    return writer_.arguments_.at(read.argument);
  }
  ExpressionText operator()(const RewardSoFar&) {
    return {std::string(kReward), TextBinding::kAtom, true};
  }
  ExpressionText operator()(const TimeStep&) { return {std::string(kTimeStep)}; }
  ExpressionText operator()(const Elements& elements) {
    const ExpressionText operand = writer_.Write(*elements.operand);
    return {AtLeast(TextBinding::kAtom, operand) +
                writer_.SelectionText(elements.operand->type, elements.indices),
            TextBinding::kAtom, operand.is_changing};
  }
  ExpressionText operator()(const CheckedUnary& unary) {
    const ExpressionText operand = writer_.Write(*unary.operand);
    const bool is_not = unary.op == UnaryOperator::kNot;
    const TextBinding binding = is_not ? TextBinding::kNot : TextBinding::kMinus;
    return {(is_not ? "not " : "-") + AtLeast(binding, operand), binding, operand.is_changing};
  }
  ExpressionText operator()(const CheckedBinary& binary) {
    const ExpressionText left = writer_.Write(*binary.left);
    const ExpressionText right = writer_.Write(*binary.right);
    const std::string_view sign = compiler::NameOf(binary.op, kBinarySymbols);
    const TextBinding binding = BindingOf(binary.op);
    const bool is_chain = binding != TextBinding::kComparison;
    return {fmt::format("{} {} {}", AtLeast(is_chain ? binding : Next(binding), left), sign,
                        AtLeast(Next(binding), right)),
            binding, left.is_changing || right.is_changing};
  }
  ExpressionText operator()(
      const CheckedWithin& within) {  // only in tests, which mean nothing here
    return writer_.Write(*within.left);
  }
  ExpressionText operator()(const BuiltinCall& call) {
    return Call(NameOf(call.function, expression_.type), call.arguments);
  }
  ExpressionText operator()(const FunctionCall& call) { return writer_.WriteCall(call); }
  ExpressionText operator()(const Draw& draw) {
    return Call(NameOf(draw.distribution), draw.arguments);
  }
  ExpressionText operator()(const TableRead& read) {
    const ExpressionText operand = writer_.Write(*read.operand);
    return {fmt::format("{}({}{})", task_.tables[read.table].name, operand.text,
                        read.repeats ? ", loop" : ""),
            TextBinding::kAtom, operand.is_changing};
  }
  ExpressionText operator()(const TestRead&) { return {}; }  // only in tests
  ExpressionText operator()(const IntToReal& conversion) {
    return writer_.Write(*conversion.operand);
  }

 private:
  ExpressionText Call(std::string_view name, const std::vector<CheckedExpressionPtr>& arguments) {
    std::vector<std::string> texts;
    bool is_changing = false;
    for (const CheckedExpressionPtr& argument : arguments) {
      const ExpressionText text = writer_.Write(*argument);
      texts.push_back(text.text);
      is_changing = is_changing || text.is_changing;
    }
    return {fmt::format("{}({})", name, fmt::join(texts, ", ")), TextBinding::kAtom, is_changing};
  }

  ExpressionWriter& writer_;
  const CheckedTask& task_;
  const CheckedExpression& expression_;
};

ExpressionText ExpressionWriter::Write(const CheckedExpression& expression) {
  return Shortened(std::visit(Visitor(*this, expression), expression.node));
}

}  // namespace compiler
