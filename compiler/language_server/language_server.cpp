#include "compiler/language_server/language_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/format/format.h"
#include "compiler/language_server/code_actions.h"
#include "compiler/language_server/completion.h"
#include "compiler/language_server/document_symbols.h"
#include "compiler/language_server/hover.h"
#include "compiler/language_server/message_stream.h"
#include "compiler/language_server/navigation.h"
#include "compiler/language_server/page_of_task.h"
#include "compiler/language_server/published_diagnostics.h"
#include "compiler/language_server/signature_help.h"
#include "compiler/language_server/uri.h"
#include "compiler/language_server/worth_of_lets.h"

namespace compiler {
namespace {

using protocol::Json;

constexpr int kIncremental = 2;

// An answer that says why there is none.
struct RequestError : std::exception {
  RequestError(int request_code, std::string request_message)
      : code(request_code), message(std::move(request_message)) {}
  const char* what() const noexcept override { return message.c_str(); }

  int code;
  std::string message;
};

Json ErrorResponse(const Json& id, int code, const std::string& message) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}};
}

Json Notification(const std::string& method, Json params) {
  return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

PositionEncoding AgreedEncoding(const Json& params) {
  const Json offered =
      params.value(Json::json_pointer("/capabilities/general/positionEncodings"), Json::array());
  const bool has_utf8 = std::ranges::find(offered, Json("utf-8")) != offered.end();
  return has_utf8 ? PositionEncoding::kUtf8 : PositionEncoding::kUtf16;
}

std::vector<std::filesystem::path> FoldersIn(const Json& params) {
  std::vector<std::filesystem::path> folders;
  const auto add = [&](const Json& uri) {
    if (!uri.is_string()) return;
    if (const auto path = PathOfUri(uri.get<std::string>())) folders.push_back(*path);
  };
  if (params.contains("workspaceFolders") && params["workspaceFolders"].is_array()) {
    for (const Json& folder : params["workspaceFolders"]) add(folder.value("uri", Json()));
  }
  if (folders.empty() && params.contains("rootUri")) add(params["rootUri"]);
  return folders;
}

// Dumping never fails, whatever bytes the files hold.
std::string Dump(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

LanguageServer::LanguageServer(Options options)
    : options_(std::move(options)), workspace_(options_.robots) {}

const std::map<std::string, LanguageServer::RequestHandler>& LanguageServer::Requests() {
  static const std::map<std::string, RequestHandler> requests = {
      {"initialize", &LanguageServer::Initialize},
      {"shutdown", &LanguageServer::Shutdown},
      {"textDocument/hover", &LanguageServer::HoverAt},
      {"textDocument/completion", &LanguageServer::CompleteAt},
      {"textDocument/definition", &LanguageServer::DefinitionAt},
      {"textDocument/references", &LanguageServer::ReferencesAt},
      {"textDocument/documentHighlight", &LanguageServer::HighlightsAt},
      {"textDocument/prepareRename", &LanguageServer::PrepareRenameAt},
      {"textDocument/rename", &LanguageServer::RenameAt},
      {"textDocument/codeAction", &LanguageServer::ActionsAt},
      {"textDocument/formatting", &LanguageServer::FormatAll},
      {"textDocument/signatureHelp", &LanguageServer::SignatureAt},
      {"textDocument/documentSymbol", &LanguageServer::SymbolsOf},
      {"task/page", &LanguageServer::ShowPage},
      {"task/lets", &LanguageServer::ShowLets}};
  return requests;
}

const std::map<std::string, LanguageServer::NotificationHandler>& LanguageServer::Notifications() {
  static const std::map<std::string, NotificationHandler> notifications = {
      {"initialized", &LanguageServer::Initialized},
      {"exit", &LanguageServer::Exit},
      {"textDocument/didOpen", &LanguageServer::Opened},
      {"textDocument/didChange", &LanguageServer::Changed},
      {"textDocument/didClose", &LanguageServer::Closed},
      {"textDocument/didSave", &LanguageServer::FilesChanged},
      {"workspace/didChangeWatchedFiles", &LanguageServer::FilesChanged}};
  return notifications;
}

// ---- Messages -----------------------------------------------------------------------------------

std::vector<Json> LanguageServer::Receive(const std::string& message) {
  const Json request = Json::parse(message, nullptr, false);
  if (request.is_discarded()) {
    return {ErrorResponse(nullptr, protocol::kParseError, "the message is not JSON")};
  }
  const bool has_method = request.is_object() && request.contains("method");
  if (has_method && !request.contains("id")) {
    Notify(request["method"].is_string() ? request["method"].get<std::string>() : "",
           request.value("params", Json::object()));
    return {};
  }
  if (request.is_object() && !has_method && request.contains("id")) return {};  // an answer
  return {Answer(request)};
}

Json LanguageServer::Answer(const Json& request) {
  Json id = nullptr;
  try {
    if (!request.is_object() || !request.contains("method") || !request["method"].is_string()) {
      throw RequestError(protocol::kInvalidRequest, "a request has a method");
    }
    id = request["id"];
    Json result =
        Dispatch(request["method"].get<std::string>(), request.value("params", Json::object()));
    return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
  } catch (const RequestError& error) {
    return ErrorResponse(id, error.code, error.message);
  } catch (const Json::exception& error) {
    return ErrorResponse(id, protocol::kInvalidParams, error.what());
  } catch (const std::exception& error) {
    return ErrorResponse(id, protocol::kInternalError, error.what());
  }
}

Json LanguageServer::Dispatch(const std::string& method, const Json& params) {
  const auto found = Requests().find(method);
  if (found == Requests().end()) {
    throw RequestError(protocol::kMethodNotFound, fmt::format("there is no method `{}`", method));
  }
  if (is_shut_down_) throw RequestError(protocol::kInvalidRequest, "the server is shut down");
  if (!is_initialized_ && method != "initialize") {
    throw RequestError(protocol::kNotInitialized, "the server is not initialized");
  }
  return (this->*found->second)(params);
}

// Whoever sends a notification does not want to hear that it was wrong.
void LanguageServer::Notify(const std::string& method, const Json& params) {
  const auto found = Notifications().find(method);
  if (found == Notifications().end()) return;
  if (!is_initialized_ && method != "exit") return;
  try {
    (this->*found->second)(params);
  } catch (const std::exception&) {
    // The text stays as it was.
  }
}

// ---- Life ---------------------------------------------------------------------------------------

Json LanguageServer::Initialize(const Json& params) {
  if (is_initialized_) {
    throw RequestError(protocol::kInvalidRequest, "the server is initialized already");
  }
  workspace_.encoding = AgreedEncoding(params);
  workspace_.folders = FoldersIn(params);
  is_initialized_ = true;
  const bool is_utf8 = workspace_.encoding == PositionEncoding::kUtf8;
  const Json capabilities = {
      {"positionEncoding", is_utf8 ? "utf-8" : "utf-16"},
      {"textDocumentSync", {{"openClose", true}, {"change", kIncremental}, {"save", true}}},
      {"hoverProvider", true},
      {"completionProvider", {{"triggerCharacters", {".", "[", " ", ":", "\""}}}},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
      {"documentFormattingProvider", true},
      {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
      {"documentSymbolProvider", true}};
  return {{"capabilities", capabilities},
          {"serverInfo", {{"name", "taskc"}, {"version", TASKC_VERSION}}}};
}

Json LanguageServer::Shutdown(const Json&) {
  is_shut_down_ = true;
  return nullptr;
}

void LanguageServer::Initialized(const Json&) {}

void LanguageServer::Exit(const Json&) { has_exited_ = true; }

// ---- Texts --------------------------------------------------------------------------------------

void LanguageServer::Opened(const Json& params) {
  const Json& item = params.at("textDocument");
  workspace_.Open(item.at("uri").get<std::string>(), item.at("text").get<std::string>(),
                  item.value("version", int64_t{0}));
  has_changed_ = true;
}

void LanguageServer::Changed(const Json& params) {
  const Document& document = DocumentIn(params);
  const std::string uri = document.uri();
  std::string text = document.text();
  for (const Json& change : params.at("contentChanges")) {
    std::string added = change.at("text").get<std::string>();
    if (!change.contains("range")) {
      text = std::move(added);
      continue;
    }
    const TextPositions positions(text, workspace_.encoding);
    const uint32_t begin = positions.OffsetOf(protocol::PositionFrom(change["range"].at("start")));
    const uint32_t end = positions.OffsetOf(protocol::PositionFrom(change["range"].at("end")));
    text.replace(begin, std::max(begin, end) - begin, added);
  }
  workspace_.Change(uri, std::move(text),
                    params.at("textDocument").value("version", document.version()));
  has_changed_ = true;
}

void LanguageServer::Closed(const Json& params) {
  workspace_.Close(params.at("textDocument").at("uri").get<std::string>());
  has_changed_ = true;
}

void LanguageServer::FilesChanged(const Json&) {
  workspace_.Forget();
  has_changed_ = true;
}

std::map<std::string, Json> LanguageServer::AllDiagnostics() {
  std::map<std::string, Json> diagnostics_of;
  for (const Document* document : workspace_.documents()) {
    const Findings& findings = workspace_.FindingsOf(*document);
    for (auto& [file, diagnostics] :
         DiagnosticsByUri(findings, options_.diagnostics_page, workspace_.encoding)) {
      // The editor knows an open file by the name that it gave it.
      const bool is_own = file == UriOfPath(document->path());
      const std::string& uri = is_own ? document->uri() : file;
      Json& all = diagnostics_of.try_emplace(uri, Json::array()).first->second;
      for (Json& diagnostic : diagnostics) {
        if (std::ranges::find(all, diagnostic) == all.end()) all.push_back(std::move(diagnostic));
      }
    }
  }
  return diagnostics_of;
}

std::vector<Json> LanguageServer::Report() {
  if (!std::exchange(has_changed_, false)) return {};
  std::map<std::string, Json> wanted = AllDiagnostics();
  for (const auto& [uri, diagnostics] : shown_) wanted.try_emplace(uri, Json::array());
  std::vector<Json> messages;
  for (const auto& [uri, diagnostics] : wanted) {
    const auto shown = shown_.find(uri);
    const Document* document = workspace_.Find(uri);
    if (shown != shown_.end() && shown->second == diagnostics && document == nullptr) continue;
    Json params{{"uri", uri}, {"diagnostics", diagnostics}};
    if (document != nullptr) params["version"] = document->version();
    messages.push_back(Notification("textDocument/publishDiagnostics", std::move(params)));
  }
  std::erase_if(wanted, [](const auto& entry) { return entry.second.empty(); });
  shown_ = std::move(wanted);
  return messages;
}

const Document& LanguageServer::DocumentIn(const Json& params) const {
  const std::string uri = params.at("textDocument").at("uri").get<std::string>();
  const Document* document = workspace_.Find(uri);
  if (document == nullptr) {
    throw RequestError(protocol::kInvalidParams, fmt::format("`{}` is not open", uri));
  }
  return *document;
}

uint32_t LanguageServer::OffsetIn(const Document& document, const Json& params) {
  return document.positions().OffsetOf(protocol::PositionFrom(params.at("position")));
}

// ---- Questions ----------------------------------------------------------------------------------

Json LanguageServer::HoverAt(const Json& params) {
  const Document& document = DocumentIn(params);
  return Hover(document, OffsetIn(document, params), workspace_);
}

Json LanguageServer::CompleteAt(const Json& params) {
  const Document& document = DocumentIn(params);
  return Complete(document, OffsetIn(document, params), workspace_);
}

Json LanguageServer::DefinitionAt(const Json& params) {
  const Document& document = DocumentIn(params);
  return Definition(document, OffsetIn(document, params), workspace_);
}

Json LanguageServer::ReferencesAt(const Json& params) {
  const Document& document = DocumentIn(params);
  const bool with_declaration =
      params.value(Json::json_pointer("/context/includeDeclaration"), true);
  return FindReferences(document, OffsetIn(document, params), with_declaration, workspace_);
}

Json LanguageServer::HighlightsAt(const Json& params) {
  const Document& document = DocumentIn(params);
  return Highlights(document, OffsetIn(document, params), workspace_);
}

Json LanguageServer::PrepareRenameAt(const Json& params) {
  const Document& document = DocumentIn(params);
  return PrepareRename(document, OffsetIn(document, params), workspace_);
}

Json LanguageServer::RenameAt(const Json& params) {
  const Document& document = DocumentIn(params);
  RenameResult result = Rename(document, OffsetIn(document, params),
                               params.at("newName").get<std::string>(), workspace_);
  if (result.edit.is_null()) throw RequestError(protocol::kRequestFailed, result.refusal);
  return std::move(result.edit);
}

// What is shown may be out of date, so the present text is asked.
Json LanguageServer::ActionsAt(const Json& params) {
  const std::string uri = DocumentIn(params).uri();
  return CodeActions(AllDiagnostics()[uri], uri, params);
}

// The whole text, unless nothing changes. A text with syntax errors is not touched.
Json LanguageServer::FormatAll(const Json& params) {
  const Document& document = DocumentIn(params);
  Diagnostics ignored;
  const auto formatted = Format(SourceFile(document.path().string(), document.text()), ignored);
  if (!formatted || *formatted == document.text()) return Json::array();
  const Span whole{0, static_cast<uint32_t>(document.text().size())};
  return Json::array(
      {{{"range", protocol::ToJson(document.positions(), whole)}, {"newText", *formatted}}});
}

Json LanguageServer::SignatureAt(const Json& params) {
  const Document& document = DocumentIn(params);
  return SignatureHelp(document, OffsetIn(document, params), workspace_);
}

Json LanguageServer::SymbolsOf(const Json& params) { return DocumentSymbols(DocumentIn(params)); }

// Not of the protocol.
Json LanguageServer::ShowPage(const Json& params) {
  return PageOfTask(workspace_.FindingsOf(DocumentIn(params)).analysis);
}

Json LanguageServer::ShowLets(const Json& params) {
  return WorthOfLets(workspace_.FindingsOf(DocumentIn(params)).analysis, params.at("known"));
}

// ---- The stream ---------------------------------------------------------------------------------

int Serve(LanguageServer& server, std::istream& in, std::ostream& out) {
  while (!server.has_exited()) {
    const auto message = ReadMessage(in);
    if (!message) return 1;
    for (const Json& answer : server.Receive(*message)) WriteMessage(out, Dump(answer));
    // While more is waiting, what would be reported is out of date already.
    if (in.rdbuf()->in_avail() > 0) continue;
    for (const Json& report : server.Report()) WriteMessage(out, Dump(report));
  }
  return server.exit_status();
}

}  // namespace compiler
