#include "runtime/live/server/api.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "runtime/live/server/control_file.h"
#include "runtime/live/server/http_error.h"

namespace runtime {
namespace {

using nlohmann::json;

constexpr std::string_view kApi = "/api/";
constexpr const char* kJson = "application/json";
constexpr const char* kHtml = "text/html; charset=utf-8";
constexpr int kMaxDepth = 16;  // no argument needs more, and what writes JSON is recursive

std::string_view PathOf(std::string_view target) { return target.substr(0, target.find('?')); }

// "a+b%20c" is "a b c".
std::string Decode(std::string_view text) {
  std::string decoded;
  for (size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = static_cast<unsigned char>(text[i] == '+' ? ' ' : text[i]);
    if (text[i] == '%') {
      const std::string_view digits = text.substr(i + 1, 2);
      const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16).ptr;
      if (digits.size() < 2 || end != digits.data() + 2) {
        throw HttpError(400, "a `%` in the address must be followed by two hexadecimal digits");
      }
      i += 2;
    }
    decoded += static_cast<char>(byte);
  }
  return decoded;
}

// The arguments of a request that only looks may stand in its address: all are texts.
json QueryArguments(std::string_view target) {
  json arguments = json::object();
  const size_t begin = target.find('?');
  if (begin == std::string_view::npos) return arguments;
  for (std::string_view rest = target.substr(begin + 1); !rest.empty();) {
    const std::string_view pair = rest.substr(0, rest.find('&'));
    rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
    const size_t equals = pair.find('=');
    if (equals == std::string_view::npos) {
      throw HttpError(400, fmt::format("write `{}=VALUE` in the address", pair));
    }
    arguments[Decode(pair.substr(0, equals))] = Decode(pair.substr(equals + 1));
  }
  return arguments;
}

json ParseArguments(std::string_view text) {
  if (text.empty()) return json::object();
  const auto check_depth = [](int depth, json::parse_event_t, json&) {
    if (depth > kMaxDepth) throw HttpError(400, "the JSON is nested too deeply");
    return true;
  };
  try {
    return json::parse(text, check_depth);
  } catch (const json::exception& error) {
    throw HttpError(400, fmt::format("the arguments are not JSON: {}", error.what()));
  }
}

const CommandSpec& CommandAt(std::string_view path, std::span<const CommandSpec> commands) {
  try {
    return FindCommand(commands, path.substr(kApi.size()));
  } catch (const UserError& error) {
    throw HttpError(404, error.what());
  }
}

Request ReadRequest(const HttpRequest& http, std::span<const CommandSpec> commands) {
  const CommandSpec& command = CommandAt(PathOf(http.target), commands);
  const bool is_get = http.method == "GET";
  if (http.method != "POST" && (!is_get || command.changes())) {
    throw HttpError(
        405, fmt::format("`{}` takes POST{}", command.name, command.changes() ? "" : " or GET"));
  }
  Request request = {command.name,
                     is_get ? QueryArguments(http.target) : ParseArguments(http.body)};
  try {
    CheckArguments(command, request.arguments);
  } catch (const UserError& error) {
    throw HttpError(400, error.what());
  }
  return request;
}

void CheckIsGet(const HttpRequest& request) {
  if (request.method == "GET") return;
  throw HttpError(405, fmt::format("`{}` takes GET", PathOf(request.target)));
}

// Scripts and styles are the page's own, and it talks to its trainer only.
std::string PolicyOf(std::string_view nonce, std::string_view host) {
  return fmt::format(
      "default-src 'none'; script-src 'nonce-{0}'; style-src 'nonce-{0}'; img-src data: blob:; "
      "font-src data:; connect-src 'self' ws://{1}; base-uri 'none'; form-action 'none'; "
      "frame-ancestors 'none'",
      nonce, host);
}

// What is no command.
struct SpecialPath {
  std::string_view path;
  Route route;
  bool is_for_browser;
};

const SpecialPath* FindSpecial(std::string_view path) {
  static const SpecialPath kPaths[] = {
      {"/", PageRoute{Page::kLive, ""}, true},
      {"/report", PageRoute{Page::kReport, ""}, true},
      {"/api/record", PageRoute{Page::kRecord, ""}, false},
      {"/api/events", StreamRoute::kEvents, true},
      {"/api/view", StreamRoute::kView, true},
      {"/api/language", StreamRoute::kLanguage, true},
  };
  const auto found = std::ranges::find(kPaths, path, &SpecialPath::path);
  return found == std::end(kPaths) ? nullptr : &*found;
}

std::string Text(const json& object) {
  return object.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace

Route ReadRoute(const HttpRequest& request, std::span<const CommandSpec> commands) {
  const std::string_view path = PathOf(request.target);
  if (const SpecialPath* special = FindSpecial(path)) {
    CheckIsGet(request);
    Route route = special->route;
    if (auto* page = std::get_if<PageRoute>(&route)) page->run = QueryValue(request.target, "run");
    return route;
  }
  if (path.starts_with(kApi)) return ReadRequest(request, commands);
  throw HttpError(404, fmt::format("there is nothing at `{}`; commands are at /api/COMMAND, the "
                                   "run's page at /",
                                   path));
}

bool IsForBrowser(std::string_view target) {
  const size_t begin = target.find('?');
  if (begin == std::string_view::npos) return false;
  const SpecialPath* special = FindSpecial(target.substr(0, begin));
  return special != nullptr && special->is_for_browser;
}

std::string QueryValue(std::string_view target, std::string_view name) {
  return QueryArguments(target).value(std::string(name), "");
}

HttpResponse MakePage(const PageMaker& maker, const PageRoute& route, std::string_view host) {
  const auto& [page, run] = route;
  switch (page) {
    case Page::kLive: {
      const std::string nonce = NewToken();
      return {200, kHtml, maker(page, nonce, run), PolicyOf(nonce, host)};
    }
    case Page::kReport:
      return {200, kHtml, maker(page, "", run)};
    case Page::kRecord:
      return {200, kJson, fmt::format("{{\"ok\":true,\"value\":{}}}\n", maker(page, "", run))};
  }
  return {};
}

HttpResponse ResponseOf(const Reply& reply) {
  if (!reply.ok) return ResponseOf(422, reply.error);
  return {200, kJson, Text({{"ok", true}, {"value", reply.value}})};
}

HttpResponse ResponseOf(unsigned status, const std::string& error) {
  return {status, kJson, Text({{"ok", false}, {"error", error}})};
}

}  // namespace runtime
