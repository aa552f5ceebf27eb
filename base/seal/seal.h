// The seal of a plugin: its own SHA-256, appended to it, where the dynamic linker does not look.
// A changed byte can crash the linker or the task, and the code of a library runs while it is
// loaded, so the seal is checked before. It is not a signature: it says that taskc has built the
// plugin, or that its user has sealed it by `taskc seal`, and that it has not changed since.
#pragma once

#include <string>
#include <string_view>

namespace seal {

enum class State {
  kAbsent,  // made by other means than taskc
  kIntact,
  kBroken,  // cut off or changed since it was sealed
};

// `plugin` with its seal appended.
std::string Seal(std::string plugin);

State StateOf(std::string_view content);

inline constexpr size_t kSize = 79;  // bytes
// Whether the last kSize bytes of a file are a seal, intact or broken.
bool IsSeal(std::string_view end);

}  // namespace seal
