#include "runtime/live/server/view_stream.h"

#include <optional>
#include <utility>

namespace runtime {
namespace {

constexpr size_t kMaxWord = 64;  // from the client, which says one word

class ViewStream final : public WebSocket, public Viewer {
 public:
  ViewStream(Service& service, Upgrade upgrade) : WebSocket(service, std::move(upgrade), kMaxWord) {
    service.views.Add(*this);
  }

  ViewWish wish() const override { return wish_; }

  void Take(const ViewFrame& frame) override {
    if (!(frame.is_episode ? wish_.episode : wish_.instants)) return;
    if (frame.is_episode) wish_.episode = false;
    next_ = frame;
    SendWhatThereIs();
  }

 private:
  // Any other word means that it wants nothing.
  void OnMessage(std::string_view word) override {
    wish_ = {.instants = word == "instants", .episode = word == "episode"};
    service_.views.Renew();
  }

  // What the numbers are comes before the first that are such.
  Message TakeNext() override {
    if (!next_) return {};
    if (next_->layout != known_layout_) return {known_layout_ = next_->layout};
    return {std::exchange(next_, std::nullopt)->content, true};
  }

  void OnClose() override { service_.views.Remove(*this); }

  ViewWish wish_;
  std::optional<ViewFrame> next_;  // the last one that was taken and not sent yet
  std::shared_ptr<const std::string> known_layout_;
};

}  // namespace

void ServeView(Service& service, Upgrade upgrade) {
  std::make_shared<ViewStream>(service, std::move(upgrade))->Start();
}

}  // namespace runtime
