// The seal of a plugin: its own SHA-256, written behind it, where the dynamic linker does not look.
// A changed byte can crash the linker or the task, so the seal is looked at before anything is
// loaded.
#pragma once

#include <string>
#include <string_view>

namespace seal {

enum class State {
  kAbsent,  // made by other means than taskc; nothing is known against it
  kIntact,
  kBroken,  // cut off or changed since it was sealed
};

// `plugin` with its seal behind it.
std::string Seal(std::string plugin);

State StateOf(std::string_view content);

}  // namespace seal
