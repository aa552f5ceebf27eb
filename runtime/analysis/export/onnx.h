// A learned policy as a model of ONNX (opset 13).
#pragma once

#include <string>

#include "runtime/analysis/export/policy.h"

namespace runtime {

// The bytes of an .onnx file. Its input `observation` has the shape [batch, numbers observed], its
// outputs, such as `joint_targets`, have [batch, their numbers]; all are floats. The model's
// metadata: the facts, "decisions_per_second", and JSON: "observation" is [{"name", "unit", "mean",
// "deviation"}], one for each number in its order, with the last two where the model measures what
// is observed by them; each output's name is [{"name", "unit"}].
std::string OnnxOf(const ExportedPolicy& policy);

}  // namespace runtime
