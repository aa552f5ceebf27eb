// How mathematics writes the functions of the language.
#include <cstdlib>
#include <variant>

#include "compiler/check/builtins.h"
#include "compiler/document/latex.h"

namespace compiler {
namespace {

using Arguments = std::vector<Formula>;

Formula Around(const std::string& before, const Formula& argument, const std::string& after) {
  return {before + argument.text + after};
}

Formula Between(const std::string& sign, const Arguments& arguments) {
  return {AtLeast(Binding::kPower, arguments[0]) + " " + sign + " " +
              AtLeast(Binding::kPower, arguments[1]),
          Binding::kInnerProduct};
}

Formula Selection(const Arguments& arguments) {
  return {"\\begin{cases} " + arguments[1].text + " & \\text{if } " + arguments[0].text + " \\\\ " +
          arguments[2].text + " & \\text{otherwise} \\end{cases}"};
}

// `name`: as LaTeX sets it.
Formula Called(const std::string& name, const Arguments& arguments) {
  std::string text;
  for (const Formula& argument : arguments) {
    if (!text.empty()) text += ",\\; ";
    text += argument.text;
  }
  return {name + "\\left(" + text + "\\right)"};
}

// The function's own name, as operators are written.
Formula CalledByName(std::string_view function, const Arguments& arguments) {
  std::string name = "\\operatorname{";
  for (const char c : function) {
    if (c == '_') name += '\\';
    name += c;
  }
  return Called(name + "}", arguments);
}

// Of builtins, whose arguments are as many as they should be.
struct BuiltinFormula {
  Formula operator()(Builtin function) const {
    switch (function) {
      case Builtin::kNorm:
        return Around("\\left\\lVert ", arguments[0], " \\right\\rVert");
      case Builtin::kAbs:
        return Around("\\left\\lvert ", arguments[0], " \\right\\rvert");
      case Builtin::kFloor:
        return Around("\\left\\lfloor ", arguments[0], " \\right\\rfloor");
      case Builtin::kCeil:
        return Around("\\left\\lceil ", arguments[0], " \\right\\rceil");
      case Builtin::kSqrt:
        return Around("\\sqrt{", arguments[0], "}");
      case Builtin::kDot:
        return Between("\\cdot", arguments);
      case Builtin::kCross:
        return Between("\\times", arguments);
      case Builtin::kPow:
        return Power(arguments[0], arguments[1].text);
      case Builtin::kSelect:
        return Selection(arguments);
      case Builtin::kExp:
        return Called("\\exp", arguments);
      case Builtin::kLog:
        return Called("\\ln", arguments);
      case Builtin::kTanh:
        return Called("\\tanh", arguments);
      case Builtin::kSin:
        return Called("\\sin", arguments);
      case Builtin::kCos:
        return Called("\\cos", arguments);
      case Builtin::kTan:
        return Called("\\tan", arguments);
      case Builtin::kAsin:
        return Called("\\arcsin", arguments);
      case Builtin::kAcos:
        return Called("\\arccos", arguments);
      case Builtin::kAtan:
        return Called("\\arctan", arguments);
      case Builtin::kMin:
        return Called("\\min", arguments);
      case Builtin::kMax:
        return Called("\\max", arguments);
      case Builtin::kAny:
      case Builtin::kAll:
      case Builtin::kNone:
      case Builtin::kCount:
      case Builtin::kSum:
      case Builtin::kClamp:
      case Builtin::kAtan2:
      case Builtin::kSign:
      case Builtin::kRound:
      case Builtin::kVector:
        return CalledByName(name, arguments);
    }
    std::abort();
  }

  Formula operator()(Composite function) const {
    switch (function) {
      case Composite::kInverse:
        return Power(arguments[0], "-1");
      case Composite::kTranspose:
        return Power(arguments[0], "\\top");
      case Composite::kMean:
      case Composite::kNormalize:
      case Composite::kRotate:
      case Composite::kRoll:
      case Composite::kPitch:
      case Composite::kYaw:
      case Composite::kAngleBetween:
      case Composite::kWrap:
      case Composite::kTolerance:
        return CalledByName(name, arguments);
    }
    std::abort();
  }

  std::string_view name;
  const Arguments& arguments;
};

bool Takes(const BuiltinDescription& builtin, size_t count) {
  return builtin.min_arguments <= count && count <= builtin.max_arguments;
}

}  // namespace

Formula CallFormula(std::string_view function, const Arguments& arguments) {
  const BuiltinDescription* builtin = FindBuiltin(function);
  // What comes here need not be checked.
  if (builtin == nullptr || !Takes(*builtin, arguments.size())) {
    return CalledByName(function, arguments);
  }
  return std::visit(BuiltinFormula{function, arguments}, builtin->function);
}

}  // namespace compiler
