// A look at a shared object before the dynamic loader sees it: the loader maps what the headers
// promise, and a file that was cut off kills the whole program with SIGBUS.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace host {

// What makes `content` something other than a whole shared object for this machine, as the
// predicate of a sentence about the file ("is cut off: ..."); nothing if it is one. Reads nothing
// outside `content`, whatever stands there.
std::optional<std::string> ElfDefect(std::span<const std::byte> content);

// What the compiler of a shared object without a defect has written about itself: "GCC: (Debian
// 12.2.0-14) 12.2.0". "" where it says nothing.
std::string ElfCompiler(std::span<const std::byte> content);

}  // namespace host
