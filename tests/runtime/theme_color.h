// A color of the pages' light theme, which comes first in its file, as 0xrrggbb.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/training/run/run_files.h"

namespace runtime {

inline uint32_t ThemeColor(const std::string& name) {
  const std::string text = ReadText(SOURCE_DIR "/web/src/style/theme.css");
  const std::string begin = "--" + name + ": #";
  const size_t at = text.find(begin);
  if (at == std::string::npos) return 0;
  return static_cast<uint32_t>(std::stoul(text.substr(at + begin.size(), 6), nullptr, 16));
}

}  // namespace runtime
