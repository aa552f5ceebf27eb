#include "compiler/document/latex.h"

#include <fmt/format.h>

#include <cctype>

namespace compiler {
namespace {

// Names that the reader of an equation knows by a sign.
struct Sign {
  std::string_view name;
  std::string_view latex;
};
constexpr Sign kSigns[] = {
    {"time", "t"}, {"time_step", "\\Delta t"}, {"reward", "r"}, {"pi", "\\pi"}};

std::string EscapedLatex(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\textbackslash{}";
    } else if (c == '^' || c == '~') {
      escaped += fmt::format("\\{}{{}}", c);
    } else {
      if (std::string_view("_%&#${}").find(c) != std::string_view::npos) escaped += '\\';
      escaped += c;
    }
  }
  return escaped;
}

std::string InParentheses(const std::string& text) { return "\\left(" + text + "\\right)"; }

// `base.velocity` of the object `base` and the member `velocity`; empty for anything else.
std::string DottedName(const Expression& expression) {
  if (const auto* name = std::get_if<NameExpression>(&expression.node)) return name->name.text;
  const auto* member = std::get_if<MemberExpression>(&expression.node);
  if (member == nullptr) return "";
  const std::string object = DottedName(*member->object);
  return object.empty() ? "" : object + "." + member->member.text;
}

// Is `.member` some elements of a vector rather than a part of a sensor's name?
bool IsSwizzle(std::string_view member) {
  return member.size() <= 4 && member.find_first_not_of("xyzw") == std::string_view::npos;
}

std::string UnitToLatex(const UnitExpression& unit) {
  std::string above, below;
  for (const UnitFactor& factor : unit.factors) {
    std::string& side = factor.power < 0 ? below : above;
    if (!side.empty()) side += "\\,";
    side += factor.name.text;
    const int power = std::abs(factor.power);
    if (power != 1) side += "^{" + std::to_string(power) + "}";
  }
  if (below.empty()) return "\\mathrm{" + above + "}";
  return "\\mathrm{" + (above.empty() ? "1" : above) + "/" + below + "}";
}

Formula ToFormula(const NumberLiteral& literal) {
  const std::string number = NumberToLatex(literal.value);
  const bool is_product = number.find("\\times") != std::string::npos;
  if (!literal.unit || literal.unit->factors.empty()) {
    return {number, is_product ? Binding::kProduct : Binding::kAtom};
  }
  const auto& factors = literal.unit->factors;
  if (factors.size() == 1 && factors[0].name.text == "deg" && factors[0].power == 1 &&
      !is_product) {
    return {number + "^\\circ", Binding::kPower};
  }
  return {number + "\\," + UnitToLatex(*literal.unit),
          is_product ? Binding::kProduct : Binding::kAtom};
}

// Inside an index `-` takes elements away and `+` adds some.
std::string SetToLatex(const Expression& expression);

std::string SetToLatex(const std::vector<ExpressionPtr>& items) {
  std::string text;
  for (const ExpressionPtr& item : items) {
    if (!text.empty()) text += ",\\,";
    text += SetToLatex(*item);
  }
  return text;
}

std::string SetToLatex(const Expression& expression) {
  if (const auto* set = std::get_if<SetExpression>(&expression.node)) {
    return "\\{" + SetToLatex(set->items) + "\\}";
  }
  if (const auto* range = std::get_if<RangeExpression>(&expression.node)) {
    return SetToLatex(*range->first) + "\\ldots " + SetToLatex(*range->last);
  }
  const auto* binary = std::get_if<BinaryExpression>(&expression.node);
  const bool takes_away = binary != nullptr && binary->op == BinaryOperator::kSubtract;
  const bool adds = binary != nullptr && binary->op == BinaryOperator::kAdd;
  if (!takes_away && !adds) return ToFormula(expression).text;
  std::string right = SetToLatex(*binary->right);
  if (std::holds_alternative<BinaryExpression>(binary->right->node)) right = InParentheses(right);
  return SetToLatex(*binary->left) + (adds ? " \\cup " : " \\setminus ") + right;
}

// A subscript that others may follow.
std::string SubscriptOf(const std::vector<ExpressionPtr>& items) {
  const std::string set = SetToLatex(items);
  return items.size() > 1 ? "\\{" + set + "\\}" : set;
}

std::string Subscripts(const std::string& first, const std::string& second) {
  return first + ",\\," + second;
}

