// The HTML page, put together from the parts that web/ builds and the data it shows.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace runtime {

// share/taskc/report beside the running program's folder.
std::filesystem::path PageFolder();

// template.html of `folder` with report.css, report.js and `data` in it. Throws UserError where one
// of these files cannot be read.
std::string MakePage(const nlohmann::json& data, const std::filesystem::path& folder);

// `data` as ASCII text that can stand inside <script>, whatever its strings hold: neither end tags
// nor comments nor line separators. Bytes that are no UTF-8 become U+FFFD.
std::string JsonForScript(const nlohmann::json& data);

}  // namespace runtime
