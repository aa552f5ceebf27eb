// A compiled task in memory, as the trainer knows it.
#pragma once

#include <filesystem>

#include "plugins/host/plugin.h"

namespace runtime {

// What every host has, with mistakes as those of the trainer's user.
class Plugin : public host::Plugin {
 public:
  // Throws UserError for what host::Plugin refuses.
  explicit Plugin(const std::filesystem::path& file, const std::filesystem::path& name = {});
};

}  // namespace runtime