// What is picked out of an object. Nothing has two subscripts: what is picked out of what has been
// picked stands behind it, as in `p_{foot,\,z}`.
Formula Picked(const Expression& object, const std::string& subscript) {
  if (const auto* index = std::get_if<IndexExpression>(&object.node)) {
    return Picked(*index->object, Subscripts(SubscriptOf(index->items), subscript));
  }
  const auto* member = std::get_if<MemberExpression>(&object.node);
  if (member != nullptr && IsSwizzle(member->member.text)) {
    return Picked(*member->object, Subscripts(member->member.text, subscript));
  }
  return {AtLeast(Binding::kAtom, ToFormula(object)) + "_{" + subscript + "}"};
}

Formula ToFormula(const MemberExpression& member) {
  if (IsSwizzle(member.member.text)) return Picked(*member.object, member.member.text);
  return {NameToLatex(DottedName(*member.object) + "." + member.member.text)};
}

Formula Infix(std::string_view sign, Binding binding, Binding right, const BinaryExpression& node) {
  return {AtLeast(binding, ToFormula(*node.left)) + " " + std::string(sign) + " " +
              AtLeast(right, ToFormula(*node.right)),
          binding};
}

Formula WithoutMinus(const Formula& negation) {
  return {negation.text.substr(1), negation.behind_minus};
}

// The language has no powers: a square is a product with itself.
Formula ProductOrSquare(const Formula& left, const Formula& right) {
  if (left.binding == Binding::kNegation) return Minus(ProductOrSquare(WithoutMinus(left), right));
  const bool is_number = std::isdigit(static_cast<unsigned char>(left.text.front())) != 0;
  return left.text == right.text && !is_number ? Power(left, "2") : Product(left, right);
}

Formula ToFormula(const BinaryExpression& node) {
  switch (node.op) {
    case BinaryOperator::kAdd:
      return Sum({ToFormula(*node.left), ToFormula(*node.right)});
    case BinaryOperator::kSubtract:
      return Infix("-", Binding::kSum, Binding::kInnerProduct, node);
    case BinaryOperator::kMultiply:
      return ProductOrSquare(ToFormula(*node.left), ToFormula(*node.right));
    case BinaryOperator::kDivide:
      return Quotient(ToFormula(*node.left), ToFormula(*node.right));
    case BinaryOperator::kLess:
      return Infix("<", Binding::kComparison, Binding::kSum, node);
    case BinaryOperator::kLessEqual:
      return Infix("\\le", Binding::kComparison, Binding::kSum, node);
    case BinaryOperator::kGreater:
      return Infix(">", Binding::kComparison, Binding::kSum, node);
    case BinaryOperator::kGreaterEqual:
      return Infix("\\ge", Binding::kComparison, Binding::kSum, node);
    case BinaryOperator::kEqual:
      return Infix("=", Binding::kComparison, Binding::kSum, node);
    case BinaryOperator::kNotEqual:
      return Infix("\\ne", Binding::kComparison, Binding::kSum, node);
    case BinaryOperator::kAnd:
      return Infix("\\land", Binding::kAnd, Binding::kAnd, node);
    case BinaryOperator::kOr:
      return Infix("\\lor", Binding::kOr, Binding::kOr, node);
  }
  return {};
}

struct LatexWriter {
  Formula operator()(const NumberLiteral& node) const { return ToFormula(node); }
  Formula operator()(const BoolLiteral& node) const {
    return {node.value ? "\\mathrm{true}" : "\\mathrm{false}"};
  }
  Formula operator()(const NameExpression& node) const { return {NameToLatex(node.name.text)}; }
  Formula operator()(const MemberExpression& node) const { return ToFormula(node); }
  Formula operator()(const IndexExpression& node) const {
    return Picked(*node.object, SetToLatex(node.items));
  }
  Formula operator()(const RangeExpression& node) const {
    return {SetToLatex(*node.first) + "\\ldots " + SetToLatex(*node.last)};
  }
  Formula operator()(const SetExpression& node) const {
    return {"\\{" + SetToLatex(node.items) + "\\}"};
  }
  Formula operator()(const CallExpression& node) const {
    std::vector<Formula> arguments;
    for (const ExpressionPtr& argument : node.arguments) arguments.push_back(ToFormula(*argument));
    return CallFormula(node.function.text, arguments);
  }
  Formula operator()(const UnaryExpression& node) const {
    if (node.op == UnaryOperator::kNot) return Not(ToFormula(*node.operand));
    return Minus(ToFormula(*node.operand));
  }
  Formula operator()(const BinaryExpression& node) const { return ToFormula(node); }
  // A task with errors has no page.
  Formula operator()(const MethodExpression&) const { return {}; }
  Formula operator()(const LostExpression&) const { return {}; }
};

}  // namespace

