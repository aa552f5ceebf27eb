#include "base/command_line/choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace command_line {

CLI::Option* AddChoice(CLI::App& app, const std::string& option, std::string& value,
                       const std::vector<std::string>& words, const std::string& description) {
  return app.add_option(option, value, description)
      ->type_name(fmt::format("{}", fmt::join(words, "|")))
      ->check(CLI::IsMember(words).description(""));
}

}  // namespace command_line
