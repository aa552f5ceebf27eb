#include "compiler/syntax/spacing.h"

namespace compiler {
namespace {

bool IsBracketOpen(TokenRole role) {
  return role == TokenRole::kCallOpen || role == TokenRole::kGroupOpen ||
         role == TokenRole::kIndexOpen || role == TokenRole::kUnitOpen ||
         role == TokenRole::kSetOpen;
}

// What holds both its neighbors.
bool IsTight(TokenRole role) {
  return role == TokenRole::kDot || role == TokenRole::kPower || role == TokenRole::kRange ||
         role == TokenRole::kUnitOperator;
}

// What holds to the token on its left.
bool FollowsTightly(TokenRole role) {
  return IsTight(role) || role == TokenRole::kComma || role == TokenRole::kColon ||
         role == TokenRole::kCallOpen || role == TokenRole::kIndexOpen ||
         role == TokenRole::kBracketClose;
}

}  // namespace

bool IsSpaced(TokenRole left, TokenRole right) {
  if (left == TokenRole::kBlockOpen && right == TokenRole::kBlockClose) return false;
  return !IsBracketOpen(left) && !IsTight(left) && left != TokenRole::kSign &&
         !FollowsTightly(right);
}

bool MayBreak(TokenRole left, TokenRole right) {
  return IsSpaced(left, right) || IsBracketOpen(left) || right == TokenRole::kBracketClose;
}

}  // namespace compiler
