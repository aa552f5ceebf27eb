// Texts in which `|` marks the cursor.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace compiler {

struct MarkedText {
  explicit MarkedText(std::string marked) : text(std::move(marked)) {
    const size_t place = text.find('|');
    EXPECT_NE(place, std::string::npos) << "no cursor in " << text;
    offset = static_cast<uint32_t>(place);
    text.erase(place, 1);
  }

  std::string text;
  uint32_t offset = 0;
};

}  // namespace compiler
