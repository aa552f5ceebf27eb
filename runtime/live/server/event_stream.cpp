#include "runtime/live/server/event_stream.h"

#include <utility>

namespace runtime {
namespace {

constexpr size_t kMaxMessage = 4096;  // from the client, which has nothing to say

class EventStream final : public WebSocket, public EventListener {
 public:
  EventStream(Service& service, Upgrade upgrade)
      : WebSocket(service, std::move(upgrade), kMaxMessage),
        events_(service.limits.waiting_events) {
    // Events of this moment count already; they are sent when the client has been accepted.
    service.events.Add(*this);
  }

  void Take(const EventText& event) override {
    events_.Push(event);
    SendWhatThereIs();
  }

 private:
  Message TakeNext() override { return {events_.Pop()}; }
  void OnClose() override { service_.events.Remove(*this); }

  EventQueue events_;
};

}  // namespace

void ServeEvents(Service& service, Upgrade upgrade) {
  std::make_shared<EventStream>(service, std::move(upgrade))->Start();
}

}  // namespace runtime
