#include "tests/runtime/live/server/raw_client.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>

namespace runtime {
namespace {

constexpr int kTimeout = 10'000;  // [ms]
constexpr std::string_view kHeaderEnd = "\r\n\r\n";
constexpr std::string_view kLength = "Content-Length: ";

size_t BodyLength(const std::string& header) {
  const size_t at = header.find(kLength);
  return at == std::string::npos ? 0 : std::stoul(header.substr(at + kLength.size()));
}

}  // namespace

RawClient RawClient::ToPort(int port) {
  Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    return RawClient({});
  }
  return RawClient(std::move(socket));
}

bool RawClient::Send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<size_t>(sent));
  }
  return true;
}

bool RawClient::SendText(std::string_view text) {
  // Masked by zeros, which leave it as it is.
  std::string frame = {'\x81', static_cast<char>(0x80 | text.size()), 0, 0, 0, 0};
  frame += text;
  return Send(frame);
}

std::string RawClient::ReceiveMessage() {
  std::string message;
  while (true) {
    const std::optional<Frame> frame = TakeFrame();
    if (!frame && !ReadMore()) return "";
    if (!frame || frame->is_ping) continue;
    message += frame->content;
    if (frame->is_last) return message;
  }
}

std::optional<RawClient::Frame> RawClient::TakeFrame() {
  const auto byte = [this](size_t i) -> size_t { return static_cast<unsigned char>(received_[i]); };
  if (received_.size() < 2) return std::nullopt;
  size_t length = byte(1);
  const size_t extra = length < 126 ? 0 : length == 126 ? 2 : 8;
  if (received_.size() < 2 + extra) return std::nullopt;
  if (extra > 0) length = 0;
  for (size_t i = 0; i < extra; ++i) length = length << 8 | byte(2 + i);
  if (received_.size() < 2 + extra + length) return std::nullopt;
  constexpr size_t kPing = 9;
  Frame frame{(byte(0) & 0xf) == kPing, (byte(0) & 0x80) != 0, received_.substr(2 + extra, length)};
  received_.erase(0, 2 + extra + length);
  return frame;
}

bool RawClient::ReadMore() {
  pollfd polled = {socket_.get(), POLLIN, 0};
  if (poll(&polled, 1, kTimeout) != 1) return false;
  std::array<char, 65536> bytes;
  const ssize_t size = recv(socket_.get(), bytes.data(), bytes.size(), 0);
  if (size <= 0) return false;
  received_.append(bytes.data(), static_cast<size_t>(size));
  return true;
}

RawResponse RawClient::Receive() {
  size_t end = 0;
  while ((end = received_.find(kHeaderEnd)) == std::string::npos) {
    if (!ReadMore()) return {};
  }
  RawResponse response;
  response.header = received_.substr(0, end);
  received_.erase(0, end + kHeaderEnd.size());
  const size_t length = BodyLength(response.header);
  while (received_.size() < length) {
    if (!ReadMore()) return {};
  }
  response.body = received_.substr(0, length);
  received_.erase(0, length);
  response.status = std::stoi(response.header.substr(response.header.find(' ')));
  return response;
}

bool RawClient::IsClosed() {
  pollfd polled = {socket_.get(), POLLIN, 0};
  std::array<char, 65536> bytes;
  while (poll(&polled, 1, kTimeout) == 1) {
    if (recv(socket_.get(), bytes.data(), bytes.size(), 0) <= 0) return true;
  }
  return false;
}

std::string RequestText(std::string_view method, std::string_view target, std::string_view header,
                        std::string_view body) {
  return fmt::format("{} {} HTTP/1.1\r\n{}{}{}\r\n\r\n{}", method, target, header, kLength,
                     body.size(), body);
}

}  // namespace runtime
