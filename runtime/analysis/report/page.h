// The HTML page, put together from the parts that web/ builds and the data it shows.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace runtime {

// share/taskc/NAME beside the running program's folder; "report", "live", "runs", "study" and
// "probe" are there.
std::filesystem::path PageFolder(std::string_view name);

// template.html of `folder` with page.css, page.js and `data` in it; data.title is the title,
// data.nonce, where the template has one, an attribute.
// Throws UserError where one of these files cannot be read.
std::string MakePage(const nlohmann::json& data, const std::filesystem::path& folder);

// Makes or replaces `file`, whole or not at all. Throws UserError.
void WritePage(const std::filesystem::path& file, const std::string& page);

// `data` as ASCII text that can stand inside <script>, whatever its strings hold: neither end tags
// nor comments nor line separators. Bytes that are not UTF-8 become U+FFFD.
std::string JsonForScript(const nlohmann::json& data);

}  // namespace runtime
