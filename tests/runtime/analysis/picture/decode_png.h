#pragma once

#include <string>

#include "runtime/analysis/picture/image.h"

namespace runtime {

// The pixels of a PNG file, read by libpng.
Image DecodePng(const std::string& file);

}  // namespace runtime