Formula ToFormula(const Expression& expression) {
  return std::visit(LatexWriter{}, expression.node);
}

Formula ToFormula(const std::vector<ExpressionPtr>& items) { return {SubscriptOf(items)}; }

Formula ToFormula(const Target& target) {
  std::string subscript = target.member ? target.member->text : "";
  if (!target.items.empty()) {
    const std::string set =
        target.indexed_member ? SubscriptOf(target.items) : SetToLatex(target.items);
    subscript = subscript.empty() ? set : Subscripts(subscript, set);
  }
  if (target.indexed_member) subscript = Subscripts(subscript, target.indexed_member->text);
  const std::string name = NameToLatex(target.name.text);
  return {subscript.empty() ? name : name + "_{" + subscript + "}"};
}

std::string AtLeast(Binding least, const Formula& formula) {
  return formula.binding < least ? InParentheses(formula.text) : formula.text;
}

Formula Minus(const Formula& operand) {
  const bool has_parentheses = operand.binding < Binding::kInnerProduct;
  return {"-" + AtLeast(Binding::kInnerProduct, operand), Binding::kNegation,
          has_parentheses ? Binding::kAtom : operand.binding};
}

// The sign of what is above, or to the left, stands before the whole.
Formula Quotient(const Formula& above, const Formula& below) {
  if (above.binding == Binding::kNegation) return Minus(Quotient(WithoutMinus(above), below));
  return {"\\frac{" + above.text + "}{" + below.text + "}"};
}

Formula Product(const Formula& left, const Formula& right) {
  if (left.binding == Binding::kNegation) return Minus(Product(WithoutMinus(left), right));
  const std::string first = AtLeast(Binding::kProduct, left);
  const std::string second = AtLeast(Binding::kProduct, right);
  // Numbers side by side would look like one.
  const bool is_number = std::isdigit(static_cast<unsigned char>(second.front())) != 0;
  return {first + (is_number ? " \\cdot " : "\\,") + second, Binding::kProduct};
}

Formula Power(const Formula& base, const std::string& exponent) {
  return {AtLeast(Binding::kAtom, base) + "^{" + exponent + "}", Binding::kPower};
}

Formula Sum(const std::vector<Formula>& summands) {
  if (summands.empty()) return {"0"};
  if (summands.size() == 1) return summands.front();
  Formula sum{"", Binding::kSum};
  for (const Formula& summand : summands) {
    const bool is_first = &summand == &summands.front();
    if (!is_first) sum.text += " + ";
    sum.text += !is_first && summand.binding == Binding::kNegation
                    ? InParentheses(summand.text)
                    : AtLeast(Binding::kSum, summand);
  }
  return sum;
}

Formula Not(const Formula& condition) {
  return {"\\lnot " + AtLeast(Binding::kAtom, condition), Binding::kNot};
}

Formula Conjunction(const std::vector<Formula>& conditions) {
  if (conditions.size() == 1) return conditions.front();
  Formula all{"", Binding::kAnd};
  for (const Formula& condition : conditions) {
    if (!all.text.empty()) all.text += " \\land ";
    all.text += AtLeast(Binding::kAnd, condition);
  }
  return all;
}

std::string NameToLatex(std::string_view name) {
  for (const Sign& sign : kSigns) {
    if (sign.name == name) return std::string(sign.latex);
  }
  if (name.size() == 1) return std::string(name);
  return "\\mathrm{" + EscapedLatex(name) + "}";
}

std::string TextToLatex(std::string_view text) { return "\\text{" + EscapedLatex(text) + "}"; }

// The shortest digits that mean this number; powers of ten for the very large and small.
std::string NumberToLatex(double value) {
  const std::string digits = fmt::format("{}", value);
  const size_t exponent = digits.find('e');
  if (exponent == std::string::npos) return digits;
  return digits.substr(0, exponent) + " \\times 10^{" +
         std::to_string(std::stoi(digits.substr(exponent + 1))) + "}";
}

}  // namespace compiler
