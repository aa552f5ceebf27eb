// The small functions that emitted code calls; a plugin contains those that it needs.
#pragma once

#include <bitset>
#include <string_view>

namespace compiler {

enum class Helper {
  // Of the C library.
  kExp,
  kLog,
  kTanh,
  kSin,
  kCos,
  kTan,
  kAsin,
  kAcos,
  kAtan,
  kPow,
  kAtan2,
  // Written out.
  kMin,
  kMax,
  kMinInt,
  kMaxInt,
  kSign,
  kSignInt,
  kAbsInt,
  kPay,
  kEnd,
  kNote,
  kRequire,
  kDrawPlace,
  kRandomUnit,
  kUniform,
  kNormal,
  kChoose,
  kApproach,
  kLag,
  kTable,
  kInFirstRound,
  kFindPlace,
  kBetween,
  kReadTable,
  kReadHeld,
  kReadRotations,
  kLastGrowth,
  kCount
};
inline constexpr int kHelperCount = static_cast<int>(Helper::kCount);

// The name by which emitted code calls the function.
std::string_view HelperName(Helper helper);

// Its definition or declaration, in C++.
std::string_view HelperText(Helper helper);

// Whether it is a declaration of a function of the C library.
inline bool IsOfLibrary(Helper helper) { return helper <= Helper::kAtan2; }

// Which of them a plugin calls.
class HelperSet {
 public:
  // Notes that `helper` is called; its name.
  std::string_view Use(Helper helper) {
    used_.set(static_cast<size_t>(helper));
    return HelperName(helper);
  }
  bool Has(Helper helper) const { return used_.test(static_cast<size_t>(helper)); }

 private:
  std::bitset<kHelperCount> used_;
};

}  // namespace compiler
