#pragma once

#include "runtime/analysis/picture/image.h"

namespace runtime {

// Puts what is drawn before the background of the pages, so that no pixel is transparent.
void FillBackground(Image& image);

}  // namespace runtime
