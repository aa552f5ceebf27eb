// The parts of an expression that get a name before it is written.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/variant/overloaded.h"
#include "compiler/check/traversal.h"
#include "compiler/check/type.h"
#include "compiler/emit/chain.h"
#include "compiler/emit/expression_emitter.h"
#include "compiler/emit/lookup_tables.h"

namespace compiler {
namespace {

std::vector<const CheckedExpression*> PointersTo(const std::vector<CheckedExpressionPtr>& list) {
  std::vector<const CheckedExpression*> pointers;
  for (const CheckedExpressionPtr& part : list) pointers.push_back(part.get());
  return pointers;
}

// What the expression is made of, one level down.
std::vector<const CheckedExpression*> Operands(const CheckedExpression& expression) {
  using Result = std::vector<const CheckedExpression*>;
  return std::visit(variant::Overloaded{
                        [](const Elements& node) { return Result{node.operand.get()}; },
                        [](const CheckedUnary& node) { return Result{node.operand.get()}; },
                        [](const CheckedBinary& node) {
                          return Result{node.left.get(), node.right.get()};
                        },
                        [](const IntToReal& node) { return Result{node.operand.get()}; },
                        [](const TableRead& node) { return Result{node.operand.get()}; },
                        [](const BuiltinCall& node) { return PointersTo(node.arguments); },
                        [](const FunctionCall& node) { return PointersTo(node.arguments); },
                        [](const Draw& node) { return PointersTo(node.arguments); },
                        [](const auto&) { return Result{}; },
                    },
                    expression.node);
}

// Whether reading it again costs no computation.
bool IsMereRead(const CheckedExpression& expression) {
  if (const auto* elements = std::get_if<Elements>(&expression.node)) {
    return IsMereRead(*elements->operand);
  }
  return Operands(expression).empty() && !std::holds_alternative<FunctionCall>(expression.node);
}

// Whether it has one value in a whole callback.
bool IsFixed(const CheckedExpression& expression) {
  bool is_fixed = true;
  ForEachPart(expression, [&](const CheckedExpression& part) {
    is_fixed = is_fixed && !std::holds_alternative<MemoryRead>(part.node) &&
               !std::holds_alternative<RewardSoFar>(part.node);
  });
  return is_fixed;
}

bool HasRepetition(std::vector<uint32_t> indices) {
  std::ranges::sort(indices);
  return std::ranges::adjacent_find(indices) != indices.end();
}

}  // namespace

void ExpressionEmitter::Prepare(const CheckedExpression& expression, Use use) {
  if (const auto* call = std::get_if<BuiltinCall>(&expression.node)) {
    PrepareCall(expression, *call);
  } else if (const auto* function = std::get_if<FunctionCall>(&expression.node)) {
    PrepareCall(expression, *function);
  } else if (const auto* draw = std::get_if<Draw>(&expression.node)) {
    PrepareDraw(expression, *draw);
  } else if (const auto* table = std::get_if<TableRead>(&expression.node)) {
    PrepareTable(expression, *table);
  } else if (const auto* elements = std::get_if<Elements>(&expression.node)) {
    Prepare(*elements->operand, HasRepetition(elements->indices) ? Use::kRepeatedly : Use::kOnce);
  } else {
    PrepareElementwise(expression);
  }
  bool has_name = named_.contains(&expression) || IsMereRead(expression);
  if (use == Use::kRepeatedly && !has_name) NameValue(expression);
}

void ExpressionEmitter::PrepareElementwise(const CheckedExpression& expression) {
  for (const CheckedExpression* operand : Operands(expression)) {
    bool is_spread = IsScalar(operand->type) && !IsScalar(expression.type);
    Prepare(*operand, is_spread ? Use::kRepeatedly : Use::kOnce);
  }
}

void ExpressionEmitter::PrepareCall(const CheckedExpression& expression, const BuiltinCall& call) {
  const std::optional<Chain> chain = ChainOf(call);
  const bool is_cross = call.function == Builtin::kCross;
  const bool is_vector = call.function == Builtin::kVector;
  if (!chain && !is_cross && !is_vector) return PrepareElementwise(expression);
  const bool is_squared = chain && chain->term == Chain::Term::kSquare;
  for (const CheckedExpressionPtr& argument : call.arguments) {
    Prepare(*argument, is_cross || is_squared ? Use::kRepeatedly : Use::kOnce);
  }
  const bool is_long = call.arguments.front()->type.size() > written_out_;
  if (chain && is_long) NameLongChain(expression, call, *chain);
  if (is_vector && call.arguments.size() > written_out_) NameLongList(expression, call);
}

void ExpressionEmitter::PrepareCall(const CheckedExpression& expression, const FunctionCall& call) {
  if (call.is_each) return PrepareElementwise(expression);
  for (const CheckedExpressionPtr& argument : call.arguments) {
    Prepare(*argument, Use::kOnce);
    // A function takes an array where it lies.
    if (!IsScalar(argument->type) && ArrayOf(*argument).empty()) NameValue(*argument);
  }
  if (!IsScalar(expression.type)) NameResult(expression, call);
}

void ExpressionEmitter::PrepareDraw(const CheckedExpression& expression, const Draw& draw) {
  PrepareElementwise(expression);
  helpers_.Use(Helper::kDrawPlace);
  helpers_.Use(Helper::kRandomUnit);
  if (draw.distribution == Distribution::kNormal) {
    helpers_.Use(Helper::kLog);
    helpers_.Use(Helper::kCos);
  }
  if (draw.distribution == Distribution::kChoice) NameChoice(expression, draw);
}

// Rotations are computed as a whole.
void ExpressionEmitter::PrepareTable(const CheckedExpression& expression, const TableRead& read) {
  const std::string place = places_[&expression] = PlaceOf(read);
  if (!IsOfQuaternions(expression.type)) return;
  helpers_.Use(Helper::kBetween);
  const std::string name = names_.Add("part");
  parts_.push_back(Declarator(name, expression.type) + ";");
  parts_.push_back(fmt::format("{}({}, {}, {});", helpers_.Use(Helper::kReadRotations),
                               values_.tables[read.table].name, place, name));
  named_[&expression] = name;
}

// A place is searched for once, also for several tables with the same arguments, where nothing can
// change it meanwhile.
const std::string& ExpressionEmitter::PlaceOf(const TableRead& read) {
  Prepare(*read.operand, Use::kOnce);
  const std::string text = TablePlaceText(values_.tables[read.table].searched, read.repeats,
                                          Element(*read.operand, {}).text, helpers_);
  if (!IsFixed(*read.operand)) known_places_.erase(text);
  const auto [place, is_new] = known_places_.try_emplace(text);
  if (is_new) {
    place->second = names_.Add("place");
    parts_.push_back(fmt::format("const TablePlace {} = {};", place->second, text));
  }
  return place->second;
}

// Which value is chosen: a number, or one for each element.
void ExpressionEmitter::NameChoice(const CheckedExpression& expression, const Draw& draw) {
  const bool is_each = IsScalar(draw.arguments.front()->type) && !IsScalar(expression.type);
  std::string name = names_.Add("choice");
  const std::string_view choose = helpers_.Use(Helper::kChoose);
  const size_t count = draw.arguments.size();
  if (is_each) {
    const uint32_t size = expression.type.size();
    parts_.push_back(fmt::format("int {}[{}];", name, size));
    parts_.push_back(fmt::format("for (int i = 0; i < {}; ++i) {}[i] = {}(draw, i, {}, {});", size,
                                 name, choose, draw.site, count));
  } else {
    parts_.push_back(
        fmt::format("const int {} = {}(draw, 0, {}, {});", name, choose, draw.site, count));
  }
  choices_[&expression] = {name, is_each};
}

void ExpressionEmitter::NameValue(const CheckedExpression& expression) {
  std::string_view type = CppType(expression.type.scalar);
  std::string name = names_.Add("part");
  if (IsScalar(expression.type)) {
    parts_.push_back(fmt::format("const {} {} = {};", type, name, Element(expression, {}).text));
  } else {
    std::vector<std::string> lines =
        ArrayDefinition(name, expression.type, AllElements(expression, expression.type.size()));
    parts_.insert(parts_.end(), lines.begin(), lines.end());
  }
  named_[&expression] = name;
}

// A result that is an array is written where the caller wants it.
void ExpressionEmitter::NameResult(const CheckedExpression& expression, const FunctionCall& call) {
  std::string name = names_.Add("part");
  std::vector<CppText> arguments = Arguments(call, {});
  arguments.push_back({name});
  parts_.push_back(Declarator(name, expression.type) + ";");
  parts_.push_back(CallText(values_.functions[call.function], arguments).text + ";");
  named_[&expression] = name;
}

void ExpressionEmitter::NameLongChain(const CheckedExpression& expression, const BuiltinCall& call,
                                      const Chain& chain) {
  std::string name = names_.Add("part");
  Scalar scalar = expression.type.scalar;
  named_[&expression] = name;
  if (IsOfEachVector(call, chain)) {
    CppText each = Reduced(call, chain, scalar, {.variable = "i"});
    parts_.push_back(Declarator(name, expression.type) + ";");
    parts_.push_back(fmt::format("for (int i = 0; i < {}; ++i) {}[i] = {};", expression.type.size(),
                                 name, each.text));
    return;
  }
  CppText first = ChainTerm(chain.term, ArgumentElements(call, {}));
  CppText next = ChainTerm(chain.term, ArgumentElements(call, {.variable = "i"}));
  parts_.push_back(fmt::format("{} {} = {};", CppType(scalar), name, first.text));
  parts_.push_back(fmt::format("for (int i = 1; i < {}; ++i) {} = {};",
                               call.arguments.front()->type.size(), name,
                               Combine(chain.join, scalar, {name}, next, helpers_).text));
  CppText result = FinishChain(chain.finish, {name});
  if (result.text != name) parts_.push_back(fmt::format("{} = {};", name, result.text));
}

void ExpressionEmitter::NameLongList(const CheckedExpression& expression, const BuiltinCall& call) {
  std::string name = names_.Add("part");
  std::vector<std::string> elements;
  for (const CheckedExpressionPtr& argument : call.arguments) {
    elements.push_back(AsReal(*argument, {}).text);
  }
  parts_.push_back(fmt::format("const {} = {{{}}};", Declarator(name, expression.type),
                               fmt::join(elements, ", ")));
  named_[&expression] = name;
}

const std::string& ExpressionEmitter::TableOf(const std::vector<uint32_t>& indices) {
  std::string& name = tables_[indices];
  if (name.empty()) {
    name = names_.Add("indices");
    parts_.push_back(IndexTable(name, indices));
  }
  return name;
}

}  // namespace compiler
