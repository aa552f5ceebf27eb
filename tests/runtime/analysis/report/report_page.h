// What a written report says, read back from the file.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace runtime {

// The data of the page.
nlohmann::json DataOfPage(const std::filesystem::path& page);

// The values of a base64 text.
std::vector<float> Floats(const nlohmann::json& text);

}  // namespace runtime
