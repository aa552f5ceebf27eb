// The editor's server: it answers what an editor asks of task files by the Language Server
// Protocol.
#pragma once

#include <filesystem>
#include <istream>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "compiler/language_server/protocol.h"
#include "compiler/language_server/workspace.h"

namespace compiler {

class LanguageServer {
 public:
  struct Options {
    std::filesystem::path robots;            // where to look for robots first; may be empty
    std::filesystem::path diagnostics_page;  // explains the codes; may be empty
  };
  explicit LanguageServer(Options options);

  // What is answered to a message. Whatever it holds, nothing is thrown.
  std::vector<protocol::Json> Receive(const std::string& message);
  // What is to be said without being asked: the diagnostics of files that have changed since.
  std::vector<protocol::Json> Report();

  bool has_exited() const { return has_exited_; }
  // 0 where the editor has said in time that it will leave.
  int exit_status() const { return is_shut_down_ ? 0 : 1; }

 private:
  using Json = protocol::Json;
  using RequestHandler = Json (LanguageServer::*)(const Json& params);
  using NotificationHandler = void (LanguageServer::*)(const Json& params);
  static const std::map<std::string, RequestHandler>& Requests();
  static const std::map<std::string, NotificationHandler>& Notifications();

  Json Answer(const Json& request);
  Json Dispatch(const std::string& method, const Json& params);
  void Notify(const std::string& method, const Json& params);

  Json Initialize(const Json& params);
  Json Shutdown(const Json& params);
  Json HoverAt(const Json& params);
  Json CompleteAt(const Json& params);
  Json DefinitionAt(const Json& params);
  Json ReferencesAt(const Json& params);
  Json HighlightsAt(const Json& params);
  Json PrepareRenameAt(const Json& params);
  Json RenameAt(const Json& params);
  Json ActionsAt(const Json& params);
  Json FormatAll(const Json& params);
  Json SignatureAt(const Json& params);
  Json SymbolsOf(const Json& params);
  Json ShowPage(const Json& params);
  Json ShowLets(const Json& params);

  void Initialized(const Json& params);
  void Exit(const Json& params);
  void Opened(const Json& params);
  void Changed(const Json& params);
  void Closed(const Json& params);
  void FilesChanged(const Json& params);

  // What is wrong in all open files and what these are made of, by file.
  std::map<std::string, Json> AllDiagnostics();

  const Document& DocumentIn(const Json& params) const;
  static uint32_t OffsetIn(const Document& document, const Json& params);

  Options options_;
  Workspace workspace_;
  bool is_initialized_ = false;
  bool is_shut_down_ = false;
  bool has_exited_ = false;
  bool has_changed_ = false;           // since the last report
  std::map<std::string, Json> shown_;  // the diagnostics that the editor shows now, by file
};

// Serves until the editor leaves or closes the stream. The process's exit status.
int Serve(LanguageServer& server, std::istream& in, std::ostream& out);

}  // namespace compiler
