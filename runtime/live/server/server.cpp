#include "runtime/live/server/server.h"

#include <fmt/format.h>
#include <signal.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <future>
#include <vector>

#include "runtime/live/server/control_file.h"
#include "runtime/live/server/control_socket.h"
#include "runtime/live/server/listener.h"
#include "runtime/live/server/loopback.h"
#include "runtime/live/server/service.h"

namespace runtime {
namespace {

namespace net = boost::asio;

// How long clients have, when the server ends, to take what is on its way to them.
constexpr std::chrono::milliseconds kFarewell{500};

// While it lives, new threads get no signals: these are for the trainer's own thread.
class NoSignals {
 public:
  NoSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

// A connection that closes leaves the service.
template <class Action>
void ForEachConnection(const Service& service, const Action& action) {
  std::vector<std::shared_ptr<Connection>> connections;
  for (const auto& [key, connection] : service.connections) connections.push_back(connection);
  for (const auto& connection : connections) action(*connection);
}

std::shared_ptr<Service> NewService(const ServerOptions& options, RequestHandler& handler,
                                    PageMaker page_maker, uint16_t port, const std::string& token) {
  const NoSignals no_signals;
  return std::make_shared<Service>(handler, std::move(page_maker), options.limits,
                                   Access(port, token), options.language_server);
}

}  // namespace

class Server::Implementation {
 public:
  Implementation(const ServerOptions& options, RequestHandler& handler, PageMaker page_maker)
      : folder_(OpenRunFolder(options.folder)),
        control_socket_(folder_, options.folder),
        loopback_(options.loopback >= 0 ? Descriptor(options.loopback)
                                        : ListenOnLoopback(options.port)),
        port_(PortOf(loopback_)),
        token_(NewToken()),
        control_file_(folder_, port_, token_),
        service_(NewService(options, handler, std::move(page_maker), port_, token_)),
        unix_listener_(*service_, control_socket_.TakeListener(), Transport::kUnixSocket),
        loopback_listener_(*service_, std::move(loopback_), Transport::kLoopback) {
    unix_listener_.Accept();
    loopback_listener_.Accept();
    const NoSignals no_signals;
    thread_ = std::async(std::launch::async, [this] { service_->io.run(); });
  }

  ~Implementation() {
    net::post(service_->io, [this] { End(); });
    if (thread_.wait_for(kFarewell) != std::future_status::ready) {
      net::post(service_->io, [this] { Close(); });
    }
    thread_.get();
    service_->pages.join();
  }

  void Publish(const nlohmann::json& event) {
    EventHub& events = service_->events;
    if (!events.has_listeners()) return;
    const bool must_deliver = events.Publish(std::make_shared<std::string>(
        event.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
    if (must_deliver) net::post(service_->io, [&events] { events.Deliver(); });
  }

  void Show(const ViewFrame& frame) {
    ViewHub& views = service_->views;
    if (views.Put(frame)) net::post(service_->io, [&views] { views.Deliver(); });
  }

  std::string page_address() const {
    return fmt::format("http://127.0.0.1:{}/?token={}", port_, token_);
  }

 private:
  // The io thread ends when nothing is left for it to do.
  void End() {
    service_->is_ending = true;
    unix_listener_.Close();
    loopback_listener_.Close();
    ForEachConnection(*service_, [](Connection& connection) { connection.End(); });
  }

  void Close() {
    ForEachConnection(*service_, [](Connection& connection) { connection.Close(); });
  }

  const Descriptor folder_;
  ControlSocket control_socket_;
  Descriptor loopback_;
  const uint16_t port_;
  const std::string token_;
  const ControlFile control_file_;
  const std::shared_ptr<Service> service_;
  Listener unix_listener_;
  Listener loopback_listener_;
  std::future<void> thread_;
};

Server::Server(const ServerOptions& options, RequestHandler& handler, PageMaker page_maker)
    : implementation_(std::make_unique<Implementation>(options, handler, std::move(page_maker))) {}

Server::~Server() = default;

void Server::Publish(const nlohmann::json& event) { implementation_->Publish(event); }

void Server::Show(const ViewFrame& frame) { implementation_->Show(frame); }

std::string Server::page_address() const { return implementation_->page_address(); }

}  // namespace runtime
