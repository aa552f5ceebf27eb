#include "compiler/emit/builtin_emission.h"

#include <cstdlib>

namespace compiler {

Emission EmissionOf(Builtin function) {
  using enum Chain::Term;
  using enum Chain::Join;
  using enum Chain::Finish;
  switch (function) {
    case Builtin::kAny:
      return Chain{.join = kOr};
    case Builtin::kAll:
      return Chain{.join = kAnd};
    case Builtin::kNone:
      return Chain{.join = kOr, .finish = kNot};
    case Builtin::kCount:
      return Chain{.join = kSum, .term = kCount};
    case Builtin::kSum:
      return Chain{.join = kSum};
    case Builtin::kNorm:
      return Chain{.join = kSum, .term = kSquare, .finish = kSquareRoot};
    case Builtin::kDot:
      return Chain{.join = kSum, .term = kProduct};
    case Builtin::kMin:
      return Chain{.join = kMin, .joins_arguments = true};
    case Builtin::kMax:
      return Chain{.join = kMax, .joins_arguments = true};
    case Builtin::kAbs:
      return CompilerFunction{"__builtin_fabs", Helper::kAbsInt};
    case Builtin::kSqrt:
      return CompilerFunction{"__builtin_sqrt"};
    case Builtin::kFloor:
      return CompilerFunction{"__builtin_floor"};
    case Builtin::kCeil:
      return CompilerFunction{"__builtin_ceil"};
    case Builtin::kRound:
      return CompilerFunction{"__builtin_round"};
    case Builtin::kExp:
      return HelperFunction{Helper::kExp};
    case Builtin::kLog:
      return HelperFunction{Helper::kLog};
    case Builtin::kTanh:
      return HelperFunction{Helper::kTanh};
    case Builtin::kSin:
      return HelperFunction{Helper::kSin};
    case Builtin::kCos:
      return HelperFunction{Helper::kCos};
    case Builtin::kAtan2:
      return HelperFunction{Helper::kAtan2};
    case Builtin::kTan:
      return HelperFunction{Helper::kTan};
    case Builtin::kAsin:
      return HelperFunction{Helper::kAsin};
    case Builtin::kAcos:
      return HelperFunction{Helper::kAcos};
    case Builtin::kAtan:
      return HelperFunction{Helper::kAtan};
    case Builtin::kPow:
      return HelperFunction{Helper::kPow};
    case Builtin::kSign:
      return HelperFunction{Helper::kSign, Helper::kSignInt};
    case Builtin::kClamp:
      return WrittenOut::kClamp;
    case Builtin::kCross:
      return WrittenOut::kCross;
    case Builtin::kSelect:
      return WrittenOut::kSelect;
    case Builtin::kVector:
      return WrittenOut::kVector;
  }
  std::abort();
}

}  // namespace compiler
