#include "plugins/robot/placed_error.h"

#include <fmt/format.h>

namespace robot {

PlacedError::PlacedError(const std::string& file, uint32_t line, uint32_t column,
                         std::string_view message, std::string_view help)
    : DescriptionError(
          fmt::format("{}:{}:{}: error: {}\n  help: {}", file, line, column, message, help)),
      line_(line),
      column_(column),
      message_(message),
      help_(help) {}

}  // namespace robot
