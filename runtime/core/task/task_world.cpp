#include "runtime/core/task/task_world.h"

#include <span>
#include <utility>

#include "runtime/base/user_error.h"

namespace runtime {
std::unique_ptr<const world::WorldDescription> WorldOf(const taskc_plugin& table) {
  try {
    auto found = world::WorldIn(std::span(table.sources, table.source_count));
    if (!found) return nullptr;
    return std::make_unique<const world::WorldDescription>(*std::move(found));
  } catch (const robot::DescriptionError& error) {
    throw UserError(error.what());
  }
}

}  // namespace runtime
