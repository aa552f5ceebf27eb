// What an HTTP request asks for, and how the response is written.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "runtime/live/control/request.h"

namespace runtime {

// The parts of an HTTP request that decide what is done.
struct HttpRequest {
  std::string_view method;  // "POST"
  std::string_view target;  // "/api/get?name=task.weight"
  std::string_view body;    // JSON object of arguments; "": none
};

struct PageRoute {};    // the run's report page
struct EventsRoute {};  // a stream of events
using Route = std::variant<PageRoute, EventsRoute, Request>;

// The arguments of a Request are checked. Throws HttpError.
Route ReadRoute(const HttpRequest& request);

// The value of `name` in the query of `target`; "" where there is none.
std::string QueryValue(std::string_view target, std::string_view name);

struct HttpResponse {
  unsigned status = 200;
  const char* type = "";  // "text/html"
  std::string body;
};

HttpResponse ResponseOf(const Reply& reply);
HttpResponse ResponseOf(unsigned status, const std::string& error);

}  // namespace runtime
