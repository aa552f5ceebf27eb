// What an HTTP request asks for, and how the answer is written.
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "runtime/live/control/request.h"

namespace runtime {

// The parts of an HTTP request that decide what is done.
struct Call {
  std::string_view method;  // "POST"
  std::string_view target;  // "/api/get?name=task.gain"
  std::string_view body;    // JSON object of arguments; "": none
};

struct PageWish {};    // the run's report page
struct EventsWish {};  // a stream of events
using Wish = std::variant<PageWish, EventsWish, Request>;

// The arguments of a Request are checked. Throws HttpError.
Wish ReadCall(const Call& call);

// The value of `name` in the query of `target`; "" where there is none.
std::string QueryValue(std::string_view target, std::string_view name);

struct Answer {
  unsigned status = 200;
  const char* type = "";  // "text/html"
  std::string body;
};

Answer AnswerOf(const Reply& reply);
Answer AnswerOf(unsigned status, const std::string& error);

}  // namespace runtime
