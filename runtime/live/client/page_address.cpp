#include "runtime/live/client/page_address.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "runtime/base/user_error.h"
#include "runtime/live/client/client.h"

namespace runtime {

std::string PageAddress(const std::filesystem::path& folder) {
  std::ifstream in(folder / "control.json");
  const auto control = nlohmann::json::parse(in, nullptr, false);
  const bool is_whole = control.is_object() && control.contains("url") && control.contains("token");
  if (!is_whole || !HasTrainer(folder)) {
    throw UserError(
        fmt::format("{}: no trainer is running there; start one with `trainer serve {}`",
                    folder.string(), folder.string()));
  }
  return fmt::format("{}?token={}", control["url"].get<std::string>(),
                     control["token"].get<std::string>());
}

}  // namespace runtime
