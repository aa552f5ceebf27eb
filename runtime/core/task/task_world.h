// The world that a compiled task is in.
#pragma once

#include <taskc/plugin.h>

#include <memory>

#include "plugins/world/world_description.h"

namespace runtime {

// From the texts that the task is made of: a compiled task needs no file. Null where it names no
// world. Throws UserError where the text is damaged.
std::unique_ptr<const world::WorldDescription> WorldOf(const taskc_plugin& table);

}  // namespace runtime
