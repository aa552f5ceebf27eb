#pragma once

#include "runtime/analysis/preference/preferences_file.h"

namespace runtime {

// One is better than the other: "seed2" than "seed4:12".
inline Preference Over(const char* better, const char* worse) {
  return {ParseBehaviorName(better), ParseBehaviorName(worse)};
}

}  // namespace runtime
