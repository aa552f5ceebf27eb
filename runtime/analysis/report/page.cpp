#include "runtime/analysis/report/page.h"

#include <fmt/format.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string_view>

#include "runtime/base/user_error.h"
#include "runtime/training/run/run_files.h"

namespace runtime {
namespace {

std::string ReadPart(const std::filesystem::path& folder, std::string_view name) {
  const std::filesystem::path file = folder / name;
  std::ifstream in(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in || text.empty()) {
    throw UserError(fmt::format(
        "{}: this part of the report's page is missing; build the target `web` (it needs "
        "Node.js and npm), or reinstall taskc",
        file.string()));
  }
  return text;
}

std::string EscapeHtml(std::string_view text) {
  static const std::map<char, std::string_view> kEscapes = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string escaped;
  for (const char c : text) {
    const auto found = kEscapes.find(c);
    if (found == kEscapes.end()) {
      escaped += c;
    } else {
      escaped += found->second;
    }
  }
  return escaped;
}

using Part = std::function<std::string()>;

// Replaces each {{name}} that `parts` knows. What is put in is not searched again, so that data may
// hold anything.
std::string Fill(std::string_view page_template, const std::map<std::string, Part>& parts) {
  std::string page;
  while (!page_template.empty()) {
    const size_t begin = page_template.find("{{");
    const size_t end = page_template.find("}}", begin);
    page += page_template.substr(0, begin);
    if (end == std::string_view::npos) break;
    const std::string name(page_template.substr(begin + 2, end - begin - 2));
    page += parts.at(name)();
    page_template.remove_prefix(end + 2);
  }
  return page;
}

}  // namespace

std::filesystem::path PageFolder(std::string_view name) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "share/taskc" / name;
}

std::string JsonForScript(const nlohmann::json& data) {
  const std::string text = data.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {  // a '<' of JSON is always inside a string
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string MakePage(const nlohmann::json& data, const std::filesystem::path& folder) {
  return Fill(ReadPart(folder, "template.html"),
              {{"title", [&] { return EscapeHtml(data.at("title").get<std::string>()); }},
               {"nonce", [&] { return EscapeHtml(data.at("nonce").get<std::string>()); }},
               {"style", [&] { return ReadPart(folder, "page.css"); }},
               {"script", [&] { return ReadPart(folder, "page.js"); }},
               {"data", [&] { return JsonForScript(data); }}});
}

void WritePage(const std::filesystem::path& file, const std::string& page) {
  WriteOutput(file, "the report", page);
}

}  // namespace runtime
