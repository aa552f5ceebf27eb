// What an HTTP request asks for, and how the response is written.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "runtime/live/control/request.h"
#include "runtime/live/server/server.h"

namespace runtime {

// The parts of an HTTP request that decide what is done.
struct HttpRequest {
  std::string_view method;  // "POST"
  std::string_view target;  // "/api/get?name=task.weight"
  std::string_view body;    // JSON object of arguments; "": none
};

// A text that is made for browsers.
struct PageRoute {
  Page page;
  std::string run;  // which, where the server has many; ""
};
// A WebSocket: events as they happen, what is seen of the robot, or a language server.
enum class StreamRoute { kEvents, kView, kLanguage };
using Route = std::variant<PageRoute, StreamRoute, Request>;

// The arguments of a Request, one of the `commands`, are checked. Throws HttpError.
Route ReadRoute(const HttpRequest& request, std::span<const CommandSpec> commands);

// Whether a browser asks for it by its address alone, so that the token stands there.
bool IsForBrowser(std::string_view target);

// The value of `name` in the query of `target`; "" where there is none.
std::string QueryValue(std::string_view target, std::string_view name);

struct HttpResponse {
  unsigned status = 200;
  const char* type = "";  // "text/html"
  std::string body;
  std::string policy = {};  // Content-Security-Policy; "": the page has its own
};

// `host`: of the request. Throws what `maker` throws.
HttpResponse MakePage(const PageMaker& maker, const PageRoute& route, std::string_view host);

HttpResponse ResponseOf(const Reply& reply);
HttpResponse ResponseOf(unsigned status, const std::string& error);

}  // namespace runtime
