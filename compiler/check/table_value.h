// What a table says for an argument. Emitted code computes the same, to the last bit.
#pragma once

#include "compiler/check/checked_task.h"
#include "compiler/check/value.h"

namespace compiler {

// Between two rows linearly, of rotations with the length brought back to 1. Before the first and
// after the last row these hold; with `repeats` the last row is the first of the next round.
Reals ValueAt(const CheckedTable& table, double argument, bool repeats);

}  // namespace compiler
