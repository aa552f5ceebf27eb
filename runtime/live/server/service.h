// What all connections of a server share. Except where it says otherwise it is used on the io
// thread only.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/thread_pool.hpp>
#include <memory>
#include <unordered_map>

#include "runtime/live/control/request.h"
#include "runtime/live/server/access.h"
#include "runtime/live/server/event_queue.h"
#include "runtime/live/server/server.h"
#include "runtime/live/server/view_hub.h"

namespace runtime {

// A client. It lives for as long as it is among the connections of the service, or waits for the
// graph.
class Connection {
 public:
  virtual ~Connection() = default;
  // Closes as soon as what is on its way to the client is sent.
  virtual void End() = 0;
  virtual void Close() = 0;
};

struct Service : std::enable_shared_from_this<Service> {
  Service(RequestHandler& handler_, PageMaker page_maker_, const ServerLimits& limits_,
          Access access_, std::vector<std::string> language_server_)
      : handler(handler_),
        page_maker(std::move(page_maker_)),
        limits(limits_),
        access(std::move(access_)),
        language_server(std::move(language_server_)),
        events(limits_.waiting_events),
        views(handler_) {}

  RequestHandler& handler;
  const PageMaker page_maker;  // called on the thread of `pages`
  const ServerLimits limits;
  const Access access;
  const std::vector<std::string> language_server;  // empty: there is none
  int language_server_count = 0;                   // that run
  boost::asio::io_context io{1};
  boost::asio::thread_pool pages{1};
  EventHub events;
  ViewHub views;
  bool is_ending = false;
  std::unordered_map<Connection*, std::shared_ptr<Connection>> connections;
};

}  // namespace runtime
