#pragma once

#include "base/text/suggestion.h"

namespace runtime {

using text::Suggestion;

}  // namespace runtime
