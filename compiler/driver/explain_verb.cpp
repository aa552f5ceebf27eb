// taskc explain CODE
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/text/nearest_name.h"
#include "base/text/print.h"
#include "compiler/driver/verb.h"
#include "compiler/toolchain/share_folder.h"

namespace compiler {
namespace {

struct ExplainOptions {
  std::vector<std::string> codes;  // empty: list them all
};

std::vector<std::string> AllCodes() {
  std::vector<std::string> codes;
  for (const DiagnosticKind& kind : kDiagnosticTable) codes.emplace_back(kind.code);
  return codes;
}

// As it is in the table, whichever case it was typed in. Throws CallError.
std::string KnownCode(std::string typed) {
  const std::vector<std::string> codes = AllCodes();
  std::string code = typed;
  std::ranges::transform(code, code.begin(), [](unsigned char c) { return std::toupper(c); });
  if (std::ranges::find(codes, code) != codes.end()) return code;
  const auto nearest = text::NearestName(code, codes);
  throw CallError(fmt::format("there is no code `{}`; {}`taskc explain` lists them all", typed,
                              nearest ? fmt::format("did you mean `{}`? ", *nearest) : ""));
}

// The section of a code, without the signs of Markdown: examples are indented instead.
std::string SectionOf(const std::string& code, const std::string& page) {
  const size_t heading = page.find("\n### " + code + ":");
  if (heading == std::string::npos) {
    throw CallError(fmt::format("`{}` does not describe {}; reinstall taskc",
                                (ShareFolder() / "diagnostics.md").string(), code));
  }
  const size_t begin = heading + std::string_view("\n### ").size();
  const size_t end = page.find("\n##", begin);  // of this or of a higher level
  std::string section;
  bool is_example = false;
  std::istringstream lines(page.substr(begin, end == std::string::npos ? end : end - begin));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      is_example = !is_example;
    } else {
      section += (is_example && !line.empty() ? "    " : "") + line + "\n";
    }
  }
  section.erase(section.find_last_not_of('\n') + 1);
  return section + "\n";
}

ExitStatus Explain(const ExplainOptions& options) {
  if (options.codes.empty()) {
    for (const DiagnosticKind& kind : kDiagnosticTable) {
      text::Print("{}  {}\n", kind.code, kind.title);
    }
    return ExitStatus::kOk;
  }
  const std::string page = ReadShareFile("diagnostics.md");
  for (const std::string& code : options.codes) {
    if (&code != &options.codes.front()) text::Print("\n\n");
    text::Print("{}", SectionOf(KnownCode(code), page));
  }
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareExplain(Command& command, Session&) {
  auto options = std::make_shared<ExplainOptions>();
  command.AddOption("CODE", options->codes, "of errors and warnings; without one, all are listed")
      .ValueName("...");
  return [options](Session&) { return Explain(*options); };
}

}  // namespace compiler
