// How mathematics writes the functions of the language.
#include "compiler/document/latex.h"

namespace compiler {
namespace {

// A function that is written around its one argument, or between its two.
struct Notation {
  std::string_view function;
  std::string_view before;
  std::string_view after;
};
constexpr Notation kAround[] = {
    {"norm", "\\left\\lVert ", " \\right\\rVert"},
    {"abs", "\\left\\lvert ", " \\right\\rvert"},
    {"floor", "\\left\\lfloor ", " \\right\\rfloor"},
    {"ceil", "\\left\\lceil ", " \\right\\rceil"},
    {"sqrt", "\\sqrt{", "}"},
};
constexpr Notation kBehind[] = {{"inverse", "", "^{-1}"}, {"transpose", "", "^{\\top}"}};

// Functions that LaTeX knows under a name of its own.
constexpr Notation kCommands[] = {
    {"exp", "\\exp", ""},     {"log", "\\ln", ""},      {"sin", "\\sin", ""},
    {"cos", "\\cos", ""},     {"tan", "\\tan", ""},     {"tanh", "\\tanh", ""},
    {"asin", "\\arcsin", ""}, {"acos", "\\arccos", ""}, {"atan", "\\arctan", ""},
    {"min", "\\min", ""},     {"max", "\\max", ""},
};

template <size_t kCount>
const Notation* Find(const Notation (&notations)[kCount], std::string_view function) {
  for (const Notation& notation : notations) {
    if (notation.function == function) return &notation;
  }
  return nullptr;
}

// The function's own name, as operators are written.
std::string OperatorName(std::string_view function) {
  if (const Notation* command = Find(kCommands, function)) return std::string(command->before);
  std::string name = "\\operatorname{";
  for (const char c : function) {
    if (c == '_') name += '\\';
    name += c;
  }
  return name + "}";
}

Formula Between(const std::string& sign, const std::vector<Formula>& arguments) {
  return {AtLeast(Binding::kPower, arguments[0]) + " " + sign + " " +
              AtLeast(Binding::kPower, arguments[1]),
          Binding::kInnerProduct};
}

Formula Selection(const std::vector<Formula>& arguments) {
  return {"\\begin{cases} " + arguments[1].text + " & \\text{if } " + arguments[0].text + " \\\\ " +
          arguments[2].text + " & \\text{otherwise} \\end{cases}"};
}

}  // namespace

Formula CallFormula(std::string_view function, const std::vector<Formula>& arguments) {
  const size_t count = arguments.size();
  if (const Notation* around = Find(kAround, function); around != nullptr && count == 1) {
    return {std::string(around->before) + arguments[0].text + std::string(around->after)};
  }
  if (const Notation* behind = Find(kBehind, function); behind != nullptr && count == 1) {
    return {AtLeast(Binding::kAtom, arguments[0]) + std::string(behind->after), Binding::kPower};
  }
  if (function == "dot" && count == 2) return Between("\\cdot", arguments);
  if (function == "cross" && count == 2) return Between("\\times", arguments);
  if (function == "pow" && count == 2) {
    return {AtLeast(Binding::kAtom, arguments[0]) + "^{" + arguments[1].text + "}",
            Binding::kPower};
  }
  if (function == "select" && count == 3) return Selection(arguments);
  std::string text;
  for (const Formula& argument : arguments) {
    if (!text.empty()) text += ",\\; ";
    text += argument.text;
  }
  return {OperatorName(function) + "\\left(" + text + "\\right)"};
}

}  // namespace compiler
