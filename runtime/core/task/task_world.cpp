#include "runtime/core/task/task_world.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "runtime/base/user_error.h"

namespace runtime {
namespace {

std::span<const taskc_source> SourcesOf(const taskc_plugin& table) {
  return {table.sources, table.source_count};
}

}  // namespace

std::unique_ptr<const world::WorldDescription> WorldOf(const taskc_plugin& table) {
  const auto read = [&](const std::filesystem::path& path) -> std::optional<std::string> {
    for (const taskc_source& source : SourcesOf(table))
      if (path == source.file) return source.text;
    return std::nullopt;
  };
  for (const taskc_source& source : SourcesOf(table)) {
    if (!std::string_view(source.file).ends_with(world::kWorldEnding)) continue;
    try {
      return std::make_unique<const world::WorldDescription>(
          world::ReadWorld(source.text, source.file, read));
    } catch (const robot::DescriptionError& error) {
      throw UserError(error.what());
    }
  }
  return nullptr;
}

}  // namespace runtime
