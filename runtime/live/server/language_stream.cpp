#include "runtime/live/server/language_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/write.hpp>
#include <charconv>
#include <deque>
#include <utility>

#include "runtime/live/server/http_error.h"

namespace runtime {
namespace {

namespace net = boost::asio;
using boost::system::error_code;

constexpr size_t kLongest = 1 << 20;      // a message of the client [bytes]
constexpr size_t kMostUnread = 16 << 20;  // for a program that does not read
constexpr size_t kMostWaiting = 64;       // messages for a client that does not read
constexpr std::string_view kLength = "Content-Length: ";
constexpr std::string_view kHeaderEnd = "\r\n\r\n";

// Takes the next whole message out of `text`; null where there is none yet.
std::shared_ptr<const std::string> TakeMessage(std::string& text) {
  const size_t header_end = text.find(kHeaderEnd);
  const size_t length_at = text.find(kLength);
  if (header_end == std::string::npos || length_at > header_end) return nullptr;
  size_t length = 0;
  std::from_chars(text.data() + length_at + kLength.size(), text.data() + header_end, length);
  const size_t begin = header_end + kHeaderEnd.size();
  if (text.size() - begin < length) return nullptr;
  auto message = std::make_shared<const std::string>(text, begin, length);
  text.erase(0, begin + length);
  return message;
}

class LanguageStream final : public WebSocket {
 public:
  LanguageStream(Service& service, Upgrade upgrade, std::unique_ptr<PipedProgram> program)
      : WebSocket(service, std::move(upgrade), kLongest),
        program_(std::move(program)),
        input_(service.io, program_->TakeInput()),
        output_(service.io, program_->TakeOutput()) {
    ++service.language_server_count;
  }

  void Begin() {
    Start();
    ReadProgram();
  }

 private:
  std::shared_ptr<LanguageStream> Self() {
    return std::static_pointer_cast<LanguageStream>(shared_from_this());
  }

  void OnMessage(std::string_view content) override {
    unread_.push_back(fmt::format("{}{}{}{}", kLength, content.size(), kHeaderEnd, content));
    unread_bytes_ += unread_.back().size();
    if (unread_bytes_ > kMostUnread) return Close();
    if (unread_.size() == 1) WriteNext();
  }

  void WriteNext() {
    net::async_write(input_, net::buffer(unread_.front()),
                     [self = Self()](error_code error, size_t) { self->OnWritten(error); });
  }

  void OnWritten(error_code error) {
    if (error) return Close();
    unread_bytes_ -= unread_.front().size();
    unread_.pop_front();
    if (!unread_.empty()) WriteNext();
  }

  // While the client has enough to read, the program has to wait.
  void ReadProgram() {
    if (is_reading_ || waiting_.size() >= kMostWaiting) return;
    is_reading_ = true;
    output_.async_read_some(net::buffer(piece_), [self = Self()](error_code error, size_t size) {
      self->is_reading_ = false;
      if (error) return self->Close();
      self->OnRead(size);
    });
  }

  void OnRead(size_t size) {
    text_.append(piece_.data(), size);
    while (auto message = TakeMessage(text_)) waiting_.push_back(std::move(message));
    SendWhatThereIs();
    ReadProgram();
  }

  Message TakeNext() override {
    if (waiting_.empty()) return {};
    Message message{std::move(waiting_.front())};
    waiting_.pop_front();
    ReadProgram();
    return message;
  }

  void OnClose() override {
    error_code ignored;
    input_.close(ignored);
    output_.close(ignored);
    if (!std::exchange(is_closed_, true)) --service_.language_server_count;
  }

  std::unique_ptr<PipedProgram> program_;
  net::posix::stream_descriptor input_;
  net::posix::stream_descriptor output_;
  std::deque<std::string> unread_;  // for the program; the first is being written
  size_t unread_bytes_ = 0;
  std::array<char, 16384> piece_;
  std::string text_;  // of the program, without the messages in it that were whole
  std::deque<std::shared_ptr<const std::string>> waiting_;  // for the client
  bool is_reading_ = false;
  bool is_closed_ = false;
};

}  // namespace

std::unique_ptr<PipedProgram> StartLanguageServer(const Service& service) {
  constexpr int kMost = 8;
  if (service.language_server.empty()) throw HttpError(404, "there is no language server here");
  if (service.language_server_count >= kMost) {
    throw HttpError(503, fmt::format("{} language servers are running already", kMost));
  }
  try {
    return std::make_unique<PipedProgram>(service.language_server);
  } catch (const UserError& error) {
    throw HttpError(500, error.what());
  }
}

void ServeLanguage(Service& service, Upgrade upgrade, std::unique_ptr<PipedProgram> program) {
  std::make_shared<LanguageStream>(service, std::move(upgrade), std::move(program))->Begin();
}

}  // namespace runtime
