// taskc lsp
#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "compiler/driver/print_error.h"
#include "compiler/driver/verb.h"
#include "compiler/language_server/language_server.h"
#include "compiler/toolchain/share_folder.h"

namespace compiler {
namespace {

ExitStatus ServeEditor(const Session& session) {
  if (isatty(STDIN_FILENO) != 0) {
    PrintError("waiting for messages from an editor on standard input; see docs/editors.md");
  }
  std::ios::sync_with_stdio(false);  // so that what has arrived already is known
  const std::filesystem::path page = ShareFolder() / "diagnostics.md";
  LanguageServer server(
      {.robots = session.robots, .diagnostics_page = std::filesystem::exists(page) ? page : ""});
  return Serve(server, std::cin, std::cout) == 0 ? ExitStatus::kOk : ExitStatus::kWrongTask;
}

}  // namespace

Action DeclareLsp(Command& command, Session& session) {
  // Editors' clients add it to the call; there is no other way to talk.
  command.OnFlag(
      "--stdio", [] {}, "use standard input and output, as it always does");
  AddRobots(command, session);
  return [](Session& call) { return ServeEditor(call); };
}

}  // namespace compiler
