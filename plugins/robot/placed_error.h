// A mistake in a description file, and where it stands.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "plugins/robot/robot_description.h"

namespace robot {

class PlacedError : public DescriptionError {
 public:
  // Lines and columns count from 1.
  PlacedError(const std::string& file, uint32_t line, uint32_t column, std::string_view message,
              std::string_view help);

  uint32_t line() const { return line_; }
  uint32_t column() const { return column_; }
  const std::string& message() const { return message_; }
  const std::string& help() const { return help_; }

 private:
  uint32_t line_;
  uint32_t column_;
  std::string message_;
  std::string help_;
};

}  // namespace robot
