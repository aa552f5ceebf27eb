// taskc doc FILE.task
#include <fmt/format.h>

#include <memory>

#include "base/text/print.h"
#include "compiler/document/task_json.h"
#include "compiler/document/task_page.h"
#include "compiler/driver/verb.h"
#include "compiler/toolchain/file_io.h"
#include "compiler/toolchain/share_folder.h"

namespace compiler {
namespace {

struct DocOptions {
  std::string task;
  std::filesystem::path output;  // empty: Markdown on the standard output
  bool is_json = false;          // instead of a page
};

ExitStatus WritePage(const DocOptions& options, Session& session) {
  const std::filesystem::path kind = options.output.extension();
  if (!options.output.empty() && kind != ".md" && kind != ".html") {
    throw CallError(
        fmt::format("cannot write `{}`: a page is a .md or .html file", options.output.string()));
  }
  const Analysis analysis = session.Analyze(options.task);
  if (!analysis.task) return ExitStatus::kWrongTask;
  if (options.is_json) {
    text::Print("{}", ToText(ToJson(analysis)));
    return ExitStatus::kOk;
  }
  const Page page = PageOf(analysis);
  if (options.output.empty()) {
    text::Print("{}", ToMarkdown(page));
  } else if (kind == ".md") {
    ReplaceFile(options.output, ToMarkdown(page));
  } else {
    ReplaceFile(options.output, ToHtml(page, ReadShareFile("document/template.html")));
  }
  return ExitStatus::kOk;
}

}  // namespace

Action DeclareDoc(Command& command, Session& session) {
  auto options = std::make_shared<DocOptions>();
  AddTask(command, options->task);
  Option output = AddOutput(command, options->output, "FILE.md|FILE.html",
                            "where to write the page; otherwise Markdown is printed");
  command.AddFlag("--json", options->is_json, "print params, terms and metrics as JSON instead")
      .Excludes(output);
  AddRobots(command, session);
  AddText(command, session);
  return [options](Session& call) { return WritePage(*options, call); };
}

}  // namespace compiler
