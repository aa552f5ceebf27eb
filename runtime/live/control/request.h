// What a client asks of a running trainer, and what it is told.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "runtime/live/control/command.h"
#include "runtime/live/control/view_frame.h"

namespace runtime {

struct Request {
  std::string command;       // one of the handler's commands()
  nlohmann::json arguments;  // an object, checked by CheckArguments()
};

struct Reply {
  bool ok = true;
  nlohmann::json value = nullptr;  // of a request that was done
  std::string error = "";  // of one that was not: a message for the user, of one or more lines
};

// Called once for each request, on any thread.
using ReplyHandler = std::function<void(Reply)>;

class RequestHandler {
 public:
  virtual ~RequestHandler() = default;
  // What it takes: by default what the trainer of a run does (command_table.h).
  virtual std::span<const CommandSpec> commands() const;
  // Any thread; returns at once. What is asked for is done later, and then `reply` is called.
  virtual void Handle(Request request, ReplyHandler reply) = 0;
  // Any thread; returns at once. What is to be shown from now on (EventSink::Show()); an episode
  // that is wanted is shown once, when it is over.
  virtual void Watch(const ViewWish& /*wish*/) {}
};

// Where the trainer tells all clients that listen what happens: objects with a member `event`.
class EventSink {
 public:
  virtual ~EventSink() = default;
  // Any thread; returns at once. A client that does not keep up misses events.
  virtual void Publish(const nlohmann::json& event) = 0;
  // Any thread; returns at once. A client that does not keep up misses frames.
  virtual void Show(const ViewFrame& /*frame*/) {}
};

}  // namespace runtime
