#pragma once

namespace runtime {

// CPU time of this thread so far [s].
double ThreadSeconds();

}  // namespace runtime
