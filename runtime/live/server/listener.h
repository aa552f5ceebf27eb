#pragma once

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>

#include "runtime/live/server/http_connection.h"
#include "runtime/live/server/service.h"

namespace runtime {

// Takes the clients that come to a socket, as many at a time as the limits allow. Used on the io
// thread only.
class Listener {
 public:
  Listener(Service& service, Descriptor socket, Transport transport);

  void Accept();
  void Close();

 private:
  void AcceptAll();
  void TryAgainLater();
  void Take(Descriptor client);

  Service& service_;
  boost::asio::posix::stream_descriptor socket_;
  boost::asio::steady_timer pause_;
  Transport transport_;
  std::shared_ptr<void> slots_ = std::make_shared<char>();  // every connection holds a copy
};

}  // namespace runtime
